#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "analysis/estimates.hpp"
#include "analysis/expectations/expectation.hpp"

namespace brouwer {

enum class PageFormat { html, markdown };

/// By the end of its name: .html or .htm, .md. @throws InputError for any other
PageFormat page_format(std::filesystem::path const& page);

struct PageFigure {
  std::string caption;
  std::string link;  ///< relative to the page
};

/// What a page of results says of one study; everything but links is text and is escaped, what is empty is left out.
struct PageSection {
  std::string name;      ///< the study's; its place in the page is called so
  std::string question;  ///< becomes the heading
  std::string source;
  std::vector<Estimates> estimates;
  std::vector<Outcome> outcomes;
  std::vector<std::string> unjudged;  ///< expectations that options put out of reach, a sentence each
  std::vector<PageFigure> figures;
  std::string note;        ///< why there are no figures
  std::string unfinished;  ///< "unfinished: 900 of 4200 members in 14 cells"; said before anything that was found
};

/// One Markdown page of several studies: first a table of them (question, how many expectations hold), then a section
/// each. Equal results give the same page: no dates, no paths, no machine.
/// @param programs  with what it was computed: "brouwer 0.1.0, g++ 12.2.0"; said once at the end
std::string render_page(std::vector<PageSection> const& sections, std::vector<std::string> const& programs);

/// "brouwer 0.1.0, g++ 12.2.0": of each block of a provenance.txt, the different ones once, in their order.
std::vector<std::string> programs_of(std::string const& provenance);

}  // namespace brouwer
