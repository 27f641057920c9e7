#include <fmt/format.h>

#include <brouwer/error.hpp>
#include <brouwer/spelling.hpp>
#include <brouwer/store/folder.hpp>

#include "analysis/factors.hpp"
#include "analysis/numbers.hpp"
#include "analysis/probe/probe_table.hpp"
#include "studies/commands/calibration.hpp"
#include "studies/commands/commands.hpp"
#include "studies/commands/findings.hpp"
#include "studies/commands/probe_cell.hpp"
#include "studies/commands/run_study.hpp"

namespace brouwer {
namespace {

namespace fs = std::filesystem;

bool as_json(std::string const& format) {
  if (format != "text" && format != "json")
    throw InputError(fmt::format("a probe has no format '{}'{}", format, suggestion(format, {"text", "json"})));
  return format == "json";
}

/// The estimates of what has been run of this study; nothing where nothing has. Another study's results are refused where
/// they were asked for, and told where they lie in the usual place.
std::vector<Estimates> observed_in(fs::path const& folder, StudyFile const& file, RunSettings const& settings) {
  if (!fs::exists(folder / "plan.txt")) {
    if (settings.folder.empty()) return {};
    throw InputError(
        fmt::format("{}: no results of {} there; brouwer probe --run makes them", folder.string(), file.study.name));
  }
  if (auto const other = difference_to(folder, study_hash(file.study), canonical_text(file.study))) {
    if (!settings.folder.empty()) throw InputError(fmt::format("{}: {}", folder.string(), *other));
    fmt::print(stderr, "brouwer: {} is of another study and not compared ({})\n", folder.string(), *other);
    return {};
  }
  Results const results(folder);
  for (std::size_t cell = 0; cell < results.cells(); ++cell)
    if (results.finished_members(cell) > 0) return Findings({folder.string()}, settings.levels).rows();
  return {};
}

std::vector<ProbedRow> rows_of(Probe const& probed, std::vector<Estimates> const& observed, Levels const& levels) {
  std::vector<ProbedRow> rows;
  for (auto const& errors : probed.errors) {
    if (errors.rounding.rows() < 2) {
      fmt::print(stderr, "brouwer: {}, {}: {} of {} members failed in the probe\n", describe(errors.cell),
                 errors.quantity, errors.failed, errors.failed + errors.rounding.rows());
      continue;
    }
    ProbedRow row{estimate(errors, levels), {}, {}};
    row.prediction = predict(row.local, errors.cell.steps);
    for (auto const& estimates : observed)
      if (estimates.cell == errors.cell && estimates.quantity == errors.quantity) row.observed = estimates;
    rows.push_back(std::move(row));
  }
  return rows;
}

/// "64 members, 8 windows of 64 steps in the first 8192 of 50000; double-double; 0.035 s, 4 % of the run's 0.81 s"
void print_head(CellLabels const& cell, Probe const& probed, double run_seconds) {
  fmt::print("\n{}\n", describe(cell));
  auto const& design = probed.design;
  bool const all = probed.errors.empty() || probed.errors.front().judged == design.length;
  fmt::print(
      "  {} members, {} windows of {} steps in the first {} of {}; {} of each window made in {}, too; {:.2g} s, "
      "{} % of the run's {:.2g} s\n",
      design.members, design.windows, design.length, design.covered, cell.steps, all ? "all" : "the first",
      probed.errors.empty() ? "" : probed.errors.front().high_precision, probed.seconds,
      number(100 * probed.seconds / run_seconds, 2), run_seconds);
}

void print_legend(Levels const& levels) {
  fmt::print(
      "\nErrors of one step, in the unit of the quantity; ρ₁ is the correlation of consecutive ones. ± is the half of "
      "a "
      "{:g} % interval.\nAgrees: the difference is one that chance exceeds more often than {:g}. Seconds are of one "
      "processor.\n",
      100 * levels.confidence, levels.test);
}

}  // namespace

int probe(ProbeCommand const& command, Catalogue const& catalogue) {
  bool const json = as_json(command.format);
  RunSettings const& settings = command.settings;
  RunOptions const options = run_options(settings);
  StudyFile const file = read_study(command.study, catalogue, settings.overrides);
  auto const folder = result_folder(file, settings);
  if (command.run && !run_missing(file, catalogue, folder, options)) return interrupted;
  auto const observed = observed_in(folder, file, settings);
  std::vector<ProbedRow> all;
  for (auto const& cell : file.plan.cells) {
    if (auto const reason = reason_not_to_probe(file.study, catalogue, cell, command.design); !reason.empty()) {
      fmt::print(stderr, "brouwer: {}\n", reason);
      continue;
    }
    Probe const probed = probe_cell(file.study, catalogue, cell, command.design, options, settings.levels);
    auto const rows = rows_of(probed, observed, settings.levels);
    all.insert(all.end(), rows.begin(), rows.end());
    if (json) continue;
    print_head(cell, probed, calibrate(file.study, catalogue, cell, options).seconds(file.study, cell));
    fmt::print("{}", probe_text(rows));
    std::fflush(stdout);
  }
  if (all.empty()) throw InputError(fmt::format("{}: there is nothing to probe", command.study));
  json ? fmt::print("{}", probe_json(all)) : print_legend(settings.levels);
  return done;
}

}  // namespace brouwer
