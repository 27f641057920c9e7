#include "analysis/expectations/correct.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/numbers.hpp"
#include "analysis/verdict/verdict.hpp"

namespace brouwer {
namespace {

constexpr double no_test = std::numeric_limits<double>::quiet_NaN();

template <class Items, class P>
std::vector<double> adjusted_of(Items const& items, Correction correction, P p) {
  std::vector<double> all;
  for (auto const& item : items) all.push_back(p(item));
  return adjusted(all, correction);
}

std::ptrdiff_t tests_among(std::vector<Outcome> const& outcomes) {
  return std::count_if(outcomes.begin(), outcomes.end(),
                       [](Outcome const& outcome) { return outcome.test && !std::isnan(outcome.test->p); });
}

}  // namespace

void correct(std::span<Estimates> rows, Correction correction) {
  if (correction == Correction::none) return;
  auto const p = adjusted_of(rows, correction, [](Estimates const& row) { return row.drift.own_p(); });
  for (std::size_t i = 0; i < rows.size(); ++i) {
    auto& row = rows[i];
    row.levels.correction = correction;
    row.drift.p_alone = row.drift.own_p();
    row.drift.p = p[i];
    auto judgement = judge(row);
    row.verdict = judgement.verdict;
    row.sentence = std::move(judgement.sentence);
  }
}

void correct(std::vector<Outcome>& outcomes, Correction correction) {
  if (correction == Correction::none) return;
  auto const p = adjusted_of(outcomes, correction, [](Outcome const& o) { return o.test ? o.test->p : no_test; });
  auto const tests = tests_among(outcomes);
  for (std::size_t i = 0; i < outcomes.size(); ++i)
    if (auto const& test = outcomes[i].test; test && !std::isnan(p[i])) {
      outcomes[i].passed = test->holds(p[i]);
      outcomes[i].found +=
          fmt::format("; adjusted for {} tests ({}): {}", tests, to_string(correction), probability(p[i]));
    }
}

}  // namespace brouwer
