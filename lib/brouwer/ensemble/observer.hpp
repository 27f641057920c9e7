#pragma once
#include <cstdint>
#include <vector>

#include <brouwer/ensemble/catalogue.hpp>
#include <brouwer/store/record.hpp>

namespace brouwer {

/// Writes what a study asks for of a trajectory into the series of a unit.
class Observer {
 public:
  /// How many of a unit's members have what: a reference, a count of iterations.
  struct Members {
    std::int64_t all = 1, compared = 1, counted = 1;
    std::int64_t of(Quantity::Kind kind) const;
  };
  Observer(SystemDescription const& system, std::vector<std::string> const& quantities, Members const& members,
           std::size_t samples);

  /// Does anything observed need more of the state than is always integrated?
  bool needs_whole_state() const { return needs_whole_state_; }
  bool needs_reference() const { return !states_.places.empty() || !rounding_.places.empty(); }

  /// Writes the errors of the first integrals of all members at one sample, and the turns of their iterations per step up
  /// to it. A member that has failed, or one of whose errors is not finite, is NaN from here on.
  /// @param steps  since the start
  void observe(Trajectories const& trajectories, std::size_t sample, std::int64_t steps);

  /// The same for one member's state and first integrals against `reference`.
  void observe_state(Trajectories const& trajectories, std::size_t member, std::span<Widest const> reference,
                     std::size_t sample);

  /// From here on there is nothing that this member can be compared with.
  void lose_reference(std::size_t member) { comparison_failed_[member] = true; }

  std::vector<Series> take_series() { return std::move(series_); }

 private:
  /// The series that the quantities of a kind fill.
  struct Group {
    std::vector<std::size_t> places;  ///< which of the errors that a trajectory gives
    std::size_t first = 0;            ///< their first series; the others follow
    std::size_t count = 0;            ///< errors that a trajectory gives
  };
  Group add_series(SystemDescription const& system, std::vector<std::string> const& quantities, Members const& members,
                   Quantity::Kind kind);
  /// Nothing where `failed` has the member, which it gets where an error is not finite.
  void store(Group const& group, std::span<double const> errors, std::size_t member, std::size_t sample,
             std::vector<bool>& failed);

  std::size_t samples_;
  bool needs_whole_state_ = false;
  std::vector<Series> series_;
  Group integrals_, states_, rounding_, iterations_;
  std::vector<double> integral_errors_;                 // of all members
  std::vector<double> state_errors_, rounding_errors_;  // of one
  std::vector<bool> failed_, comparison_failed_;        // by itself; against the reference, or by itself
};

}  // namespace brouwer
