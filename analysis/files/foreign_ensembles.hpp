#pragma once
// What the readers of other programs' files have in common, text or HDF5.
#include <brouwer/store/results.hpp>
#include <string>

namespace brouwer {

/// Names under which the times may go, the best first, and the unit they imply.
struct TimeName {
  char const* name;
  char const* unit;
};
constexpr TimeName time_names[] = {
    {"time", "time unit"}, {"times", "time unit"}, {"t", "time unit"}, {"steps", "step"}, {"step", "step"}};

/// @param where  begins the complaint: "energies.h5: 'leapfrog/energy'"
/// @param of     "" or " of 'energy'"
/// @throws InputError about a single member or a single time
void require_an_ensemble(Ensemble const& ensemble, std::string const& where, std::string const& of = "");

}  // namespace brouwer
