#include <brouwer/ensemble/observer.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <brouwer/spelling.hpp>

namespace brouwer {
namespace {

Series empty_series(Quantity const& quantity, std::string const& component, std::int64_t members, std::size_t samples) {
  auto const entries = static_cast<std::size_t>(members) * samples;
  return {component,
          quantity.name,
          quantity.unit,
          members,
          std::vector<double>(entries, std::numeric_limits<double>::quiet_NaN()),
          quantity.kind == Quantity::Kind::iterations};
}

}  // namespace

std::int64_t Observer::Members::of(Quantity::Kind kind) const {
  switch (kind) {
    case Quantity::Kind::integral:
      return all;
    case Quantity::Kind::state:
    case Quantity::Kind::rounding:
      return compared;
    case Quantity::Kind::iterations:
      return counted;
  }
  return 0;
}

Observer::Observer(SystemDescription const& system, std::vector<std::string> const& quantities, Members const& members,
                   std::size_t samples)
    : samples_(samples), failed_(static_cast<std::size_t>(members.all)), comparison_failed_(failed_) {
  integrals_ = add_series(system, quantities, members, Quantity::Kind::integral);
  states_ = add_series(system, quantities, members, Quantity::Kind::state);
  rounding_ = add_series(system, quantities, members, Quantity::Kind::rounding);
  iterations_ = add_series(system, quantities, members, Quantity::Kind::iterations);
  state_errors_.resize(states_.count);
  rounding_errors_.resize(integrals_.count);
}

Observer::Group Observer::add_series(SystemDescription const& system, std::vector<std::string> const& quantities,
                                     Members const& members, Quantity::Kind kind) {
  Group group;
  group.first = series_.size();
  for (auto const& quantity : system.quantities) {
    if (quantity.kind != kind) continue;
    bool const wanted = contains(quantities, quantity.name);
    needs_whole_state_ = needs_whole_state_ || (wanted && quantity.needs_whole_state);
    for (auto const& component : quantity.components) {
      if (wanted) {
        group.places.push_back(group.count);
        series_.push_back(empty_series(quantity, component, members.of(kind), samples_));
      }
      ++group.count;
    }
  }
  return group;
}

void Observer::observe(Trajectories const& trajectories, std::size_t sample, std::int64_t steps) {
  integral_errors_.resize(trajectories.members() * integrals_.count);
  trajectories.first_integral_errors(integral_errors_);
  for (std::size_t member = 0; member < trajectories.members(); ++member)
    if (trajectories.failure(member)) failed_[member] = true;  // an error may be a number all the same: 0 for a phase
  for (std::size_t member = 0; member < trajectories.members(); ++member)
    store(integrals_, std::span(integral_errors_).subspan(member * integrals_.count, integrals_.count), member, sample,
          failed_);
  if (iterations_.places.empty() || series_[iterations_.first].members == 0) return;
  for (std::size_t member = 0; member < trajectories.members(); ++member) {
    double const per_step = trajectories.iterations(member) / static_cast<double>(steps);
    store(iterations_, std::span(&per_step, 1), member, sample, failed_);
  }
}

void Observer::observe_state(Trajectories const& trajectories, std::size_t member, std::span<Widest const> reference,
                             std::size_t sample) {
  if (failed_[member]) comparison_failed_[member] = true;
  if (!states_.places.empty()) {
    trajectories.state_errors(member, reference, state_errors_);
    store(states_, state_errors_, member, sample, comparison_failed_);
  }
  if (!rounding_.places.empty()) {
    trajectories.rounding_errors(member, reference, rounding_errors_);
    store(rounding_, rounding_errors_, member, sample, comparison_failed_);
  }
}

void Observer::store(Group const& group, std::span<double const> errors, std::size_t member, std::size_t sample,
                     std::vector<bool>& failed) {
  if (failed[member]) return;
  for (std::size_t i = 0; i < group.places.size(); ++i) {
    double const error = errors[group.places[i]];
    if (!std::isfinite(error)) failed[member] = true;
    series_[group.first + i].errors[member * samples_ + sample] =
        std::isfinite(error) ? error : std::numeric_limits<double>::quiet_NaN();
  }
}

}  // namespace brouwer
