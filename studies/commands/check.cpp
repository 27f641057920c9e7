#include <fmt/format.h>

#include <brouwer/error.hpp>
#include <brouwer/store/whole_file.hpp>

#include "analysis/junit.hpp"
#include "studies/commands/commands.hpp"
#include "studies/commands/findings.hpp"
#include "studies/commands/run_study.hpp"

namespace brouwer {
namespace {

/// A study file is run as far as it is missing; a folder is judged as it is. Nothing: interrupted.
std::optional<std::filesystem::path> results_of(StudyFile const& file, CheckCommand const& command,
                                                Catalogue const& catalogue) {
  RunOptions const options = run_options(command.settings);
  auto const folder = result_folder(file, command.settings);
  print_study(file, catalogue, folder);
  return run_missing(file, catalogue, folder, options) ? std::optional(folder) : std::nullopt;
}

void refuse_nothing_to_check(StudyFile const& file) {
  if (!file.expectations.empty()) return;
  std::string const why = file.unjudged.empty() ? "it has no [[expect]]" : file.unjudged.front();
  throw InputError(fmt::format("{}: there is nothing to check: {}", file.path.string(), why));
}

void refuse_run_settings(RunSettings const& settings) {
  if (!settings.overrides.empty() || !settings.folder.empty())
    throw InputError(
        "--output, --members, --steps and --set belong to a study file; a folder of results is judged as it is");
}

}  // namespace

int check(CheckCommand const& command, Catalogue const& catalogue) {
  bool const stored = std::filesystem::is_directory(command.subject);
  if (stored) refuse_run_settings(command.settings);
  StudyFile const file = stored ? read_stored_study(command.subject, catalogue)
                                : read_study(command.subject, catalogue, command.settings.overrides);
  refuse_nothing_to_check(file);
  auto const folder = stored ? std::filesystem::path(command.subject) : results_of(file, command, catalogue);
  if (!folder) return interrupted;
  auto const outcomes = Findings({folder->string()}, levels_of(file, command.settings)).check(file.expectations);
  print_outcomes(outcomes, file.unjudged);
  if (!command.junit.empty()) write_whole(command.junit, to_junit(file.study.name, outcomes));
  return exit_status(outcomes);
}

}  // namespace brouwer
