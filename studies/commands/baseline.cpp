#include "analysis/baseline/baseline.hpp"

#include <fmt/format.h>

#include <brouwer/error.hpp>
#include <brouwer/store/whole_file.hpp>

#include "analysis/baseline/baseline_table.hpp"
#include "studies/commands/commands.hpp"
#include "studies/commands/recording.hpp"
#include "studies/commands/run_study.hpp"

namespace brouwer {
namespace {

namespace fs = std::filesystem;

/// Either a list is asked for, or a recording, which needs what and where.
void check_usage(BaselineCommand const& command) {
  bool const lists = !command.list.empty();
  if (lists && !command.subject.empty())
    throw InputError("--list shows a file, and records nothing; leave out either it or the study");
  if (!lists && command.subject.empty())
    throw InputError("expected a study or a folder of results to record, or --list FILE");
  if (!lists && command.file.empty()) throw InputError("expected -o FILE.json, where the baseline is kept");
}

void require_finished(Findings const& findings) {
  if (auto const part = findings.unfinished(); !part.empty())
    throw InputError(
        fmt::format("{}: a baseline of a part would be compared with the whole; run the study again", part));
}

Baseline known_or_new(fs::path const& file, std::string const& study) {
  return fs::exists(file) ? read_baseline(file) : Baseline{study, {}};
}

/// A whole file, in a folder that is made where there is none.
void write(fs::path const& file, Baseline const& baseline) {
  std::error_code failed;
  if (file.has_parent_path()) fs::create_directories(file.parent_path(), failed);
  if (failed) throw InputError(fmt::format("{}: {}", file.parent_path().string(), failed.message()));
  write_whole(file, to_json(baseline));
}

void say(bool is_new, BaselineEntry const& entry, fs::path const& file) {
  fmt::print("{} '{}' in {}: {} {}\n", is_new ? "Recorded" : "Already recorded, bit for bit, as", entry.label,
             file.string(), entry.rows.size(), entry.rows.size() == 1 ? "row" : "rows");
}

}  // namespace

int baseline(BaselineCommand const& command, Catalogue const& catalogue) {
  check_usage(command);
  if (!command.list.empty()) {
    fmt::print("{}", history_table(read_baseline(command.list)));
    return done;
  }
  StudyFile const study = read_subject(command.subject, command.settings, catalogue);
  auto history = known_or_new(command.file, study.study.name);  // before a run, which may be long
  auto const folder = results_of(study, command.subject, command.settings, catalogue);
  if (!folder) return interrupted;
  Findings const findings({folder->string()}, command.settings.levels);
  require_finished(findings);
  BaselineEntry entry = recorded(findings, *folder);
  entry.label = command.label.empty() ? default_label(command.subject) : command.label;
  entry.date = command.date;
  bool const is_new = append(history, entry);
  if (is_new) write(command.file, history);
  say(is_new, entry, command.file);
  return done;
}

}  // namespace brouwer
