#include "analysis/causes/evidence.hpp"

#include <algorithm>
#include <brouwer/spelling.hpp>

#include "analysis/causes/causes.hpp"

namespace brouwer {
namespace {

using Changed = std::vector<std::string>;

/// Which cells make a change.
struct Making {
  Change change;
  bool (*made_by)(ComparedCell const&, Explanation const&);
};

bool is_directed(std::string const& rounding) { return rounding != "nearest" && rounding != "stochastic"; }

/// What other operations and functions do is as small there as all round-off.
bool is_of_precision(Changed const& changed) {
  return contains(changed, "arithmetic") && !contains(changed, "sum") && !contains(changed, "coefficients");
}

constexpr Making makings[] = {
    {Change::higher_precision,
     [](ComparedCell const& c, Explanation const& e) { return is_of_precision(c.changed) && c.bits > e.bits; }},
    {Change::nearest_for_directed,
     [](ComparedCell const& c, Explanation const& e) {
       return c.changed == Changed{"rounding"} && c.cell.rounding == "nearest" && is_directed(e.nominal.cell.rounding);
     }},
    {Change::constants,
     [](ComparedCell const& c, Explanation const&) {
       return c.changed == Changed{"constants"} && c.cell.constants == "exact";
     }},
    {Change::unbiased_rounding,
     [](ComparedCell const& c, Explanation const&) {
       return c.changed == Changed{"rounding"} && c.cell.rounding == "stochastic";
     }},
    {Change::constants_and_rounding,
     [](ComparedCell const& c, Explanation const&) {
       return c.changed == Changed{"constants", "rounding"} && c.cell.constants == "exact" &&
              c.cell.rounding == "stochastic";
     }},
    {Change::coefficients,
     [](ComparedCell const& c, Explanation const&) { return c.changed == Changed{"coefficients"}; }},
    {Change::functions, [](ComparedCell const& c, Explanation const&) { return c.changed == Changed{"functions"}; }},
    {Change::sum, [](ComparedCell const& c, Explanation const&) { return c.changed == Changed{"sum"}; }},
    {Change::products, [](ComparedCell const& c, Explanation const&) { return c.changed == Changed{"products"}; }},
};

}  // namespace

ComparedCell const* Evidence::cell(Change change) const {
  auto const& making =
      *std::find_if(std::begin(makings), std::end(makings), [&](auto const& m) { return m.change == change; });
  ComparedCell const* found = nullptr;
  for (auto const& cell : explanation_.cells)
    if (making.made_by(cell, explanation_) && (!found || remainder_of(left_of(cell, subject_)) == Remainder::gone))
      found = &cell;
  return found;
}

Remainder Evidence::remainder(Change change) const {
  auto const* const found = cell(change);
  return found ? remainder_of(left_of(*found, subject_)) : Remainder::unknown;
}

}  // namespace brouwer
