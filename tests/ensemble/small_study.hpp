#pragma once
#include <brouwer/ensemble/plan.hpp>

namespace brouwer::testing_support {

/// A study of the standard body that runs in milliseconds; tests change what they are about.
inline Study small_study() {
  Study study;
  study.name = "small";
  study.system = "rigid_body";
  study.values = {{"inertia", {0.6, 0.8, 1.0}}, {"momentum", {1.8, 0.4, -0.9}}, {"attitude", {1, 0, 0, 0}}};
  study.methods = {"elliptic-increment", "dmv-2"};
  study.arithmetics = {"double"};
  study.special_functions = {"own"};
  study.compensation = {false, true};
  study.step = {0.05};
  study.steps = 200;
  study.members = 20;
  study.seed = 7;
  study.perturb = {{"momentum", {Perturbation::Law::uniform, 1e-2}}};
  study.quantities = {"energy", "spatial-momentum", "state"};
  study.reference = {Reference::Kind::exact, "", 4};
  study.samples = {8, Samples::Spacing::log};
  return study;
}

/// Levels of a factor that a method may not have.
inline std::vector<std::string> levels_or_none(std::vector<std::string> levels) {
  return levels.empty() ? std::vector<std::string>{no_level} : levels;
}

/// The standard start of any system.
inline Study standard_study(SystemDescription const& system) {
  Study study;
  study.system = system.name;
  for (auto const& field : system.fields) study.values[field.name] = field.standard;
  return study;
}

}  // namespace brouwer::testing_support
