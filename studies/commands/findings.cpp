#include "studies/commands/findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <brouwer/error.hpp>
#include <map>

#include "analysis/expectations/correct.hpp"
#include "analysis/expectations/guards.hpp"
#include "analysis/factors.hpp"
#include "analysis/growth/inference.hpp"
#include "analysis/growth/sweep.hpp"
#include "analysis/increments/increments_objection.hpp"
#include "analysis/verdict/failures.hpp"
#include "studies/commands/commands.hpp"
#include "studies/reading/tests_section.hpp"

namespace brouwer {
namespace {

std::string unfinished_part(Results const& results) {
  std::int64_t finished = 0;
  for (std::size_t cell = 0; cell < results.cells(); ++cell) finished += results.finished_members(cell);
  return unfinished_in_words(finished, results.planned_members(), results.cells());
}

/// A part of a result is not to pass for the whole.
void say_if_unfinished(Results const& results) {
  if (auto const part = unfinished_part(results); !part.empty())
    fmt::print(stderr, "brouwer: {} is {}; run the study again to complete it\n", results.folder().string(), part);
}

}  // namespace

std::vector<double> final_errors_of(Ensemble const& ensemble) {
  std::vector<double> last;
  for (Eigen::Index member = 0; member < ensemble.errors.rows(); ++member)
    last.push_back(ensemble.errors(member, ensemble.errors.cols() - 1));
  return last;
}

Findings::Findings(std::vector<std::string> const& folders, Levels const& levels) : levels_(levels) {
  for (auto const& folder : folders) results_.emplace_back(folder);
  for (std::size_t i = 0; i < results_.size(); ++i) analyse(i);
  if (rows_.empty()) throw InputError(fmt::format("{}: no unit is finished yet", fmt::join(folders, ", ")));
  if (levels_.correction) correct(rows_, *levels_.correction);
}

Correction Findings::correction_of(std::size_t results) const {
  auto const asked = levels_.correction ? levels_.correction : correction_in(results_[results].study_text());
  return asked.value_or(Correction::none);
}

void Findings::analyse(std::size_t results) {
  Results const& stored = results_[results];
  say_if_unfinished(stored);
  auto const before = rows_.size();
  for (std::size_t cell = 0; cell < stored.cells(); ++cell) {
    if (stored.finished_members(cell) == 0) continue;
    double const seconds = stored.seconds_per_member(cell);
    for (auto const& quantity : stored.quantities(cell)) {
      Ensemble const ensemble = stored.load(cell, quantity);
      rows_.push_back(estimate(ensemble, levels_));
      places_.push_back({results, cell});
      final_errors_.push_back(final_errors_of(ensemble));
      cpu_seconds_.push_back(seconds);
    }
  }
  if (!levels_.correction) correct(std::span(rows_).subspan(before), correction_of(results));
}

Ensemble Findings::ensemble(std::size_t row) const {
  return results_[places_[row].results].load(places_[row].cell, rows_[row].quantity);
}

std::vector<Orbits> Findings::orbits() const {
  std::vector<Orbits> all;
  for (auto const& results : results_)
    for (std::size_t cell = 0; cell < results.cells(); ++cell) all.push_back(results.orbits(cell));
  return all;
}

std::string Findings::unfinished() const {
  std::vector<std::string> parts;
  for (auto const& results : results_)
    if (auto const part = unfinished_part(results); !part.empty()) parts.push_back(part);
  return fmt::format("{}", fmt::join(parts, "; "));
}

std::vector<Outcome> Findings::expected(std::vector<Expectation> const& expectations) const {
  auto const sweep = [this](std::vector<std::size_t> const& rows) {
    std::vector<Ensemble> cells;
    for (auto row : rows) cells.push_back(ensemble(row));
    return fit_sweep(cells, levels_);
  };
  return brouwer::check(expectations, rows_, sweep, correction_of(0));
}

std::vector<Outcome> Findings::check(std::vector<Expectation> const& expectations) const {
  auto outcomes = expected(expectations);
  for (auto& guard : guards(rows_of(expectations)))
    if (!guard.passed) outcomes.push_back(std::move(guard));
  return outcomes;
}

std::vector<std::size_t> Findings::rows_of(std::vector<Expectation> const& expectations) const {
  std::vector<std::size_t> found;
  for (std::size_t row = 0; row < rows_.size(); ++row)
    if (std::any_of(expectations.begin(), expectations.end(), [&](auto const& e) { return speaks_of(e, rows_[row]); }))
      found.push_back(row);
  return found;
}

std::vector<Outcome> Findings::guards(std::vector<std::size_t> const& rows) const {
  std::map<std::pair<std::size_t, std::size_t>, GuardedCell> cells;
  for (auto const row : rows) {
    auto& cell = cells[{places_[row].results, places_[row].cell}];
    if (cell.rows.empty()) cell = {rows_[row].cell, results_[places_[row].results].ends(places_[row].cell), {}};
    cell.rows.push_back(rows_[row]);
  }
  std::vector<GuardedCell> guarded;
  for (auto& [place, cell] : cells) guarded.push_back(std::move(cell));
  return check_guards(guarded);
}

void print_verdicts(std::vector<Estimates> const& rows) {
  auto const varying = varying_factors(cells_of(rows));
  fmt::print("\n");
  for (auto const& row : rows) {
    auto const objection = increments_objection(row);
    fmt::print("{}, {}: {}{}{}\n", row.quantity, short_label(row.cell, varying), row.sentence,
               objection.empty() ? "" : " ", objection);
  }
}

void print_outcomes(std::vector<Outcome> const& outcomes, std::vector<std::string> const& unjudged) {
  if (outcomes.empty() && unjudged.empty()) return;
  fmt::print("\nExpectations\n");
  for (auto const& outcome : outcomes)
    fmt::print("  {}  {}\n        found {}\n", outcome.passed ? "PASS" : "FAIL", outcome.claim, outcome.found);
  for (auto const& sentence : unjudged) fmt::print("  not judged: {}\n", sentence);
}

/// What the description of the first cell's system says; nothing for a system that this catalogue does not have.
std::optional<Plane> usual_plane(Findings const& findings, Catalogue const& catalogue) {
  for (auto const& system : catalogue.systems)
    if (system.name == findings.rows().front().cell.system)
      return Plane{system.state_components.at(system.plane[0]), system.state_components.at(system.plane[1])};
  return std::nullopt;
}

Figures draw_all(Findings const& findings, Catalogue const& catalogue, std::filesystem::path const& folder,
                 std::string const& format, std::optional<Plane> const& plane) {
  auto const orbits = findings.orbits();
  if (plane) check_plane(orbits, *plane);
  auto figures = draw_figures(findings.rows(), findings.final_errors(), folder, format, findings.cpu_seconds());
  auto const clouds = draw_clouds(orbits, folder, plane ? plane : usual_plane(findings, catalogue), format);
  figures.files.insert(figures.files.end(), clouds.files.begin(), clouds.files.end());
  figures.note = joined_notes(figures.note, clouds.note);
  return figures;
}

void say(Figures const& figures, std::filesystem::path const& folder) {
  fmt::print(stderr, "{} figures in {}\n", figures.files.size(), folder.string());
  if (!figures.note.empty()) fmt::print(stderr, "brouwer: {}\n", figures.note);
}

void draw_and_say(Findings const& findings, Catalogue const& catalogue, std::filesystem::path const& folder,
                  std::string const& format, std::optional<Plane> const& plane) {
  say(draw_all(findings, catalogue, folder, format, plane), folder);
}

void draw_and_say(std::vector<Estimates> const& rows, std::vector<std::vector<double>> const& final_errors,
                  std::filesystem::path const& folder, std::string const& format) {
  say(draw_figures(rows, final_errors, folder, format), folder);
}

int exit_status(std::vector<Outcome> const& outcomes) {
  bool const all = std::all_of(outcomes.begin(), outcomes.end(), [](Outcome const& outcome) { return outcome.passed; });
  return all ? done : expectation_failed;
}

}  // namespace brouwer
