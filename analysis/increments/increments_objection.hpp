#pragma once
#include <string>

#include "analysis/estimates.hpp"

namespace brouwer {

/// Where the increments contradict the model so much that its numbers change, what follows, in a sentence (two where
/// they do so twice); otherwise nothing. Of a walk, a drift, slopes or nothing resolved: that increments of a bounded
/// error or of a phase are correlated is what these words mean. A test counts at levels.test and an effect from the
/// sizes below on, because a p alone says how large the ensemble is.
std::string increments_objection(Estimates const& e);

/// The ratio that is told from 1 most surely. @param scales  not empty
VarianceRatio const& clearest_ratio(std::vector<VarianceRatio> const& scales);

constexpr double telling_correlation = 0.05;  ///< |ρ₁|: the variance of two together is off by 5 %
constexpr double telling_ratio = 0.1;         ///< |V − 1| at the clearest scale
constexpr double telling_kurtosis = 1;        ///< the interval of σ is off by 20 %
constexpr double telling_skewness = 0.5;

}  // namespace brouwer
