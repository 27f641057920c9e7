#pragma once
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include <brouwer/systems/description.hpp>
#include <brouwer/systems/phase_state.hpp>

namespace brouwer {

// What systems of phase space have in common: how two of their states differ, and how their descriptions speak of it.

template <Real T, std::size_t n>
std::array<T, n> difference(std::array<T, n> const& a, std::array<T, n> const& b) {
  std::array<T, n> d{};
  for (std::size_t i = 0; i < n; ++i) d[i] = a[i] - b[i];
  return d;
}

/// ⟨a, b⟩, summed in the order of the components.
template <Real T, std::size_t n>
T inner_product(std::array<T, n> const& a, std::array<T, n> const& b) {
  T sum = a[0] * b[0];
  for (std::size_t i = 1; i < n; ++i) sum = sum + a[i] * b[i];
  return sum;
}

/// ahead / speed², the time by which what is `ahead` = ⟨y − y*, ẏ*⟩ away precedes the reference; 0 where nothing moves.
template <Real T>
T time_ahead(T const& ahead, T const& speed2) {
  auto const moves = speed2 > T(0);
  return select(moves, T(ahead / select(moves, speed2, T(1))), T(0));
}

/// a where it is positive, otherwise 1: what errors are divided by.
template <Real T>
T or_one(T const& a) {
  return select(a > T(0), a, T(1));
}

/// q − q*, p − p*, and the phase ⟨y − y*, ẏ*⟩ / |ẏ*|² with y = (q, p): by how much time y runs ahead of the reference.
template <class System, Real T, int n>
std::array<T, 2 * n + 1> phase_space_errors(System const& system, PhaseState<T, n> const& y,
                                            PhaseState<T, n> const& reference) {
  auto const rate = system.rate(reference);
  auto const dq = difference(y.q, reference.q), dp = difference(y.p, reference.p);
  std::array<T, 2 * n + 1> errors{};
  std::copy_n(dq.begin(), n, errors.begin());
  std::copy_n(dp.begin(), n, errors.begin() + n);
  errors[2 * n] = time_ahead(T(inner_product(dq, rate.q) + inner_product(dp, rate.p)),
                             T(inner_product(rate.q, rate.q) + inner_product(rate.p, rate.p)));
  return errors;
}

// --- descriptions -----------------------------------------------------------------------------------------------------

/// H, in words: "energy", relative to its size at the start.
inline Quantity energy_quantity(std::string const& help) {
  return {"energy", {"energy"}, "relative", Quantity::Kind::integral, false, help};
}

/// The components of q − q*, p − p*: position-1 …, momentum-1 …
inline Quantity state_quantity(std::size_t degrees, std::string const& unit) {
  Quantity state{"state", {}, unit, Quantity::Kind::state, false, "q - q*, p - p*"};
  for (char const* part : {"position", "momentum"})
    for (std::size_t i = 1; i <= degrees; ++i)
      state.components.push_back(degrees == 1 ? std::string(part) : std::string(part) + '-' + std::to_string(i));
  return state;
}

inline Quantity phase_quantity() {
  return {"phase", {"phase"},
          "time",  Quantity::Kind::state,
          false,   "by how much time the state runs ahead of the reference, <y - y*, y*'> / |y*'|^2 with y = (q, p)"};
}

/// The first field that holds a number that is none, or nothing: what every system refuses.
inline std::optional<std::string> finite_complaint(FieldValues const& values) {
  for (auto const& [name, numbers] : values)
    for (double number : numbers)
      if (!std::isfinite(number))
        return name + " must be " + (numbers.size() == 1 ? "a finite number" : "finite numbers");
  return std::nullopt;
}

}  // namespace brouwer
