#pragma once
#include <Eigen/Core>
#include <vector>

namespace brouwer {

/// A sum of mean 0 in which only the signs of numbers are random, and how far out it lies.
///
/// Under the model the increments w are independent and as often positive as negative. Given their sizes, every choice
/// of their signs is then equally likely, whatever the sizes are: a test that asks how a statistic lies among all
/// choices is exact also where the size changes with time or from member to member, and for heavy tails. (The variance
/// over all choices is the robust one of A. W. Lo & A. C. MacKinlay, Rev. Financ. Stud. 1 (1988) 41.)
///
/// The first four cumulants have closed forms, and Pearson's curve of these cumulants gives the tails (pearson.hpp). Where
/// signs are few, a few large terms decide: all choices of the largest are counted, and only the rest is fitted.
class RandomSigns {
 public:
  /// @param signs  how many there will be
  explicit RandomSigns(double signs) : signs_(signs), few_(signs <= most_kept) {}

  /// Σ aₖ εₖ with independent signs εₖ: κ₂ = Σa², κ₃ = 0, κ₄ = −2 Σa⁴.
  void add_sum(Eigen::ArrayXd const& a);

  /// (Σ aₖ εₖ)² − Σ aₖ², which the signs change in all but one; with the power sums sₙ = Σ aₖⁿ
  ///
  ///     κ₂ = 2(s₂² − s₄)     κ₃ = 8 s₂³ − 24 s₂s₄ + 16 s₆     κ₄ = 48 s₂⁴ − 288 s₂²s₄ + 128 s₄² + 384 s₂s₆ − 272 s₈
  void add_square(Eigen::Ref<Eigen::ArrayXd const> const& a);

  /// The terms of another sum beside one's own.
  RandomSigns& operator+=(RandomSigns const& other);

  /// P of a sum at least as far out as x: twice the smaller tail, at most 1; NaN where no sign changes anything.
  double two_sided(double x) const;

  static constexpr double most_kept = 512;  ///< signs of which the terms are kept

 private:
  struct Cumulants {
    double second = 0, third = 0, fourth = 0;
    Cumulants& operator+=(Cumulants const& other);
    Cumulants& operator-=(Cumulants const& other);
  };
  /// A sum, or a square of one.
  struct Term {
    Cumulants cumulants;
    Eigen::ArrayXd a;
    bool square;
    std::vector<double> values() const;  ///< each as often as any other
  };
  struct Split;
  static Cumulants of_square(Eigen::Ref<Eigen::ArrayXd const> const& a);
  Split split() const;

  double signs_;
  bool few_;
  Cumulants cumulants_;
  std::vector<Term> terms_;  // while they are few
};

}  // namespace brouwer
