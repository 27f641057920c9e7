#pragma once
#include <brouwer/ensemble/catalogue.hpp>
#include <brouwer/store/results.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "analysis/expectations/expectations.hpp"
#include "analysis/figures/cloud.hpp"
#include "analysis/figures/plots.hpp"

namespace brouwer {

/// What the inference says of result folders: a row for each quantity of each cell. One ensemble is in memory at a
/// time; figures and sweeps read those that they need again.
class Findings {
 public:
  /// Reads and analyses everything that is finished. The drifts are corrected for one another as levels.correction
  /// says, all of them at once; where it is unset, those of each folder as its study says. @throws InputError, RunError as Results does
  Findings(std::vector<std::string> const& folders, Levels const& levels);

  std::vector<Estimates> const& rows() const { return rows_; }
  /// Of each row, the members' errors at the last sample.
  std::vector<std::vector<double>> const& final_errors() const { return final_errors_; }
  /// Of each row, the CPU seconds that a member took; NaN where not recorded.
  std::vector<double> const& cpu_seconds() const { return cpu_seconds_; }
  Ensemble ensemble(std::size_t row) const;
  /// Of each cell, where its members were; without members where the study did not ask for states.
  std::vector<Orbits> orbits() const;

  /// "unfinished: 900 of 4200 members in 14 cells"; "" where every planned member is there.
  std::string unfinished() const;

  /// What becomes of the expectations.
  std::vector<Outcome> expected(std::vector<Expectation> const& expectations) const;
  /// The same, and those guards that fail in cells on which they rest.
  std::vector<Outcome> check(std::vector<Expectation> const& expectations) const;
  /// All guards of the cells of these rows (indices), also those that hold.
  std::vector<Outcome> guards(std::vector<std::size_t> const& rows) const;
  /// The rows that these expectations speak of.
  std::vector<std::size_t> rows_of(std::vector<Expectation> const& expectations) const;

 private:
  struct Place {
    std::size_t results, cell;
  };
  void analyse(std::size_t results);
  Correction correction_of(std::size_t results) const;

  Levels levels_;
  std::vector<Results> results_;
  std::vector<Estimates> rows_;
  std::vector<Place> places_;  // of each row
  std::vector<std::vector<double>> final_errors_;
  std::vector<double> cpu_seconds_;
};

std::vector<double> final_errors_of(Ensemble const& ensemble);

/// The verdict of each row, a sentence each, and the outcomes, on standard output.
void print_verdicts(std::vector<Estimates> const& rows);
void print_outcomes(std::vector<Outcome> const& outcomes, std::vector<std::string> const& unjudged);

/// All figures of results: of each quantity, and of the clouds in phase space where states were kept.
/// @param plane  of the clouds; where not given, that of their system's description
/// @throws InputError, before anything is drawn, for a plane that the states do not have
Figures draw_all(Findings const& findings, Catalogue const& catalogue, std::filesystem::path const& folder,
                 std::string const& format, std::optional<Plane> const& plane = {});

/// How many figures are where, and why not all, on standard error.
void say(Figures const& figures, std::filesystem::path const& folder);

/// Draws the figures and says so.
void draw_and_say(Findings const& findings, Catalogue const& catalogue, std::filesystem::path const& folder,
                  std::string const& format, std::optional<Plane> const& plane = {});
void draw_and_say(std::vector<Estimates> const& rows, std::vector<std::vector<double>> const& final_errors,
                  std::filesystem::path const& folder, std::string const& format);

/// `done` where all have passed, otherwise `expectation_failed`.
int exit_status(std::vector<Outcome> const& outcomes);

}  // namespace brouwer
