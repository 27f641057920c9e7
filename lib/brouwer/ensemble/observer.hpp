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

  /// Does anything observed need the attitude?
  bool needs_attitude() const { return needs_attitude_; }
  bool needs_reference() const { return needs_reference_; }

  /// Observes one member at one sample.
  /// @param reference  the state to compare with; empty where this member has none
  /// @return false if an error is not finite: the member has failed; its series stay NaN from here on
  bool observe(Trajectory const& trajectory, std::span<Widest const> reference, std::int64_t member,
               std::size_t sample);

  std::vector<Series> take_series() { return std::move(series_); }

 private:
  bool store(std::vector<std::size_t> const& places, std::vector<double> const& errors, std::size_t first_series,
             std::int64_t member, std::size_t sample);

  std::size_t samples_;
  bool needs_attitude_ = false, needs_reference_ = false;
  std::vector<Series> series_;                   // first integrals, then state errors
  std::vector<std::size_t> integrals_, states_;  // which of the trajectory's errors each series is
  std::vector<double> integral_errors_, state_errors_;
};

}  // namespace brouwer
