// Every name of the catalogue becomes a running trajectory, in every arithmetic in which it exists.
#include <brouwer/ensemble/plan.hpp>
#include <brouwer/ensemble/start.hpp>
#include <brouwer/error.hpp>

#include <gtest/gtest.h>

#include <cmath>

#include "tests/ensemble/small_study.hpp"

namespace brouwer {
namespace {

using testing_support::small_study;

struct Combination {
  MethodEntry method;
  ArithmeticEntry arithmetic;
  std::string variant, coefficients;
};

/// Everything that exists.
std::vector<Combination> combinations(Catalogue const& catalogue) {
  std::vector<std::string> const none = {no_level};
  std::vector<Combination> all;
  for (auto const& method : catalogue.methods)
    for (auto const& arithmetic : catalogue.arithmetics)
      for (auto const& variant : method.uses_special_functions ? special_function_variants() : none)
        for (auto const& coefficients : method.uses_coefficients ? coefficient_levels() : none)
          if (variant == no_level || variant_exists(variant, arithmetic.name))
            all.push_back({method, arithmetic, variant, coefficients});
  return all;
}

TEST(Catalogue, RunsEveryMethodInEveryArithmeticToItsPrecision) {
  auto const catalogue = builtin_catalogue();
  auto const start = nominal_start(small_study(), catalogue.system("rigid_body"));
  int runs = 0;
  for (auto const& [method, arithmetic, variant, coefficients] : combinations(catalogue))
    for (bool compensation : {false, true}) {
      if (compensation && !method.compensable) continue;
      CellLabels const cell{"rigid_body", method.name, arithmetic.name, variant, coefficients, compensation, 0.125, 20};
      auto const trajectory = begin_trajectory(catalogue, cell, start, true);
      trajectory->advance(20);
      std::vector<double> errors(6);
      trajectory->first_integral_errors(errors);
      // Boost's jacobi_elliptic is accurate to about 10⁻¹³ in double
      double const slack = variant == "boost" ? 1e5 : 300;
      for (double e : errors)
        EXPECT_LT(std::abs(e), slack * std::ldexp(1.0, -arithmetic.bits)) << method.name << ' ' << arithmetic.name;
      ++runs;
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
  }
  for (auto const& method : catalogue.methods) {
    EXPECT_NO_THROW(catalogue.system(method.system));
    EXPECT_FALSE(method.source.empty()) << method.name;
  }
}

}  // namespace
}  // namespace brouwer
