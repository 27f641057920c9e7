#pragma once
#include <algorithm>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>

#include <brouwer/ensemble/member_operations.hpp>
#include <brouwer/ensemble/trajectories.hpp>
#include <brouwer/integrators/stepper.hpp>
#include <brouwer/scalar/observing.hpp>
#include <brouwer/systems/exact_flow.hpp>
#include <brouwer/systems/system.hpp>

namespace brouwer {

/// Members of a system over the scalar T: everything about them but their stepper. Where T is a pack, member i is lane
/// i mod N of pack i div N; the lanes of the last pack that have no member repeat the last one.
template <class System>
class TrajectoriesIn : public Trajectories {
 public:
  using T = typename System::Scalar;
  using State = typename System::State;
  using E = Element<T>;  ///< one member's arithmetic, and W what judges it
  using W = Wider<E>;
  using O = Observing<T>;  ///< what observes a pack
  using WideSystem = typename System::template In<W>;
  using WideState = typename WideSystem::State;
  using ObservingSystem = typename System::template In<O>;
  using ObservedState = typename ObservingSystem::State;

  std::size_t members() const final { return starts_.size(); }

  void state(std::size_t member, std::span<Widest> components) const final {
    auto next = components.begin();
    visit_member<Widest>(member, [&next](Widest const& v) { *next++ = v; });
  }

  void first_integrals(std::size_t member, std::span<Widest> values) const final {
    require_room(values.size(), System::first_integral_count);
    auto const integrals = brouwer::first_integrals(wide_system(member), wide_state(member), W(step_));
    std::transform(integrals.begin(), integrals.end(), values.begin(), [](W const& v) { return Widest(v); });
  }

  void first_integral_errors(std::span<double> errors) const final {
    constexpr std::size_t count = System::first_integral_count;
    require_room(errors.size(), count * starts_.size());
    for (std::size_t p = 0; p < packs(); ++p) {
      auto const integrals = brouwer::first_integrals(origins_[p].system, observed(now(p)), O(T(step_)));
      for (std::size_t k = 0; k < count; ++k) {
        O const error = (integrals[k] - origins_[p].integrals[k]) / origins_[p].scales[k];
        for (std::size_t i = p * lane_count; i < std::min((p + 1) * lane_count, starts_.size()); ++i)
          errors[i * count + k] = static_cast<double>(lane(error, lane_of(i)));
      }
    }
  }

  void state_errors(std::size_t member, std::span<Widest const> reference, std::span<double> errors) const final {
    require_room(errors.size(), System::state_error_count);
    auto const e = wide_system(member).state_errors(wide_state(member), read(reference));
    std::transform(e.begin(), e.end(), errors.begin(), [](W const& v) { return static_cast<double>(v); });
  }

  void rounding_errors(std::size_t member, std::span<Widest const> reference, std::span<double> errors) const final {
    require_room(errors.size(), System::first_integral_count);
    auto const system = wide_system(member);
    auto const scales = system.first_integral_scales(wide_start(member));
    auto const own = brouwer::first_integrals(system, wide_state(member), W(step_));
    auto const its = brouwer::first_integrals(system, read(reference), W(step_));
    for (std::size_t k = 0; k < errors.size(); ++k) errors[k] = static_cast<double>(W((own[k] - its[k]) / scales[k]));
  }

  void exact_state(std::size_t member, std::int64_t steps, std::span<Widest> components) const final {
    if constexpr (lane_count == 1 && HasExactFlow<WideSystem>) {
      auto& flow = flows_[member].flow;
      if (!flow) flow = std::make_shared<typename ExactFlow<WideSystem>::type>(wide_system(member), wide_start(member));
      auto const exact = (*flow)(W(W(steps) * W(step_)));
      auto next = components.begin();
      for_components([&next](W const& v) { *next++ = Widest(v); }, exact);
    } else {
      (void)member, (void)steps, (void)components;
      throw std::logic_error("these trajectories have no exact flow");
    }
  }

 protected:
  static constexpr std::size_t lane_count = lanes<T>;
  static int lane_of(std::size_t member) { return static_cast<int>(member % lane_count); }

  explicit TrajectoriesIn(TrajectoryRequest const& request)
      : step_(static_cast<E>(request.step)), starts_(request.starts), flows_(starts_.size()) {
    for (std::size_t p = 0; p < packs(); ++p) {
      auto const pack = setup(p, request.whole_state);
      origins_.emplace_back(pack.system.template in<O>(), observed({pack.start, nullptr}), O(pack.step));
    }
  }

  std::size_t packs() const { return (starts_.size() + lane_count - 1) / lane_count; }

  /// What the stepper of a pack is made from.
  Setup<System> setup(std::size_t pack, bool whole_state) const {
    auto const parameters = gathered(pack, starts_.front().parameters.size(), [](Start const& start, std::size_t n) {
      return static_cast<E>(start.parameters[n]);
    });
    auto const state = gathered(pack, starts_.front().state.size(), state_number<E>);
    return {System(std::span<T const>(parameters)), T(step_), State::from_components(state), whole_state};
  }

