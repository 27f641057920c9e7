#include "analysis/pages/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <brouwer/error.hpp>
#include <cmath>
#include <functional>
#include <set>
#include <sstream>

#include "analysis/escape.hpp"
#include "analysis/factors.hpp"
#include "analysis/numbers.hpp"
#include "analysis/pages/growth_table.hpp"
#include "analysis/pages/increments_table.hpp"
#include "analysis/pages/tables.hpp"
#include "analysis/verdict/verdict.hpp"

namespace brouwer {
namespace {

using Words = std::vector<std::string>;

constexpr std::size_t most_lines = 30;  ///< longer tables are folded

// --- Markdown -------------------------------------------------------------------------------------

std::string row(Words const& cells) { return fmt::format("| {} |\n", fmt::join(cells, " | ")); }

std::string paragraph(std::string const& text) {
  auto const end = text.find_last_not_of('\n');
  return end == std::string::npos ? "" : text.substr(0, end + 1) + "\n\n";
}

/// What is long is folded away; renderers without folds show it.
std::string folded(std::string const& summary, std::string const& inside) {
  return "<details><summary>" + summary + "</summary>\n\n" + paragraph(inside) + "</details>\n\n";
}

std::string heading_of(PageSection const& section) {
  return markdown_text(section.question.empty() ? section.name : section.question);
}

/// Names of places are letters, digits and hyphens; studies of one name are numbered.
Words places_of(std::vector<PageSection> const& sections) {
  std::set<std::string> taken;
  Words places;
  for (auto const& section : sections) {
    auto const stem = file_stem(section.name);
    auto place = stem;
    for (int n = 2; !taken.insert(place).second; ++n) place = fmt::format("{}-{}", stem, n);
    places.push_back(place);
  }
  return places;
}

// --- the table of all studies ---------------------------------------------------------------------

std::size_t held(std::vector<Outcome> const& outcomes) {
  return static_cast<std::size_t>(
      std::count_if(outcomes.begin(), outcomes.end(), [](Outcome const& outcome) { return outcome.passed; }));
}

std::string score(PageSection const& section) {
  auto const all = section.outcomes.size(), good = held(section.outcomes);
  auto text = all == 0 ? std::string("nothing was expected") : fmt::format("{} of {} hold", good, all);
  if (good < all) text = "**" + text + "**";
  text += section.unjudged.empty() ? "" : fmt::format(", {} not judged", section.unjudged.size());
  return text + (section.unfinished.empty() ? "" : ", unfinished");
}

std::string total(std::vector<PageSection> const& sections) {
  std::size_t good = 0, all = 0;
  for (auto const& section : sections) {
    good += held(section.outcomes);
    all += section.outcomes.size();
  }
  return fmt::format("{} {}; {} of {} expectations hold.", sections.size(), sections.size() == 1 ? "study" : "studies",
                     good, all);
}

std::string summary(std::vector<PageSection> const& sections, Words const& places) {
  auto text = row({"question", "expectations", "study"}) + "|:---|:---|:---|\n";
  for (std::size_t i = 0; i < sections.size(); ++i)
    text += row({heading_of(sections[i]), score(sections[i]),
                 fmt::format("[{}](#{})", markdown_text(sections[i].name), places[i])});
  return text + "\n" + paragraph(total(sections));
}

// --- what was measured ----------------------------------------------------------------------------

std::string with_unit(std::string const& name, std::string const& value, std::string const& unit) {
  return name + " = " + value + (unit.empty() ? "" : " " + unit);
}

/// The number that carries the verdict, with its interval.
std::string carrying_value(Estimates const& e) {
  auto const exponent = with_unit("exponent q", measured(e.growth.exponent, e.growth.interval), "");
  switch (e.verdict) {
    case Verdict::count:
      return fmt::format("{} ({} … {}) {}", number(e.count->mean, 3), number(e.count->range.low, 3),
                         number(e.count->range.high, 3), counted_things(e));
    case Verdict::drift:
      return with_unit("drift β", measured(e.drift.per_step, e.drift.interval), "per " + e.time_unit);
    case Verdict::persistent_slopes:
      return with_unit("slopes τ", number(e.persistence.per_step, 2), "per " + e.time_unit) +
             fmt::format(", F = {}", number(e.persistence.F, 2));
    case Verdict::random_walk:
      return with_unit("diffusion σ", measured(e.diffusion.per_sqrt_step, e.diffusion.interval), "per √" + e.time_unit);
    case Verdict::exact:
      return "every error is 0";
    case Verdict::bounded:
    case Verdict::faster_than_drift:
    case Verdict::not_resolved:
      break;
  }
  return std::isnan(e.growth.exponent) ? number(e.growth.exponent, 3) : exponent;
}

std::string measured_table(std::vector<Estimates> const& rows) {
  auto const varying = varying_factors(cells_of(rows));
  auto text = row({"error of", "cell", "RMS at the end", "what the verdict rests on", "verdict"}) +
              "|:---|:---|---:|:---|:---|\n";
  for (auto const& e : rows)
    text += row({markdown_text(e.quantity), markdown_text(short_label(e.cell, varying)), number(e.rms_final, 2),
                 markdown_text(carrying_value(e)), to_string(e.verdict)});
  return text;
}

std::string measurements(std::vector<Estimates> const& rows) {
  if (rows.empty()) return "";
  auto const growth = growth_table(rows, CellsAs::groups);
  auto const table = measured_table(rows);
  std::string notes;
  for (auto const& note : growth.notes) notes += "- " + markdown_text(note) + "\n";
  return paragraph(markdown_text(growth.shared)) +
         (rows.size() > most_lines ? folded(fmt::format("{} measurements", rows.size()), table) : paragraph(table)) +
         paragraph(notes);
}

/// Folded away: it is asked for where a verdict is doubted.
std::string increments(std::vector<Estimates> const& rows) {
  auto const table = increments_table(rows, CellsAs::columns);
  if (table.rows.empty()) return "";
  std::string legend;
  for (auto const& line : table.legend) legend += "- " + markdown_text(line) + "\n";
  return folded("Increments", paragraph(markdown_rows(table)) + legend);
}

// --- expectations and figures ---------------------------------------------------------------------

template <class Chosen>
std::string outcome_table(std::vector<Outcome> const& outcomes, Chosen chosen) {
  std::string text;
  for (auto const& outcome : outcomes)
    if (chosen(outcome))
      text += row(
          {markdown_text(outcome.claim), markdown_text(outcome.found), outcome.passed ? "passed" : "**CONTRADICTED**"});
  return text.empty() ? "" : row({"expected", "found", "outcome"}) + "|:---|:---|:---|\n" + text;
}

/// Of many expectations those that are contradicted stand before the fold.
std::string outcomes(std::vector<Outcome> const& all) {
  auto const passed = [](Outcome const& outcome) { return outcome.passed; };
  if (all.size() <= most_lines) return paragraph(outcome_table(all, [](Outcome const&) { return true; }));
  auto const good = outcome_table(all, passed);
  return paragraph(outcome_table(all, std::not_fn(passed))) +
         (good.empty() ? "" : folded(fmt::format("{} expectations passed", held(all)), good));
}

std::string expectations(PageSection const& section) {
  std::string unjudged;
  for (auto const& sentence : section.unjudged) unjudged += "- Not judged: " + markdown_text(sentence) + "\n";
  return outcomes(section.outcomes) + paragraph(unjudged);
}

std::string figures(PageSection const& section) {
  std::string text;
  for (auto const& figure : section.figures) {
    auto const name = std::filesystem::path(figure.link).stem().string();
    text += paragraph(fmt::format("![{}]({})", markdown_text(name), figure.link)) +
            paragraph("*" + markdown_text(figure.caption) + "*");
  }
  return text + paragraph(markdown_text(section.note));
}

std::string section_text(PageSection const& section, std::string const& place) {
  return paragraph(fmt::format("<a id=\"{}\"></a>", place)) + paragraph("## " + heading_of(section)) +
         paragraph(section.unfinished.empty() ? "" : "**" + markdown_text(section.unfinished) + "**") +
         paragraph(section.source.empty() ? "" : "Source: " + markdown_text(section.source)) +
         measurements(section.estimates) + increments(section.estimates) + expectations(section) + figures(section);
}

std::string levels_in_words(std::vector<PageSection> const& sections) {
  for (auto const& section : sections)
    if (!section.estimates.empty()) {
      auto const& levels = section.estimates.front().levels;
      return fmt::format(
          "± is half a {:g} % interval; a drift, or persistence, counts as seen at level {:g}. RMS is over members; it "
          "grows as t^q, with q = 0.5 for a random walk and 1 for a drift.",
          100 * levels.confidence, levels.test);
    }
  return "";
}

/// The value of `key = value` in one block.
std::string value_of(std::string const& block, std::string const& key) {
  std::istringstream lines(block);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with(key + " = ")) return line.substr(key.size() + 3);
  return "";
}

}  // namespace

