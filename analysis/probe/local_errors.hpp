#pragma once
#include <brouwer/store/local_errors.hpp>
#include <optional>

#include "analysis/estimates.hpp"

namespace brouwer {

/// What the steps of an ensemble add up to, from windows of consecutive steps: per step, of the quantity's scale.
struct LocalLaw {
  Drift bias;                           ///< mean of a local error; its `share` is |bias| / RMS
  double size = 0;                      ///< RMS of a local error
  Diffusion diffusion;                  ///< √(var (1 + 2 Σ ρₖ)): what a walk of these steps has per √step
  Persistence persistence;              ///< of the members' own biases
  std::vector<double> autocorrelation;  ///< ρ₁, ρ₂, … of consecutive local errors, at most eight
  std::vector<double> scales;           ///< σ from sums of 1, 2, 4, … steps, up to a window
  /// σ²_L of whole windows differs from that of half ones by more than chance at levels.test, and by more than a tenth:
  /// local errors are correlated over more than a window, and σ is that of whole windows.
  bool still_changing = false;
};

/// Everything that the inference says of the local errors of one quantity of one cell.
struct LocalEstimates {
  CellLabels cell;
  std::string high_precision, quantity, family, unit;
  bool of_state = false;
  std::int64_t members = 0, failed = 0, windows = 0, length = 0, judged = 0, covered = 0;
  std::vector<Failures> failures;
  LocalLaw rounding;
  std::optional<LocalLaw> truncation;  ///< of the method itself; not of the state
  std::optional<LocalLaw> both;        ///< their sum, where the method does not conserve the quantity
  Levels levels;
};

/// Model: a local error of member i is β + bᵢ + a stationary sequence, bᵢ ~ N(0, τ²); windows w = 1 … W of L steps of a
/// member are so far apart that they are independent. With their means y_iw, and m_i that of member i:
///
///     σ̂²_L = L Σ (y_iw − m_i)² / (M(W−1))       estimates var (1 + 2 Σ_{k<L} (1 − k/L) ρₖ)
///     σ̂²   = 2 σ̂²_L − σ̂²_{L/2}                  without the bias of order 1/L [lugsail: D. Vats & J. M. Flegal,
///                                                Biometrika 109 (2022) 735]; interval: Student's t over the members;
///                                                σ̂²_L where it is still changing, for then it would lead anywhere
///     β̂    = mean m_i                           t(M−1), over the members
///     F    = W L var(m_i) / σ̂²_L                F(M−1, M(W−1)) for τ = 0; the interval of τ is F's
///     τ̂²   = max(0, var(m_i) − σ̂²_L/(W L))
///
/// @throws InputError where fewer than two members came through
LocalEstimates estimate(LocalErrors const& errors, Levels const& levels);

/// What a run of `steps` steps is to show, if it goes on as the local errors were. What is not predicted is NaN.
struct Prediction {
  Drift drift;  ///< per step, with its interval
  Diffusion
      diffusion;  ///< NaN where the method's own error exceeds a tenth of rounding: it oscillates, it does not walk
  Persistence persistence;  ///< τ, and F = 1 + τ² N/σ² as a run of N steps has it
  double rms_final = 0;     ///< √((β² + τ²) N² + σ² N), β and τ as far as they are seen at levels.test
};

/// Of a first integral; nothing of the state, whose local errors later steps change.
std::optional<Prediction> predict(LocalEstimates const& local, std::int64_t steps);

}  // namespace brouwer