  /// A pack's state, and what rounding has cost it so far where that is carried along.
  struct Now {
    State const& value;
    State const* residue;
  };
  virtual Now now(std::size_t pack) const = 0;

 private:
  /// What a pack's errors are relative to.
  struct Origin {
    ObservingSystem system;
    std::array<O, System::first_integral_count> integrals, scales;
    Origin(ObservingSystem const& s, ObservedState const& start, O const& h)
        : system(s), integrals(brouwer::first_integrals(s, start, h)), scales(s.first_integral_scales(start)) {}
  };

  /// A number of the state that is meant: state + state_rest, rounded to the arithmetic V.
  template <class V>
  static V state_number(Start const& start, std::size_t n) {
    V const number = static_cast<V>(start.state[n]);
    return start.state_rest.empty() ? number : V(number + static_cast<V>(start.state_rest[n]));
  }

  /// number_of(start, n) for n = 0 … size − 1, one scalar a number: doubles are rounded to the arithmetic here, and nowhere
  /// else.
  template <class NumberOf>
  std::vector<T> gathered(std::size_t pack, std::size_t size, NumberOf number_of) const {
    std::vector<T> numbers(size);
    for (std::size_t n = 0; n < size; ++n)
      numbers[n] = from_lanes<T>([&](int l) {
        std::size_t const member = std::min(pack * lane_count + static_cast<std::size_t>(l), starts_.size() - 1);
        return number_of(starts_[member], n);
      });
    return numbers;
  }

  /// The states that are meant: with the residue, where one is carried.
  static ObservedState observed(Now const& y) {
    ObservedState wide{};
    if (y.residue)
      for_components([](O& w, T const& v, T const& r) { w = O(v) + O(r); }, wide, y.value, *y.residue);
    else
      for_components([](O& w, T const& v) { w = O(v); }, wide, y.value);
    return wide;
  }

  /// Calls f with each component of one member's state, in the arithmetic V.
  template <class V, class F>
  void visit_member(std::size_t member, F f) const {
    auto const y = now(member / lane_count);
    int const l = lane_of(member);
    if (y.residue)
      for_components([&](T const& v, T const& r) { f(V(V(lane(v, l)) + V(lane(r, l)))); }, y.value, *y.residue);
    else
      for_components([&](T const& v) { f(V(lane(v, l))); }, y.value);
  }

  WideState wide_state(std::size_t member) const {
    std::vector<W> components;
    visit_member<W>(member, [&](W const& v) { components.push_back(v); });
    return WideState::from_components(components);
  }
  WideState wide_start(std::size_t member) const {
    std::vector<W> components;
    for (std::size_t n = 0; n < starts_[member].state.size(); ++n)
      components.emplace_back(state_number<E>(starts_[member], n));
    return WideState::from_components(components);
  }
  WideSystem wide_system(std::size_t member) const {
    std::vector<E> const parameters(starts_[member].parameters.begin(), starts_[member].parameters.end());
    using OneSystem = typename System::template In<E>;
    return OneSystem(std::span<E const>(parameters)).template in<W>();
  }

  /// A system's description and its class must speak of the same quantities: a user's own may not.
  static void require_room(std::size_t room, std::size_t needed) {
    if (room != needed)
      throw std::logic_error("the system gives " + std::to_string(needed) + " numbers where its description has " +
                             std::to_string(room));
  }

  static WideState read(std::span<Widest const> components) {
    std::vector<W> numbers;
    for (auto const& component : components) numbers.push_back(static_cast<W>(component));
    return WideState::from_components(numbers);
  }

  E step_;
  std::vector<Start> starts_;
  std::vector<Origin> origins_;
  // built when first asked for: most members have no reference
  mutable std::vector<FlowHolder<WideSystem>> flows_;
};

/// The same with their step S, and Y, its state or its compensated state.
template <Step S, class Y>
class TrajectoriesOf final : public TrajectoriesIn<typename S::System> {
 public:
  using Base = TrajectoriesIn<typename S::System>;
  using T = typename Base::T;

  /// @param stepper  makes the step of a pack from a Setup
  template <class Make>
  TrajectoriesOf(TrajectoryRequest const& request, Make const& stepper)
      : Base(request), operations_(request), turns_(request.starts.size(), 0), failures_(request.starts.size()) {
    [[maybe_unused]] auto const scope = operations_.forming_constants();
    for (std::size_t p = 0; p < this->packs(); ++p) {
      auto const setup = this->setup(p, request.whole_state);
      steppers_.push_back(stepper(setup));
      now_.emplace_back(setup.start);
    }
    note_failures(0);
  }

  void advance(std::int64_t steps) override {
    before_ = now_;
    operations_.remember();
    if constexpr (CountsIterations<S>)
      advance_counting(steps);
    else
      advance_all(steps);
    note_failures(steps);
    made_ += steps;
  }

