// Compositions as data: palindromic, consistent, and of the order that they state, by the order conditions themselves.
#include <brouwer/integrators/composition.hpp>
#include <brouwer/scalar/double_double.hpp>

#include <gtest/gtest.h>

#include <set>

#include "tests/numbers.hpp"

namespace brouwer {
namespace {

using testing_support::Judge;

/// A word in the generators Y₁, Y₃, Y₅ … of a symmetric base method, log Φ(h) = hY₁ + h³Y₃ + …
using Word = std::vector<int>;

/// Every word of a weight.
std::vector<Word> words_of_weight(int weight) {
  if (weight == 0) return {{}};
  std::vector<Word> words;
  for (int first = 1; first <= weight; first += 2)
    for (auto word : words_of_weight(weight - first)) {
      word.insert(word.begin(), first);
      words.push_back(word);
    }
  return words;
}

Judge power(Judge const& a, int n) {
  Judge result = 1;
  for (int i = 0; i < n; ++i) result *= a;
  return result;
}

/// The coefficient of a word in exp(γ₁Y₁ + γ₁³Y₃ + …) … exp(γₛY₁ + γₛ³Y₃ + …): a letter is taken from a factor at or
/// behind its predecessor's, and n of one factor with 1/n!.
Judge coefficient(Word const& word, std::vector<Judge> const& weights) {
  std::vector<Judge> of_prefix(word.size() + 1, Judge(0));
  of_prefix[0] = 1;
  for (auto const& weight : weights)
    for (std::size_t end = word.size(); end > 0; --end) {
      Judge product = 1;
      for (std::size_t i = end; i > 0; --i) {
        product *= power(weight, word[i - 1]) / static_cast<int>(end - i + 1);
        of_prefix[end] += product * of_prefix[i - 1];
      }
    }
  return of_prefix.back();
}

/// By how much the words of a weight miss those of exp(Y₁), which is what they have in the flow.
double largest_defect(std::vector<Judge> const& weights, int weight) {
  Judge worst = 0;
  for (auto const& word : words_of_weight(weight)) {
    bool const flows = static_cast<int>(word.size()) == weight;  // Y₁ alone
    worst = larger(worst, Judge(abs(Judge(coefficient(word, weights) - (flows ? coefficient(word, {1}) : Judge(0))))));
  }
  return static_cast<double>(worst);
}

struct ACompositionMethod : testing::TestWithParam<Composition> {};
INSTANTIATE_TEST_SUITE_P(Of, ACompositionMethod, testing::ValuesIn(compositions), [](auto const& one) {
  std::string name(one.param.name);
  std::erase(name, '-');
  return name;
});

TEST_P(ACompositionMethod, SatisfiesTheConditionsOfItsOrderTo78DigitsAndNotThoseOfTheNext) {
  auto const weights = composition_weights<Judge>(GetParam());
  for (int weight = 1; weight <= GetParam().order; ++weight)
    EXPECT_LT(largest_defect(weights, weight), 2e-76) << weight;
  EXPECT_GT(largest_defect(weights, GetParam().order + 1), 1e-8);
}

TEST_P(ACompositionMethod, IsPalindromicWithSumOne) {
  auto const weights = composition_weights<Judge>(GetParam());
  EXPECT_EQ(weights.size(), static_cast<std::size_t>(GetParam().stages()));
  EXPECT_EQ(weights.size() % 2, 1U);
  Judge sum = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    EXPECT_EQ(weights[i], weights[weights.size() - 1 - i]) << i;
    sum += weights[i];
  }
  EXPECT_LT(abs(Judge(sum - 1)), Judge("1e-76"));
}

TEST_P(ACompositionMethod, HasTheSameWeightsInEveryArithmeticRoundedOnce) {
  auto const check = [&](auto zero) {
    using W = decltype(zero);
    auto const weights = composition_weights<W>(GetParam());
    auto const wide = composition_weights<Mpfr<512>>(GetParam());
    for (std::size_t i = 0; i < weights.size(); ++i)
      for (int l = 0; l < lanes<W>; ++l)
        EXPECT_EQ(lane(weights[i], l), rounded<Element<W>>(wide[i])) << i << ", lane " << l;
  };
  check(0.0F);
  check(0.0);
  check(0.0L);
  check(DoubleDouble<double>(0));
  check(Float128(0));
  check(Mpfr<128>(0));
  check(Pack<double, 4>(0));
  check(Pack<Float128, 4>(0));
}

TEST_P(ACompositionMethod, IsNamedByItsOrderAndHasASource) {
  auto const& c = GetParam();
  if (c.stages() > 1) {
    EXPECT_TRUE(c.name.ends_with("-" + std::to_string(c.order))) << c.name;
  }
  EXPECT_FALSE(c.source.empty());
}

TEST(Compositions, HaveNamesOfTheirOwn) {
  std::set<std::string_view> names;
  for (auto const& c : compositions) names.insert(c.name);
  EXPECT_EQ(names.size(), compositions.size());
}

TEST(Compositions, HaveTheirClosedForms) {
  auto const first = [](Composition const& c) { return composition_weights<Judge>(c)[0]; };
  Judge const third = Judge(1) / 3;
  EXPECT_LT(abs(Judge(first(forest_ruth_4) - 1 / (2 - pow(Judge(2), third)))), Judge("1e-75"));
  EXPECT_LT(abs(Judge(first(suzuki_4) - 1 / (4 - pow(Judge(4), third)))), Judge("1e-75"));
  EXPECT_EQ(composition_weights<double>(base_method), std::vector<double>{1});
}

/// The first digits as they were published.
struct Published {
  Composition method;
  std::vector<char const*> weights;
  char const* within;
};

TEST(Compositions, BeginWithTheDigitsOfTheirPublications) {
  std::vector<Published> const published{
      {mclachlan_4, {"0.28", "0.62546642846767004501"}, "5e-21"},
      {yoshida_6, {"0.78451361047756", "0.235573213359357", "-1.17767998417887"}, "5e-15"},
      {mclachlan_6, {"0.1867", "0.55549702371247839916", "0.12946694891347535806", "-0.84326562338773460855"}, "5e-21"},
      {kahan_li_6,
       {"0.39216144400731413928", "0.33259913678935943860", "-0.70624617255763935981", "0.08221359629355080023"},
       "5e-21"},
      {suzuki_umeno_8,
       {"0.74167036435061295345", "-0.40910082580003159400", "0.19075471029623837995", "-0.57386247111608226666",
        "0.29906418130365592384", "0.33462491824529818378", "0.31529309239676659663"},
       "5e-21"},
      {kahan_li_8,
       {"0.13020248308889008088", "0.56116298177510838456", "-0.38947496264484728641", "0.15884190655515560090",
        "-0.39590389413323757734", "0.18453964097831570709", "0.25837438768632204729", "0.29501172360931029887"},
       "7e-21"},
  };
  for (auto const& p : published) {
    auto const weights = composition_weights<Judge>(p.method);
    for (std::size_t i = 0; i < p.weights.size(); ++i)
      EXPECT_LE(abs(Judge(weights[i] - Judge(p.weights[i]))), Judge(p.within)) << p.method.name << i;
  }
}

}  // namespace
}  // namespace brouwer
