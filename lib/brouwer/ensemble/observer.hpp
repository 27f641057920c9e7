#pragma once
#include <cstdint>
#include <vector>

#include <brouwer/ensemble/catalogue.hpp>
#include <brouwer/store/record.hpp>

namespace brouwer {

/// Writes what a study asks for of a trajectory into the series of a unit.
class Observer {
 public:
  /// @param compared  how many of the unit's members have a reference
  Observer(SystemDescription const& system, std::vector<std::string> const& quantities, std::int64_t members,
           std::int64_t compared, std::size_t samples);

  /// Does anything observed need more of the state than is always integrated?
  bool needs_whole_state() const { return needs_whole_state_; }
  bool needs_reference() const { return needs_reference_; }

  /// Writes the errors of the first integrals of all members at one sample. A member one of whose errors is not finite
  /// has failed: its series stay NaN from here on.
  void observe(Trajectories const& trajectories, std::size_t sample);

  /// The same for the state of one member against `reference`.
  void observe_state(Trajectories const& trajectories, std::size_t member, std::span<Widest const> reference,
                     std::size_t sample);

  std::vector<Series> take_series() { return std::move(series_); }

 private:
  void store(std::vector<std::size_t> const& places, std::span<double const> errors, std::size_t first_series,
             std::size_t member, std::size_t sample);

  std::size_t samples_;
  bool needs_whole_state_ = false, needs_reference_ = false;
  std::vector<Series> series_;                   // first integrals, then state errors
  std::vector<std::size_t> integrals_, states_;  // which of the trajectory's errors each series is
  std::size_t integral_count_ = 0;
  std::vector<double> integral_errors_, state_errors_;  // of all members; of one
  std::vector<bool> failed_;
};

}  // namespace brouwer