  double iterations(std::size_t member) const override {
    return CountsIterations<S> ? turns_[member] : std::numeric_limits<double>::quiet_NaN();
  }

  std::optional<MemberFailure> failure(std::size_t member) const override { return failures_[member]; }

 private:
  /// Enough for the instructions of one pack to fill the latencies of another, and for all to stay in 48 KB: measured in
  /// docs/performance.md.
  static constexpr std::size_t packs_a_block = 4;

  /// Numbers advance member by member, packs in blocks that stay in the first-level cache.
  void advance_all(std::int64_t steps) {
    if constexpr (Base::lane_count == 1) {
      for (std::size_t i = 0; i < now_.size(); ++i) {
        [[maybe_unused]] auto const scope = operations_.steps(i);
        brouwer::advance(steppers_[i], now_[i], steps);
      }
    } else {
      std::span<S const> const steppers(steppers_);
      std::span<Y> const states(now_);
      for (std::size_t p = 0; p < states.size(); p += packs_a_block) {
        std::size_t const packs = std::min(packs_a_block, states.size() - p);
        advance_block(steppers.subspan(p, packs), states.subspan(p, packs), steps);
      }
    }
  }

  /// Turns are summed in the scalar itself over so few steps that even a float counts them exactly.
  void advance_counting(std::int64_t steps) requires CountsIterations<S> {
    constexpr std::int64_t most = 10'000;
    for (std::int64_t done = 0; done < steps; done += most)
      for (std::size_t p = 0; p < now_.size(); ++p) {
        T turns = T(0);
        {
          [[maybe_unused]] auto const scope = operations_.steps(p);
          brouwer::advance(steppers_[p], now_[p], std::min(most, steps - done), turns);
        }
        for_members_of(p, [&](std::size_t member, int l) { turns_[member] += static_cast<double>(lane(turns, l)); });
      }
  }

  /// A member that has become NaN walks again, alone and from where it was before the last steps, to see when and why: the
  /// same bits come again, and the loop over steps never needs to look.
  void note_failures(std::int64_t steps) {
    for (std::size_t p = 0; p < now_.size(); ++p)
      for_members_of(p, [&](std::size_t member, int l) {
        if (!failures_[member] && !is_finite(value_of(now_[p]), l)) failures_[member] = failure_within(steps, p, l);
      });
  }

  MemberFailure failure_within(std::int64_t steps, std::size_t p, int l) const {
    if (steps == 0 || !is_finite(value_of(before_[p]), l)) return {made_, Failure::not_finite};
    [[maybe_unused]] auto const scope = operations_.steps_again(p);
    Y y = before_[p];
    for (std::int64_t i = 0; i < steps; ++i) {
      Y const last = y;
      take_step(steppers_[p], y);
      if (!is_finite(value_of(y), l)) return {made_ + i, reason(value_of(last), steppers_[p], l)};
    }
    return {made_ + steps, Failure::not_finite};
  }

  static Failure reason(typename S::State const& y, S const& step, int l) {
    if constexpr (KnowsFailures<S, typename S::State>)
      return step.failure(y, l);
    else
      return Failure::not_finite;
  }

  static bool is_finite(typename S::State const& y, int l) {
    bool finite = true;
    for_components(
        [&](T const& c) {
          auto const v = lane(c, l);
          finite = finite && v - v == Element<T>(0);
        },
        y);
    return finite;
  }

  /// f(member, lane) for the members in a pack.
  template <class F>
  void for_members_of(std::size_t p, F f) const {
    for (std::size_t i = p * Base::lane_count; i < std::min((p + 1) * Base::lane_count, this->members()); ++i)
      f(i, Base::lane_of(i));
  }

  typename Base::Now now(std::size_t pack) const override {
    if constexpr (std::same_as<Y, typename S::State>)
      return {now_[pack], nullptr};
    else
      return {now_[pack].value, &now_[pack].residue};
  }

  MemberOperations<T> operations_;  // of numbers; packs compute as the processor does
  std::vector<S> steppers_;
  std::vector<Y> now_, before_;  // before: where the last call to advance began
  std::int64_t made_ = 0;        // steps
  std::vector<double> turns_;    // of each member
  std::vector<std::optional<MemberFailure>> failures_;
};

/// Trajectories of stepper S, plain or compensated; nothing where the latter is not compiled.
/// @param stepper  makes an S from a Setup
template <Step S, class Make>
std::unique_ptr<Trajectories> begin_trajectories(TrajectoryRequest const& request, Make const& stepper) {
  if (!request.compensation) return std::make_unique<TrajectoriesOf<S, typename S::State>>(request, stepper);
  // compensated double-double is asked for by nobody in numbers that need packs
  if constexpr (IncrementStep<S> && !(lanes < typename S::Scalar >> 1 && significand_bits < typename S::Scalar >> 64))
    return std::make_unique<TrajectoriesOf<S, Compensated<typename S::State>>>(request, stepper);
  return nullptr;
}

}  // namespace brouwer
