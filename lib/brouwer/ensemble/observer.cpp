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
    : samples_(samples) {
  for (bool const with_reference : {false, true}) {
    auto& places = with_reference ? states_ : integrals_;
    std::size_t place = 0;
    for (auto const& quantity : system.quantities) {
      if (quantity.needs_reference != with_reference) continue;
      bool const wanted = contains(quantities, quantity.name);
      needs_attitude_ = needs_attitude_ || (wanted && quantity.needs_attitude);
      needs_reference_ = needs_reference_ || (wanted && with_reference);
      for (auto const& component : quantity.components) {
        if (wanted) {
          places.push_back(place);
          series_.push_back(empty_series(quantity, component, with_reference ? compared : members, samples));
        }
        ++place;
      }
    }
    (with_reference ? state_errors_ : integral_errors_).resize(place);
  }
}

bool Observer::observe(Trajectory const& trajectory, std::span<Widest const> reference, std::int64_t member,
                       std::size_t sample) {
  trajectory.first_integral_errors(integral_errors_);
  bool finite = store(integrals_, integral_errors_, 0, member, sample);
  if (reference.empty() || states_.empty()) return finite;
  trajectory.state_errors(reference, state_errors_);
  return store(states_, state_errors_, integrals_.size(), member, sample) && finite;
}

bool Observer::store(std::vector<std::size_t> const& places, std::vector<double> const& errors,
                     std::size_t first_series, std::int64_t member, std::size_t sample) {
  bool finite = true;
  for (std::size_t i = 0; i < places.size(); ++i) {
    double const error = errors[places[i]];
    finite = finite && std::isfinite(error);
    series_[first_series + i].errors[static_cast<std::size_t>(member) * samples_ + sample] =
        std::isfinite(error) ? error : std::numeric_limits<double>::quiet_NaN();
  }
  return finite;
}

}  // namespace brouwer
