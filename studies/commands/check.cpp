#include <fmt/format.h>

#include <brouwer/error.hpp>
#include <brouwer/store/whole_file.hpp>
#include <numeric>

#include "analysis/baseline/compare_baseline.hpp"
#include "analysis/baseline/study_change.hpp"
#include "analysis/expectations/junit.hpp"
#include "studies/commands/commands.hpp"
#include "studies/commands/findings.hpp"
#include "studies/commands/recording.hpp"
#include "studies/commands/run_study.hpp"

namespace brouwer {
namespace {

void refuse_nothing_to_check(StudyFile const& file, CheckCommand const& command) {
  if (command.baseline.empty() && !command.entry.empty())
    throw InputError("--entry names an entry of a baseline; give its file with --baseline FILE");
  if (!file.expectations.empty() || !command.baseline.empty()) return;
  std::string const why = file.unjudged.empty() ? "it has no [[expect]]" : file.unjudged.front();
  throw InputError(fmt::format("{}: there is nothing to check: {}", file.path.string(), why));
}

/// The recorded entry, if a baseline was named. Before a run, which may be long.
std::optional<BaselineEntry> recorded_entry(CheckCommand const& command) {
  if (command.baseline.empty()) return std::nullopt;
  return read_baseline(command.baseline).entry(command.entry);
}

/// The rows that are judged: those that are expected something of, all where they are compared with a baseline.
std::vector<std::size_t> judged_rows(Findings const& findings, StudyFile const& file, bool all) {
  if (!all) return findings.rows_of(file.expectations);
  std::vector<std::size_t> rows(findings.rows().size());
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  return rows;
}

std::vector<Outcome> against(BaselineEntry const& entry, Findings const& findings, std::filesystem::path const& folder,
                             Levels const& levels) {
  auto const now = recorded(findings, folder);
  auto outcomes = compare(entry, now, levels);
  if (auto const changes = harmless_changes(entry.study, now.study); !changes.empty())
    fmt::print(stderr, "brouwer: the baseline's study is not quite this one: {}\n", changes);
  return outcomes;
}

void append(std::vector<Outcome>& all, std::vector<Outcome> more) {
  std::move(more.begin(), more.end(), std::back_inserter(all));
}

}  // namespace

int check(CheckCommand const& command, Catalogue const& catalogue) {
  StudyFile const file = read_subject(command.subject, command.settings, catalogue);
  refuse_nothing_to_check(file, command);
  auto const entry = recorded_entry(command);
  auto const folder = results_of(file, command.subject, command.settings, catalogue);
  if (!folder) return interrupted;
  Levels const levels = levels_of(file, command.settings);
  Findings const findings({folder->string()}, levels);
  auto outcomes = findings.expected(file.expectations);
  append(outcomes, findings.guards(judged_rows(findings, file, entry.has_value())));
  if (entry) append(outcomes, against(*entry, findings, *folder, levels));
  print_outcomes(outcomes, file.unjudged);
  if (!command.junit.empty()) write_whole(command.junit, to_junit(file.study.name, outcomes));
  return exit_status(outcomes);
}

}  // namespace brouwer
