#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <brouwer/ensemble/instruction_set.hpp>
#include <brouwer/ensemble/study.hpp>
#include <brouwer/ensemble/trajectories.hpp>
#include <brouwer/systems/description.hpp>

namespace brouwer {

/// Turns names into running trajectories; gives nothing where it does not know the combination.
struct TrajectoriesMaker {
  InstructionSet set = InstructionSet::none;  ///< none: one number a scalar; else with a member in each lane of a pack
  std::function<std::unique_ptr<Trajectories>(TrajectoryRequest const&)> begin;
};

/// A method as data, and what turns names into running trajectories.
struct MethodEntry {
  std::string name;                     ///< elliptic-naive
  std::string system;                   ///< rigid_body
  std::string summary;                  ///< one line
  std::string source;                   ///< the publication
  int order = 0;                        ///< 0: exact up to rounding
  bool compensable = false;             ///< has an increment to be summed with compensation
  bool uses_special_functions = false;  ///< the variants own, gsl, boost apply
  std::vector<std::string>
      coefficients;                ///< levels of the factor `coefficients` that it has, the first is the standard
  bool counts_iterations = false;  ///< the quantity `iterations` applies
  bool uses_libm = false;          ///< sin, cos, atan …: bits depend on the machine's libm
  bool runs_in_lanes = false;  ///< has no branch on data that cannot be masked: packs of float, double, double-double
  std::vector<TrajectoriesMaker> makers;
};

struct ArithmeticEntry {
  std::string name;  ///< double
  int bits = 0;      ///< significand
  std::string summary;
};

/// Every name that a study may use. `builtin_catalogue()` is the only place where names meet types;
/// a user's own program adds entries and hands the catalogue to the `brouwer` command line.
class Catalogue {
 public:
  std::vector<SystemDescription> systems;
  std::vector<MethodEntry> methods;
  std::vector<ArithmeticEntry> arithmetics;

  /// With the quantities that every system has.
  void add(SystemDescription const& system);

  /// @throws InputError "there is no method 'x'; did you mean 'y'?" where there is no such name.
  SystemDescription const& system(std::string const& name) const;
  MethodEntry const& method(std::string const& system, std::string const& name) const;
  MethodEntry& method(std::string const& system, std::string const& name);
  ArithmeticEntry const& arithmetic(std::string const& name) const;
  Quantity const& quantity(std::string const& system, std::string const& name) const;
};

/// "own, gsl, boost": variants of the elliptic functions, and whether one exists in an arithmetic.
std::vector<std::string> const& special_function_variants();
bool variant_exists(std::string const& variant, std::string const& arithmetic);

/// Levels of the factor `coefficients` that any method of a system has, each once.
std::vector<std::string> coefficient_levels(Catalogue const& catalogue, std::string const& system);

Catalogue builtin_catalogue();

}  // namespace brouwer
