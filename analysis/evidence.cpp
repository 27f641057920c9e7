#include "analysis/evidence.hpp"

#include <algorithm>

#include "analysis/causes.hpp"

namespace brouwer {
namespace {

using Changed = std::vector<std::string>;

/// Which cells make a change.
struct Making {
  Change change;
  bool (*made_by)(ComparedCell const&, Explanation const&);
};

bool is_directed(std::string const& rounding) { return rounding != "nearest" && rounding != "stochastic"; }

constexpr Making makings[] = {
    {Change::higher_precision,
     [](ComparedCell const& c, Explanation const& e) { return c.changed == Changed{"arithmetic"} && c.bits > e.bits; }},
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
    if (making.made_by(cell, explanation_) && (!found || fate_of(left_of(cell, subject_)) == Fate::gone)) found = &cell;
  return found;
}

Fate Evidence::fate(Change change) const {
  auto const* const found = cell(change);
  return found ? fate_of(left_of(*found, subject_)) : Fate::unknown;
}

bool Evidence::is_there_in_all() const {
  auto const& cells = explanation_.cells;
  return !cells.empty() && std::all_of(cells.begin(), cells.end(), [&](ComparedCell const& c) {
    return c.bits != explanation_.bits || fate_of(left_of(c, subject_)) == Fate::there;
  });
}

}  // namespace brouwer
