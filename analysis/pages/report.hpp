#pragma once
#include <string>
#include <utility>
#include <vector>

#include "analysis/estimates.hpp"
#include "analysis/expectations/expectation.hpp"
#include "analysis/figures/plots.hpp"

namespace brouwer {

struct ReportFigure {
  std::string caption;
  std::string svg;  ///< as gnuplot writes it; trusted, it becomes part of the page
};

/// What a report says, in the order in which it is read. Everything but `svg` is text and is escaped; what is empty
/// is left out.
struct ReportContent {
  std::string title;     ///< the study's name
  std::string question;  ///< becomes the heading
  std::string source;
  std::vector<std::pair<std::string, std::string>> run;  ///< what was run: {"members", "1000"}
  std::vector<Outcome> outcomes;
  std::vector<std::string> unjudged;  ///< expectations that options put out of reach, a sentence each
  std::vector<Estimates> estimates;
  std::vector<ReportFigure> figures;
  std::string note;        ///< why there are no figures, or not all
  std::string study_text;  ///< the study file
  std::string provenance;  ///< versions, compiler, machine
  std::string unfinished;  ///< "unfinished: 900 of 4200 members in 14 cells"; stands in the page's head
};

/// One self-contained HTML5 page: nothing is loaded from elsewhere, no scripts; for light and dark screens and paper.
std::string render_report(ReportContent const& content);

/// What a figure shows, by the stem of its file: "growth-energy".
std::string figure_caption(std::string const& stem);

/// The SVG files of `figures` with a caption each. @throws RunError for a file that cannot be read
std::vector<ReportFigure> report_figures(Figures const& figures);

}  // namespace brouwer