PageFormat page_format(std::filesystem::path const& page) {
  auto const extension = page.extension();
  if (extension == ".md") return PageFormat::markdown;
  if (extension == ".html" || extension == ".htm") return PageFormat::html;
  throw InputError(
      fmt::format("{} is to be a page; expected a name that ends in .html, .htm or .md", one_line(page.string())));
}

std::string render_page(std::vector<PageSection> const& sections, std::vector<std::string> const& programs) {
  auto const places = places_of(sections);
  auto text = paragraph("# Results") + summary(sections, places) + paragraph(levels_in_words(sections));
  for (std::size_t i = 0; i < sections.size(); ++i) text += section_text(sections[i], places[i]);
  if (!programs.empty())
    text += fmt::format("---\n\nComputed with {}.\n", markdown_text(fmt::format("{}", fmt::join(programs, "; "))));
  return text.substr(0, text.find_last_not_of('\n') + 1) + "\n";
}

std::vector<std::string> programs_of(std::string const& provenance) {
  Words programs;
  for (std::size_t begin = 0; begin < provenance.size();) {
    auto const end = std::min(provenance.find("\n\n", begin), provenance.size());
    auto const block = provenance.substr(begin, end - begin);
    auto const program = fmt::format("brouwer {}, {}", value_of(block, "brouwer"), value_of(block, "compiler"));
    if (std::find(programs.begin(), programs.end(), program) == programs.end()) programs.push_back(program);
    begin = end + 2;
  }
  return programs;
}

}  // namespace brouwer
