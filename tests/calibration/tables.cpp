#include "tests/calibration/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/benchmarks/text_table.hpp"

namespace brouwer::calibration {
namespace {

using benchmarks::TextTable;

/// A rate of one claim, model and design.
struct Case {
  Tally const* tally = nullptr;
  Rate rate;
  bool promised = false;
  Standing standing = Standing::holds;

  std::string where() const { return fmt::format("{}, {}", tally->model->name, tally->design.name()); }
};

std::vector<Case> cases_of(std::size_t number, std::vector<Tally> const& tallies) {
  auto const& claim = claims()[number];
  std::vector<Case> cases;
  for (auto const& tally : tallies) {
    auto const& rate = tally.rates[number];
    if (rate.trials == 0 || (tally.design.strict && !claim.strict)) continue;
    cases.push_back({&tally, rate, is_promised(claim, *tally.model, tally.design), standing(rate, claim.nominal)});
  }
  return cases;
}

/// Is a rate nominal at all?
bool has_bounds(Nominal const& nominal) { return nominal.side != Nominal::Side::told; }

/// Two digits after the point where 0.1 % matters, one otherwise.
std::string percent(double share, Nominal const& nominal) {
  bool const rare = has_bounds(nominal) && nominal.rate < 0.01;
  return fmt::format("{:.{}f}", 100 * share, rare ? 2 : 1);
}

std::string range(Interval bounds, Nominal const& nominal) {
  return percent(bounds.low, nominal) + " … " + percent(bounds.high, nominal);
}

std::string nominal_words(Nominal const& nominal) {
  auto const text = percent(nominal.rate, nominal);
  return nominal.slack > 0 ? fmt::format("{} ± {:.2g}", text, 100 * nominal.slack) : text;
}

std::string mark(Case const& c) {
  switch (c.standing) {
    case Standing::holds:
      return "✓";
    case Standing::safe:
      return "○";
    case Standing::fails:
      break;
  }
  return "✗";
}

/// How far a rate is on the wrong side of what is nominal, in standard deviations.
double badness(Case const& c, Nominal const& nominal) {
  double const sd = std::sqrt(nominal.rate * (1 - nominal.rate) / static_cast<double>(c.rate.trials));
  double const above = (c.rate.value() - nominal.rate) / sd;
  return nominal.side == Nominal::Side::false_alarm ? above : -above;
}

Case const& worst_of(std::vector<Case> const& cases, Nominal const& nominal) {
  return *std::max_element(cases.begin(), cases.end(),
                           [&](Case const& a, Case const& b) { return badness(a, nominal) < badness(b, nominal); });
}

std::vector<Case> promised(std::vector<Case> cases) {
  std::erase_if(cases, [](Case const& c) { return !c.promised; });
  return cases;
}

std::string cell(Case const& c, Nominal const& nominal) {
  if (!has_bounds(nominal)) return percent(c.rate.value(), nominal);
  auto const text = percent(c.rate.value(), nominal) + " " + mark(c);
  return c.promised ? text : "(" + text + ")";
}

/// Designs that have a case, in their order.
std::vector<Design> designs_of(std::vector<Case> const& cases) {
  std::vector<Design> found;
  for (auto const& design : designs())
    if (std::any_of(cases.begin(), cases.end(), [&](Case const& c) { return c.tally->design == design; }))
      found.push_back(design);
  return found;
}

std::string claim_table(std::size_t number, std::vector<Tally> const& tallies) {
  auto const& claim = claims()[number];
  auto const cases = cases_of(number, tallies);
  auto const columns = designs_of(cases);
  std::vector<std::string> header = {claim.name}, within = {"within"};
  for (auto const& design : columns) {
    header.push_back(design.name());
    within.push_back(range(bounds(claim.nominal, design.trials), claim.nominal));
  }
  TextTable table(header);
  if (has_bounds(claim.nominal)) table.add(within);
  for (auto const& model : models()) {
    std::vector<std::string> line = {model.name};
    for (auto const& design : columns) {
      auto const found = std::find_if(cases.begin(), cases.end(), [&](Case const& c) {
        return c.tally->model == &model && c.tally->design == design;
      });
      line.push_back(found == cases.end() ? "" : cell(*found, claim.nominal));
    }
    if (std::any_of(line.begin() + 1, line.end(), [](auto const& text) { return !text.empty(); })) table.add(line);
  }
  return table.text();
}

/// Those that a law can be given: none of the models is exact, or a count.
constexpr std::array<Verdict, 6> words = {Verdict::random_walk, Verdict::persistent_slopes,
                                          Verdict::drift,       Verdict::faster_than_drift,
                                          Verdict::bounded,     Verdict::not_resolved};

std::string verdict_table(Design const& design, std::vector<Tally> const& tallies) {
  std::vector<std::string> header = {design.name()};
  for (auto const word : words) header.push_back(to_string(word));
  TextTable table(header);
  for (auto const& tally : tallies) {
    if (tally.design != design) continue;
    std::vector<std::string> line = {tally.model->name};
    for (auto const word : words) {
      auto const said = static_cast<double>(tally.verdicts[static_cast<std::size_t>(word)]);
      line.push_back(said > 0 ? fmt::format("{:.1f}", 100 * said / design.trials) : "");
    }
    table.add(line);
  }
  return table.text();
}

}  // namespace

std::string summary_table(std::vector<Tally> const& tallies) {
  TextTable table({"claim", "nominal, %", "promised in", "out of bounds", "farthest, %", "within, %", "in"});
  for (std::size_t k = 0; k < claims().size(); ++k) {
    auto const& nominal = claims()[k].nominal;
    auto const cases = promised(cases_of(k, tallies));
    if (cases.empty()) continue;
    auto const out = std::count_if(cases.begin(), cases.end(), [](auto& c) { return c.standing == Standing::fails; });
    auto const& worst = worst_of(cases, nominal);
    table.add({claims()[k].name, nominal_words(nominal), fmt::format("{} cases", cases.size()),
               out ? fmt::format("{} ✗", out) : "none ✓", percent(worst.rate.value(), nominal),
               range(bounds(nominal, worst.rate.trials), nominal), worst.where()});
  }
  return table.text();
}

std::string model_list() {
  std::string text;
  for (auto const& model : models()) text += fmt::format("- **{}**: {}\n", model.name, model.words);
  return text;
}

std::string claim_tables(std::vector<Tally> const& tallies) {
  std::string text;
  for (std::size_t k = 0; k < claims().size(); ++k) text += claim_table(k, tallies) + "\n";
  return text;
}

std::string verdict_tables(std::vector<Tally> const& tallies) {
  std::string text;
  for (auto const& design : designs())
    if (design.verdicts) text += verdict_table(design, tallies) + "\n";
  return text;
}

std::vector<std::string> broken_promises(std::vector<Tally> const& tallies) {
  std::vector<std::string> sentences;
  for (std::size_t k = 0; k < claims().size(); ++k) {
    auto const& nominal = claims()[k].nominal;
    for (auto const& c : promised(cases_of(k, tallies)))
      if (c.standing == Standing::fails)
        sentences.push_back(fmt::format("{}: {} % instead of {} % (within {}) for {}", claims()[k].name,
                                        percent(c.rate.value(), nominal), nominal_words(nominal),
                                        range(bounds(nominal, c.rate.trials), nominal), c.where()));
  }
  return sentences;
}

}  // namespace brouwer::calibration
