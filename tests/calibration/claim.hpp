#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tests/calibration/model.hpp"
#include "tests/calibration/rate.hpp"

namespace brouwer::calibration {

/// A statement about how often something is so, asked of every trial to which it applies.
struct Claim {
  char const* name;
  Nominal nominal;
  std::optional<bool> (*asked)(Trial const&);  ///< nothing where it does not apply
  std::vector<std::string> asked_of;           ///< models; empty: all that have the truth
  std::vector<std::string> promised_for;       ///< of other models the rate is told, and nothing promised
  int fewest_members = 2;                      ///< of the promise
  int fewest_samples = 2;                      ///< of the promise
  bool strict = false;                         ///< at the level 0.001: worth a table row in a design of many trials
};

std::span<Claim const> claims();

/// Is the rate asked of this model, and is it promised?
bool is_asked(Claim const& claim, Model const& model);
bool is_promised(Claim const& claim, Model const& model, Design const& design);

}  // namespace brouwer::calibration
