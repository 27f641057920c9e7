// Every name of the catalogue becomes a running trajectory, in every arithmetic in which it exists.
#include <brouwer/ensemble/plan.hpp>
#include <brouwer/ensemble/start.hpp>
#include <brouwer/error.hpp>

#include <gtest/gtest.h>

#include <cmath>

#include "tests/ensemble/small_study.hpp"

namespace brouwer {
namespace {

using testing_support::levels_or_none;
using testing_support::standard_study;

struct Combination {
  MethodEntry method;
  ArithmeticEntry arithmetic;
  std::string variant, coefficients;
};

/// Everything that exists.
std::vector<Combination> combinations(Catalogue const& catalogue) {
  std::vector<Combination> all;
  for (auto const& method : catalogue.methods)
    for (auto const& arithmetic : catalogue.arithmetics)
      for (auto const& variant :
           method.uses_special_functions ? special_function_variants() : std::vector<std::string>{no_level})
        for (auto const& coefficients : levels_or_none(method.coefficients))
          if (variant == no_level || variant_exists(variant, arithmetic.name))
            all.push_back({method, arithmetic, variant, coefficients});
  return all;
}

std::vector<Widest> state_after(Catalogue const& catalogue, CellLabels const& cell, Start const& start) {
  auto const trajectory = begin_trajectory(catalogue, cell, start, true);
  trajectory->advance(cell.steps);
  std::vector<Widest> state(start.state.size());
  trajectory->state(0, state);
  return state;
}

/// The largest difference of a component, relative to the largest component.
double distance(std::vector<Widest> const& a, std::vector<Widest> const& b) {
  double apart = 0, size = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    double const difference = std::abs(static_cast<double>(Widest(a[i] - b[i])));
    apart = std::isfinite(difference) ? std::max(apart, difference) : INFINITY;
    size = std::max(size, std::abs(static_cast<double>(b[i])));
  }
  return apart / size;
}

TEST(Catalogue, RunsEveryMethodInEveryArithmeticToItsPrecision) {
  auto const catalogue = builtin_catalogue();
  int runs = 0;
  for (auto const& [method, arithmetic, variant, coefficients] : combinations(catalogue)) {
    if (arithmetic.name == "mpfr-512") continue;  // the judge
    auto const& system = catalogue.system(method.system);
    double const h = std::exp2(std::round(std::log2(system.usual_step)));  // the same in every arithmetic
    auto const start = rounded_to(arithmetic.name, nominal_start(standard_study(system), system));
    CellLabels cell{system.name,  method.name, "mpfr-512", variant == no_level ? no_level : "own",
                    coefficients, false,       h,          3};
    auto const expected = state_after(catalogue, cell, start);
    cell.arithmetic = arithmetic.name;
    cell.special_functions = variant;
    for (bool compensation : {false, true}) {
      if (compensation && !method.compensable) continue;
      cell.compensation = compensation;
      // Boost's jacobi_elliptic is accurate to about 10⁻¹³ in double
      double const slack = variant == "boost" ? 1e5 : 100;
      EXPECT_LT(distance(state_after(catalogue, cell, start), expected), slack * std::ldexp(1.0, -arithmetic.bits))
          << system.name << ' ' << method.name << ' ' << arithmetic.name << ' ' << coefficients << ' ' << compensation;
      ++runs;
    }
  }
  EXPECT_GT(runs, 60);
}

TEST(Catalogue, KnowsVariantsByArithmetic) {
  EXPECT_TRUE(variant_exists("gsl", "double"));
  EXPECT_FALSE(variant_exists("gsl", "float"));
  EXPECT_TRUE(variant_exists("own", "mpfr-512"));
  EXPECT_TRUE(variant_exists("boost", "mpfr-256"));
  EXPECT_FALSE(variant_exists("boost", "float128"));
  EXPECT_FALSE(variant_exists("nag", "double"));
}

TEST(Catalogue, DescribesWhatItsTrajectoriesGive) {
  auto const catalogue = builtin_catalogue();
  for (auto const& system : catalogue.systems) {
    std::size_t components = 0;
    for (auto const& field : system.fields)
      if (!field.parameter) components += static_cast<std::size_t>(field.size);
    EXPECT_EQ(components, system.state_components.size()) << system.name;
    EXPECT_FALSE(system.title.empty());
    EXPECT_FALSE(system.complaint(standard_study(system).values)) << system.name;
  }
  for (auto const& method : catalogue.methods) {
    EXPECT_NO_THROW(catalogue.system(method.system));
    EXPECT_FALSE(method.source.empty()) << method.name;
  }
}

}  // namespace
}  // namespace brouwer
