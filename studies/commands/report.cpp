#include "analysis/report.hpp"

#include <fmt/format.h>

#include <brouwer/store/whole_file.hpp>

#include "studies/commands/commands.hpp"
#include "studies/commands/findings.hpp"
#include "studies/commands/run_study.hpp"

namespace brouwer {
namespace {

ReportContent what_was_asked(StudyFile const& file, Catalogue const& catalogue) {
  ReportContent content;
  content.title = file.study.name;
  content.question = file.study.question;
  content.source = file.study.source;
  content.run = run_entries(file, catalogue);
  content.unjudged = file.unjudged;
  content.study_text = file.text;
  return content;
}

void add_figures(ReportContent& content, Findings const& findings, std::filesystem::path const& folder) {
  auto const figures = draw_all(findings, folder, "svg");
  content.figures = report_figures(figures);
  content.note = figures.note;
}

}  // namespace

int report(ReportCommand const& command, Catalogue const& catalogue) {
  std::filesystem::path const folder = command.result;
  Findings const findings({command.result}, command.levels);
  StudyFile const file = read_stored_study(folder, catalogue);
  ReportContent content = what_was_asked(file, catalogue);
  content.estimates = findings.rows();
  content.outcomes = findings.check(file.expectations);
  content.provenance = read_whole(folder / "provenance.txt");
  add_figures(content, findings, folder / "figures");
  std::filesystem::path const page =
      command.file.empty() ? folder / "report.html" : std::filesystem::path(command.file);
  write_whole(page, render_report(content));
  fmt::print(stderr, "report in {}\n", page.string());
  return done;
}

}  // namespace brouwer
