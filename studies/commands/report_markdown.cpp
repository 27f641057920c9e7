#include "studies/commands/report_markdown.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <brouwer/store/whole_file.hpp>
#include <set>

#include "analysis/escape.hpp"
#include "analysis/figures/main_figures.hpp"
#include "analysis/pages/page.hpp"
#include "analysis/pages/report.hpp"
#include "studies/commands/findings.hpp"
#include "studies/read.hpp"

namespace brouwer {
namespace {

namespace fs = std::filesystem;

/// A section, and where its figures lie before they are put beside the page.
struct Draft {
  PageSection section;
  std::vector<fs::path> figures;
};

Draft draft_of(fs::path const& folder, Levels const& levels, Catalogue const& catalogue) {
  Findings const findings({folder.string()}, levels);
  StudyFile const file = read_stored_study(folder, catalogue);
  std::vector<std::string> asked;
  for (auto const& expectation : file.expectations) asked.push_back(expectation.of);
  auto const figures = draw_all(findings, catalogue, folder / "figures", "svg");
  Draft draft{{file.study.name,
               file.study.question,
               file.study.source,
               findings.rows(),
               findings.check(file.expectations),
               file.unjudged,
               {},
               "",
               findings.unfinished()},
              main_figures(figures, findings.rows(), asked)};
  if (draft.figures.empty() && !figures.note.empty()) draft.section.note = "There are no figures: gnuplot drew none.";
  return draft;
}

/// Puts the figures beside the page, named after their study; two studies of one name do not overwrite each other's.
void place_figures(Draft& draft, fs::path const& folder, std::set<std::string>& taken) {
  for (auto const& figure : draft.figures) {
    auto const stem = fmt::format("{}-{}", file_stem(draft.section.name), figure.stem().string());
    auto name = stem + ".svg";
    for (int n = 2; !taken.insert(name).second; ++n) name = fmt::format("{}-{}.svg", stem, n);
    write_whole(folder / name, read_whole(figure));
    draft.section.figures.push_back({figure_caption(figure.stem().string()), folder.filename().string() + "/" + name});
  }
}

void add_programs(std::vector<std::string>& programs, fs::path const& folder) {
  for (auto const& program : programs_of(read_whole(folder / "provenance.txt")))
    if (std::find(programs.begin(), programs.end(), program) == programs.end()) programs.push_back(program);
}

}  // namespace

void write_markdown(std::vector<fs::path> const& results, fs::path const& page, Levels const& levels,
                    Catalogue const& catalogue) {
  std::vector<Draft> drafts;
  std::vector<std::string> programs;
  for (auto const& folder : results) {
    drafts.push_back(draft_of(folder, levels, catalogue));
    add_programs(programs, folder);
  }
  auto const folder = page.parent_path() / (page.stem().string() + "-figures");
  make_figure_folder(folder);
  std::set<std::string> taken;
  std::vector<PageSection> sections;
  for (auto& draft : drafts) {
    place_figures(draft, folder, taken);
    sections.push_back(std::move(draft.section));
  }
  write_whole(page, render_page(sections, programs));
}

}  // namespace brouwer
