#include <brouwer/ensemble/observer.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace brouwer {
namespace {

bool contains(std::vector<std::string> const& names, std::string const& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

Series empty_series(Quantity const& quantity, std::string const& component, std::int64_t members, std::size_t samples) {
  auto const entries = static_cast<std::size_t>(members) * samples;
  return {component, quantity.name, quantity.unit, members,
          std::vector<double>(entries, std::numeric_limits<double>::quiet_NaN())};
}

}  // namespace

Observer::Observer(SystemDescription const& system, std::vector<std::string> const& quantities, std::int64_t members,
                   std::int64_t compared, std::size_t samples)
    : samples_(samples), failed_(static_cast<std::size_t>(members)) {
  for (bool const with_reference : {false, true}) {
    auto& places = with_reference ? states_ : integrals_;
    std::size_t place = 0;
    for (auto const& quantity : system.quantities) {
      if (quantity.needs_reference() != with_reference) continue;
      bool const wanted = contains(quantities, quantity.name);
      needs_whole_state_ = needs_whole_state_ || (wanted && quantity.needs_whole_state);
      needs_reference_ = needs_reference_ || (wanted && with_reference);
      for (auto const& component : quantity.components) {
        if (wanted) {
          places.push_back(place);
          series_.push_back(empty_series(quantity, component, with_reference ? compared : members, samples));
        }
        ++place;
      }
    }
    if (with_reference)
      state_errors_.resize(place);
    else
      integral_count_ = place;
  }
}

void Observer::observe(Trajectories const& trajectories, std::size_t sample) {
  integral_errors_.resize(trajectories.members() * integral_count_);
  trajectories.first_integral_errors(integral_errors_);
  for (std::size_t member = 0; member < trajectories.members(); ++member)
    store(integrals_, std::span(integral_errors_).subspan(member * integral_count_, integral_count_), 0, member,
          sample);
}

void Observer::observe_state(Trajectories const& trajectories, std::size_t member, std::span<Widest const> reference,
                             std::size_t sample) {
  trajectories.state_errors(member, reference, state_errors_);
  store(states_, state_errors_, integrals_.size(), member, sample);
}

void Observer::store(std::vector<std::size_t> const& places, std::span<double const> errors, std::size_t first_series,
                     std::size_t member, std::size_t sample) {
  if (failed_[member]) return;
  for (std::size_t i = 0; i < places.size(); ++i) {
    double const error = errors[places[i]];
    if (!std::isfinite(error)) failed_[member] = true;
    series_[first_series + i].errors[member * samples_ + sample] =
        std::isfinite(error) ? error : std::numeric_limits<double>::quiet_NaN();
  }
}

}  // namespace brouwer
