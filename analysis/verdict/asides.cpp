// What is said beside a verdict: where the mean begins otherwise, and which members are unlike all others.
#include <fmt/format.h>

#include "analysis/numbers.hpp"
#include "analysis/verdict/phrases.hpp"
#include "analysis/verdict/verdict.hpp"

namespace brouwer {
namespace {

/// The first few; the others are in json.
std::string listed(std::vector<std::string> const& members) {
  constexpr std::size_t shown = 8;
  if (members.size() <= shown) return fmt::format("{}", fmt::join(members, ", "));
  return fmt::format("{}, …", fmt::join(members.begin(), members.begin() + shown, ", "));
}

}  // namespace

std::string transient_in_words(Estimates const& e) {
  if (!e.transient) return "";
  auto const& after = e.transient->after;
  if (e.slope_to_the_end().p >= e.levels.test && after.p >= e.levels.test) return "";
  return fmt::format("; until {} {} the mean moves otherwise than later ({}), and from there on by {}; t = {}, {})",
                     number(e.transient->until, 3), e.time_unit + "s", probability(e.transient->p),
                     drift_interval(after, e), number(after.t, 3), probability(after.p));
}

std::string far_off_in_words(Estimates const& e) {
  auto const count = e.far_off.members.size();
  if (count == 0) return "";
  auto const of_all = static_cast<double>(e.members) + (e.far_off.set_aside ? static_cast<double>(count) : 0);
  std::string const who = fmt::format("{} {} far outside the others ({})", count,
                                      count == 1 ? "member lies" : "members lie", listed(e.far_off.members));
  if (!e.far_off.set_aside)
    return "; " + who +
           fmt::format(": {} of all, a population of their own and not set aside",
                       percent(static_cast<double>(count) / of_all));
  return "; " + who +
         fmt::format(" and {} set aside; with {}: drift {}; t = {}, {}), σ = {}", count == 1 ? "is" : "are",
                     count == 1 ? "it" : "them", drift_interval(e.far_off.drift, e), number(e.far_off.drift.t, 3),
                     probability(e.far_off.drift.p), brief(e.far_off.diffusion.per_sqrt_step) + per_root(e));
}

}  // namespace brouwer
