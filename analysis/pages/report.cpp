#include "analysis/pages/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <brouwer/error.hpp>
#include <fstream>
#include <sstream>

#include "analysis/escape.hpp"
#include "analysis/factors.hpp"
#include "analysis/increments/increments_objection.hpp"
#include "analysis/pages/growth_table.hpp"
#include "analysis/pages/increments_table.hpp"
#include "analysis/pages/report_style.hpp"

namespace brouwer {
namespace {

std::string element(char const* name, std::string const& inside) {
  return fmt::format("<{0}>{1}</{0}>\n", name, inside);
}

std::string text_element(char const* name, std::string const& text) {
  return text.empty() ? "" : element(name, xml_text(text));
}

std::string section(char const* heading, std::string const& inside) {
  return inside.empty() ? "" : fmt::format("<section>\n{}{}</section>\n", text_element("h2", heading), inside);
}

// --- the head of the page -------------------------------------------------------------------------

std::string summary(std::vector<Outcome> const& outcomes) {
  if (outcomes.empty()) return "";
  auto const met = std::count_if(outcomes.begin(), outcomes.end(), [](auto const& outcome) { return outcome.passed; });
  bool const all = static_cast<std::size_t>(met) == outcomes.size();
  return fmt::format("<p class=\"summary {}\">{} of {} expectations met</p>\n", all ? "pass" : "fail", met,
                     outcomes.size());
}

std::string unfinished(ReportContent const& content) {
  if (content.unfinished.empty()) return "";
  return "<p class=\"summary fail\">" + xml_text(content.unfinished) + "</p>\n";
}

std::string page_header(ReportContent const& content) {
  std::string const heading = content.question.empty() ? content.title : content.question;
  std::string const above = content.question.empty() ? "" : "<p class=\"title\">" + xml_text(content.title) + "</p>\n";
  return element("header", above + text_element("h1", heading) + unfinished(content) +
                               text_element("cite", content.source) + summary(content.outcomes));
}

// --- verdicts and expectations --------------------------------------------------------------------

/// A word that becomes a class of the style sheet: "random walk" → "random-walk".
std::string class_of(Verdict verdict) {
  std::string name = to_string(verdict);
  std::replace(name.begin(), name.end(), ' ', '-');
  return name;
}

std::string verdicts(std::vector<Estimates> const& rows) {
  auto const varying = varying_factors(cells_of(rows));
  std::string items;
  for (auto const& row : rows)
    items += fmt::format("<li><span class=\"verdict {}\">{}</span> <b>{}</b>, {}: {}</li>\n", class_of(row.verdict),
                         xml_text(to_string(row.verdict)), xml_text(row.quantity),
                         xml_text(short_label(row.cell, varying)), xml_text(row.sentence));
  return items.empty() ? "" : "<ul class=\"verdicts\">\n" + items + "</ul>\n";
}

std::string expectations(ReportContent const& content) {
  std::string rows, rest;
  for (auto const& outcome : content.outcomes)
    rows += fmt::format("<tr class=\"{0}\"><td class=\"mark\">{0}</td><td>{1}</td><td>{2}</td></tr>\n",
                        outcome.passed ? "pass" : "fail", xml_text(outcome.claim), xml_text(outcome.found));
  for (auto const& sentence : content.unjudged) rest += text_element("p", "Not judged: " + sentence);
  if (rows.empty()) return rest;
  return "<div class=\"wide\"><table "
         "class=\"outcomes\">\n<thead><tr><th></th><th>expected</th><th>found</th></tr></thead>\n"
         "<tbody>\n" +
         rows + "</tbody></table></div>\n" + rest;
}

// --- tables of estimates --------------------------------------------------------------------------

std::string table_row(GrowthTable const& table, std::vector<std::string> const& words) {
  std::string cells;
  for (std::size_t j = 0; j < words.size(); ++j)
    cells += fmt::format("<td{}>{}</td>", table.headings[j].left ? "" : " class=\"number\"", xml_text(words[j]));
  return "<tr>" + cells + "</tr>\n";
}

std::string table_element(GrowthTable const& table, CellsAs layout) {
  if (table.rows.empty()) return "";
  std::string heads, body, below;
  for (auto const& heading : table.headings)
    heads += fmt::format("<th{}>{}</th>", heading.left ? "" : " class=\"number\"", xml_text(heading.text));
  for (auto const& row : table.rows) {
    if (layout == CellsAs::groups && row.first_of_cell)
      body += fmt::format("<tr class=\"cell\"><th colspan=\"{}\">{}</th></tr>\n", table.headings.size(),
                          xml_text(row.cell));
    body += table_row(table, row.words);
  }
  for (auto const& note : table.notes) below += text_element("p", note);
  for (auto const& line : table.legend) below += text_element("li", line);
  return text_element("p", table.shared) + "<div class=\"wide\"><table>\n<thead><tr>" + heads +
         "</tr></thead>\n<tbody>\n" + body + "</tbody></table></div>\n<ul class=\"legend\">\n" + below + "</ul>\n";
}

using MakeTable = GrowthTable (*)(std::vector<Estimates> const&, CellsAs);

std::string table_of(std::vector<Estimates> const& rows, MakeTable table) {
  auto const layout = best_layout(rows);
  return table_element(table(rows, layout), layout);
}

GrowthTable plain_growth_table(std::vector<Estimates> const& rows, CellsAs layout) {
  return growth_table(rows, layout);
}

/// The sentences of those that contradict the model.
std::string objections(std::vector<Estimates> const& rows) {
  auto const varying = varying_factors(cells_of(rows));
  std::string items;
  for (auto const& row : rows)
    if (auto const objection = increments_objection(row); !objection.empty())
      items += fmt::format("<li><b>{}</b>, {}: {}</li>\n", xml_text(row.quantity),
                           xml_text(short_label(row.cell, varying)), xml_text(objection));
  return items.empty() ? "" : "<ul>\n" + items + "</ul>\n";
}

// --- figures --------------------------------------------------------------------------------------

void insert_after(std::string& text, std::string const& marker, std::string const& inserted) {
  for (auto at = text.find(marker); at != std::string::npos; at = text.find(marker, at + marker.size()))
    text.insert(at + marker.size(), inserted);
}

void cut(std::string& text, std::string const& from, std::string const& to) {
  auto const begin = text.find(from), end = text.find(to, begin == std::string::npos ? 0 : begin);
  if (begin != std::string::npos && end != std::string::npos) text.erase(begin, end + to.size() - begin);
}

/// As an element of a page: without prolog and tooltip, and with identifiers that no other figure has.
std::string inlined(std::string svg, std::size_t index) {
  auto const begin = svg.find("<svg");
  if (begin == std::string::npos) return "";
  svg.erase(0, begin);
  cut(svg, "<title>", "</title>");
  for (auto const* reference : {" id='", " id=\"", "href='#", "url(#"})
    insert_after(svg, reference, fmt::format("f{}-", index));
  return svg;
}

std::string figures(ReportContent const& content) {
  std::string text;
  for (std::size_t i = 0; i < content.figures.size(); ++i)
    text +=
        element("figure", inlined(content.figures[i].svg, i) + text_element("figcaption", content.figures[i].caption));
  return text + text_element("p", content.note);
}

// --- what was run ---------------------------------------------------------------------------------

std::string run(ReportContent const& content) {
  std::string list;
  for (auto const& [name, value] : content.run) list += text_element("dt", name) + text_element("dd", value);
  return list.empty() ? "" : element("dl", list);
}

std::string folded(char const* name, std::string const& text) {
  if (text.empty()) return "";
  return element("details", text_element("summary", name) + text_element("pre", text));
}

struct Kind {
  char const* prefix;
  char const* caption;
};
constexpr Kind kinds[] = {
    {"growth-",
     "Growth of the RMS over members. A random walk follows Brouwer's law (slope ½); a drift or persistent "
     "slopes bend it to slope 1."},
    {"histogram-",
     "Final errors of the members, less their mean and over their standard deviation. The sum of many "
     "small independent errors is normal."},
    {"increments-",
     "Increments of the members' errors less the slope so far, over their standard deviation. Those of a walk of many "
     "small independent errors are normal."},
    {"precision-",
     "Error at the end against work: steps, and CPU time of a member where it was recorded. Points of a line differ in "
     "their step h alone."},
    {"cloud-still",
     "The ensemble in phase space at the start, half-way and at the end. A colour follows members from where they "
     "started."},
    {"count-", "Mean over members, and their standard deviation."},
    {"mean-", "Mean over members. Where its interval leaves zero for good, the members share a drift."},
};

ReportFigure read_figure(std::filesystem::path const& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream svg;
  svg << stream.rdbuf();
  if (!stream) throw RunError(fmt::format("cannot read the figure {}", file.string()));
  return {figure_caption(file.stem().string()), svg.str()};
}

}  // namespace

std::string render_report(ReportContent const& content) {
  std::string const title = content.title.empty() ? "Growth of round-off error" : content.title;
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n" +
         text_element("title", title) + element("style", report_style) + "</head>\n<body>\n" + page_header(content) +
         section("Expectations", expectations(content)) + section("Verdicts", verdicts(content.estimates)) +
         section("Growth", table_of(content.estimates, plain_growth_table)) +
         section("Decisions", table_of(content.estimates, decisions_table)) +
         section("Increments", objections(content.estimates) + table_of(content.estimates, increments_table)) +
         section("Figures", figures(content)) +
         section("What was run",
                 run(content) + folded("Study file", content.study_text) + folded("Provenance", content.provenance)) +
         "</body>\n</html>\n";
}

std::string figure_caption(std::string const& stem) {
  for (auto const& kind : kinds)
    if (stem.starts_with(kind.prefix)) return kind.caption;
  return stem;
}

std::vector<ReportFigure> report_figures(Figures const& figures) {
  std::vector<ReportFigure> read;
  for (auto const& file : figures.files)
    if (file.extension() == ".svg") read.push_back(read_figure(file));
  return read;
}

}  // namespace brouwer
