#pragma once
#include <cstdint>
#include <optional>

#include "analysis/estimates.hpp"

namespace brouwer {

/// What decides how well an ensemble's drift is known: β̂ of M members over N steps has the variance (σ²/N + τ²)/M.
/// Noise that does not grow plays no part in a long run.
struct Spread {
  double diffusion = 0;    ///< σ, per √step
  double persistence = 0;  ///< τ, per step
};

/// The two questions to a drift x: is it seen, if it is there — and is it excluded, if there is none?
enum class Question {
  see,      ///< the t test at levels.test finds a drift of x
  exclude,  ///< the interval of levels.confidence of β̂ lies inside ±x where β = 0: two one-sided tests at half of what
            ///< that leaves [D. J. Schuirmann, J. Pharmacokin. Biopharm. 15 (1987) 657]
};

/// x over the standard error of β̂ at which the answer is yes with the chance levels.power. See: visible_noncentrality.
/// Exclude: the δ with P(|β̂| + t s < δ) = levels.power, integrated over the χ law of s.
/// @param members  at least 2
double needed_noncentrality(Question question, std::int64_t members, Levels const& levels);

/// The smallest drift per step of which the answer is yes, with `members` members over `steps` steps; NaN for one member.
double answerable_drift(Question question, Spread const& spread, std::int64_t members, std::int64_t steps,
                        Levels const& levels);

/// How many steps each of `members` members needs; nothing where no number does, because τ alone hides the drift.
std::optional<double> steps_needed(Question question, double drift, Spread const& spread, std::int64_t members,
                                   Levels const& levels);

/// How many members over `steps` steps are needed; nothing where 10¹⁵ are too few.
std::optional<std::int64_t> members_needed(Question question, double drift, Spread const& spread, double steps,
                                           Levels const& levels);

}  // namespace brouwer
