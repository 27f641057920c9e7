#pragma once
#include <algorithm>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>

#include <brouwer/ensemble/trajectory.hpp>
#include <brouwer/integrators/stepper.hpp>
#include <brouwer/scalar/wider.hpp>
#include <brouwer/systems/exact_flow.hpp>

namespace brouwer {

/// A trajectory with its types: the stepper S, and Y, its state or its compensated state. Everything that is observed
/// is formed in Wider<T>, where a state of T is exact, and rounded once.
template <Stepper S, class Y>
class Member final : public Trajectory {
 public:
  using T = typename S::Scalar;
  using W = Wider<T>;
  using System = typename S::System;
  using WideSystem = typename System::template In<W>;
  using WideState = typename WideSystem::State;

  explicit Member(Setup<System> const& setup)
      : stepper_(setup), now_(setup.start), step_(setup.step), system_(setup.system.template in<W>()) {
    start_ = widened();
    start_integrals_ = system_.first_integrals(start_);
    scales_ = system_.first_integral_scales(start_);
  }

  void advance(std::int64_t steps) override { brouwer::advance(stepper_, now_, steps); }

  void state(std::span<Widest> components) const override { write(widened(), components); }

  void first_integrals(std::span<Widest> values) const override {
    require_room(values.size(), System::first_integral_count);
    auto const integrals = system_.first_integrals(widened());
    std::transform(integrals.begin(), integrals.end(), values.begin(), [](W const& v) { return Widest(v); });
  }

  void first_integral_errors(std::span<double> errors) const override {
    require_room(errors.size(), System::first_integral_count);
    auto const integrals = system_.first_integrals(widened());
    for (std::size_t i = 0; i < integrals.size(); ++i)
      errors[i] = static_cast<double>(W((integrals[i] - start_integrals_[i]) / scales_[i]));
  }

  void state_errors(std::span<Widest const> reference, std::span<double> errors) const override {
    require_room(errors.size(), System::state_error_count);
    auto const e = system_.state_errors(widened(), read(reference));
    std::transform(e.begin(), e.end(), errors.begin(), [](W const& v) { return static_cast<double>(v); });
  }

  void exact_state(std::int64_t steps, std::span<Widest> components) const override {
    if constexpr (HasExactFlow<WideSystem>) {
      if (!exact_.flow) exact_.flow = std::make_shared<typename ExactFlow<WideSystem>::type>(system_, start_);
      write((*exact_.flow)(W(W(steps) * W(step_))), components);
    } else {
      (void)steps, (void)components;
      throw std::logic_error("the system has no exact flow");
    }
  }

 private:
  static constexpr bool compensated = !std::same_as<Y, typename S::State>;

  /// The state that is meant: with the residue, where one is carried.
  WideState widened() const {
    WideState wide{};
    if constexpr (compensated)
      for_components([](W& w, T const& v, T const& r) { w = W(v) + W(r); }, wide, now_.value, now_.residue);
    else
      for_components([](W& w, T const& v) { w = W(v); }, wide, now_);
    return wide;
  }

  /// A system's description and its class must speak of the same quantities: a user's own may not.
  static void require_room(std::size_t room, std::size_t needed) {
    if (room != needed)
      throw std::logic_error("the system gives " + std::to_string(needed) + " numbers where its description has " +
                             std::to_string(room));
  }

  static void write(WideState state, std::span<Widest> components) {
    auto next = components.begin();
    for_components([&next](W const& v) { *next++ = Widest(v); }, state);
  }

  static WideState read(std::span<Widest const> components) {
    WideState state{};
    auto next = components.begin();
    for_components([&next](W& v) { v = static_cast<W>(*next++); }, state);
    return state;
  }

  S stepper_;
  Y now_;
  T step_;
  WideSystem system_;
  WideState start_;
  std::array<W, System::first_integral_count> start_integrals_, scales_;
  // built when first asked for: most members have no reference
  mutable FlowHolder<WideSystem> exact_;
};

/// A trajectory of stepper S from a request: the doubles of the request are rounded to the arithmetic here, and
/// nowhere else.
template <Stepper S>
std::unique_ptr<Trajectory> begin_member(TrajectoryRequest const& request) {
  using T = typename S::Scalar;
  using System = typename S::System;
  auto const in_arithmetic = [](std::vector<double> const& values) {
    return std::vector<T>(values.begin(), values.end());
  };
  auto const parameters = in_arithmetic(request.parameters), start = in_arithmetic(request.start);
  Setup<System> const setup{System(std::span<T const>(parameters)), static_cast<T>(request.step),
                            System::State::from_components(start), request.attitude};
  if constexpr (IncrementStepper<S>)
    if (request.compensation) return std::make_unique<Member<S, Compensated<typename S::State>>>(setup);
  return std::make_unique<Member<S, typename S::State>>(setup);
}

}  // namespace brouwer
