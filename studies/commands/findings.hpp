#pragma once
#include <brouwer/store/results.hpp>
#include <string>
#include <vector>

#include "analysis/expectations.hpp"

namespace brouwer {

/// What the inference says of result folders: a row for each quantity of each cell. One ensemble is in memory at a
/// time; figures and sweeps read those that they need again.
class Findings {
 public:
  /// Reads and analyses everything that is finished. @throws InputError, RunError as Results does
  Findings(std::vector<std::string> const& folders, Levels const& levels);

  std::vector<Estimates> const& rows() const { return rows_; }
  Ensemble ensemble(std::size_t row) const;

  std::vector<Outcome> check(std::vector<Expectation> const& expectations) const;

 private:
  struct Place {
    std::size_t results, cell;
  };
  void analyse(std::size_t results);

  Levels levels_;
  std::vector<Results> results_;
  std::vector<Estimates> rows_;
  std::vector<Place> places_;  // of each row
};

/// Rows, verdicts and outcomes on standard output, for people.
void print_findings(Findings const& findings);
void print_outcomes(std::vector<Outcome> const& outcomes, std::vector<std::string> const& unjudged);

/// `done` where all have passed, otherwise `expectation_failed`.
int exit_status(std::vector<Outcome> const& outcomes);

}  // namespace brouwer
