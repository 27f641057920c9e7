#include "analysis/pages/report.hpp"

#include <fmt/format.h>

#include <brouwer/error.hpp>
#include <brouwer/store/whole_file.hpp>

#include "analysis/pages/page.hpp"
#include "studies/commands/commands.hpp"
#include "studies/commands/findings.hpp"
#include "studies/commands/report_markdown.hpp"
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

void add_figures(ReportContent& content, Findings const& findings, Catalogue const& catalogue,
                 std::filesystem::path const& folder) {
  auto const figures = draw_all(findings, catalogue, folder, "svg");
  content.figures = report_figures(figures);
  content.note = figures.note;
}

void write_html(std::filesystem::path const& folder, std::filesystem::path const& page, Levels const& levels,
                Catalogue const& catalogue) {
  Findings const findings({folder.string()}, levels);
  StudyFile const file = read_stored_study(folder, catalogue);
  ReportContent content = what_was_asked(file, catalogue);
  content.unfinished = findings.unfinished();
  content.estimates = findings.rows();
  content.outcomes = findings.check(file.expectations);
  content.provenance = read_whole(folder / "provenance.txt");
  add_figures(content, findings, catalogue, folder / "figures");
  write_whole(page, render_report(content));
}

}  // namespace

int report(ReportCommand const& command, Catalogue const& catalogue) {
  std::filesystem::path const first = command.results.front();
  auto const page = command.file.empty() ? first / "report.html" : std::filesystem::path(command.file);
  if (page_format(page) == PageFormat::markdown) {
    write_markdown({command.results.begin(), command.results.end()}, page, command.levels, catalogue);
  } else {
    if (command.results.size() > 1)
      throw InputError(
          fmt::format("{} is to be HTML, a page of one result; for {} results name a page that ends in .md",
                      page.string(), command.results.size()));
    write_html(first, page, command.levels, catalogue);
  }
  fmt::print(stderr, "report in {}\n", page.string());
  return done;
}

}  // namespace brouwer
