// Explicit tableaux: every condition of their order, in rational numbers.
#include <brouwer/integrators/explicit_tableaux.hpp>

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <set>
#include <string>
#include <vector>

#include "tests/contracts/field_methods.hpp"

namespace brouwer {
namespace {

using Rational = boost::multiprecision::cpp_rational;

Rational exact(Ratio const& r) { return Rational(r.numerator, r.denominator); }

/// A rooted tree: the trees that hang on its root, by their places in the list of all trees, ascending.
struct Tree {
  int order = 1;
  std::vector<std::size_t> children;
};

/// All rooted trees up to an order, by order: 1, 1, 2, 4, 9, 20, 48, 115 … of them (OEIS A000081).
std::vector<Tree> trees_up_to(int order) {
  std::vector<Tree> trees;
  for (int n = 1; n <= order; ++n) {
    std::vector<Tree> of_this_order;
    auto const hang = [&](auto const& self, Tree const& tree, std::size_t first) -> void {
      if (tree.order == n) of_this_order.push_back(tree);
      for (std::size_t child = first; child < trees.size() && tree.order + trees[child].order <= n; ++child) {
        Tree next = tree;
        next.order += trees[child].order;
        next.children.push_back(child);
        self(self, next, child);
      }
    };
    hang(hang, Tree{}, 0);
    trees.insert(trees.end(), of_this_order.begin(), of_this_order.end());
  }
  return trees;
}

/// For each tree Σ bᵢ Φᵢ(t) − 1/γ(t): Φᵢ(t) = Π Σⱼ aᵢⱼ Φⱼ(child), γ(t) = |t| Π γ(child). E. Hairer, S. P. Nørsett, G. Wanner,
/// Solving Ordinary Differential Equations I, II.2.
std::vector<Rational> defects(ExplicitTableau const& t, std::vector<Tree> const& trees) {
  auto const s = static_cast<std::size_t>(t.stages);
  std::vector<std::vector<Rational>> phi;
  std::vector<Rational> gamma, found;
  for (auto const& tree : trees) {
    std::vector<Rational> weights(s, Rational(1));
    gamma.emplace_back(tree.order);
    for (std::size_t child : tree.children) {
      gamma.back() *= gamma[child];
      for (std::size_t i = 0; i < s; ++i) {
        Rational sum = 0;
        for (std::size_t j = 0; j < i; ++j) sum += exact(t.a[i][j]) * phi[child][j];
        weights[i] *= sum;
      }
    }
    Rational sum = 0;
    for (std::size_t i = 0; i < s; ++i) sum += exact(t.b[i]) * weights[i];
    found.push_back(sum - 1 / gamma.back());
    phi.push_back(weights);
  }
  return found;
}

struct AnExplicitTableau : testing::TestWithParam<ExplicitTableau> {};
INSTANTIATE_TEST_SUITE_P(Of, AnExplicitTableau, testing::ValuesIn(explicit_tableaux()),
                         [](auto const& one) { return testing_support::identifier(one.param.name); });

TEST_P(AnExplicitTableau, SatisfiesTheConditionsOfItsOrderExactlyAndNotAllOfTheNext) {
  auto const trees = trees_up_to(GetParam().order + 1);
  auto const found = defects(GetParam(), trees);
  bool next = true;
  for (std::size_t i = 0; i < trees.size(); ++i) {
    if (trees[i].order <= GetParam().order) {
      EXPECT_EQ(found[i], 0) << "tree " << i << " of order " << trees[i].order;
    } else {
      next = next && found[i] == 0;
    }
  }
  EXPECT_FALSE(next);
}

TEST_P(AnExplicitTableau, IsExplicit) {
  auto const s = static_cast<std::size_t>(GetParam().stages);
  for (std::size_t i = 0; i < ExplicitTableau::most_stages; ++i) {
    for (std::size_t j = 0; j + 1 < ExplicitTableau::most_stages; ++j)
      if (i >= s || j >= i) {
        EXPECT_TRUE(GetParam().a[i][j].is_zero()) << i << ' ' << j;
      }
    bool const for_order_seven = GetParam().name == std::string("fehlberg-8") && i == 10;
    EXPECT_EQ(GetParam().uses(i), i < s && !for_order_seven) << i;
  }
}

TEST(ExplicitTableaux, TreesAreAsManyAsTheyShouldBe) {
  std::vector<int> counts(9, 0);
  for (auto const& tree : trees_up_to(8)) ++counts[static_cast<std::size_t>(tree.order)];
  EXPECT_EQ(counts, (std::vector<int>{0, 1, 1, 2, 4, 9, 20, 48, 115}));
}

TEST(ExplicitTableaux, FehlbergsHasItsPublishedNodes) {
  std::vector<Ratio> const nodes{{0, 1}, {2, 27}, {1, 9}, {1, 6}, {5, 12}, {1, 2}, {5, 6},
                                 {1, 6}, {2, 3},  {1, 3}, {1, 1}, {0, 1},  {1, 1}};
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    Rational sum = 0;
    for (std::size_t j = 0; j < i; ++j) sum += exact(fehlberg_8.a[i][j]);
    EXPECT_EQ(sum, exact(nodes[i])) << i;
  }
}

TEST(ExplicitTableaux, HaveNamesOfTheirOwn) {
  std::set<std::string> names;
  for (auto const& t : explicit_tableaux()) names.insert(t.name);
  EXPECT_EQ(names.size(), explicit_tableaux().size());
}

}  // namespace
}  // namespace brouwer
