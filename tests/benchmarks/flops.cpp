#include "tests/benchmarks/flops.hpp"

#include <brouwer/ensemble/families.hpp>
#include <brouwer/ensemble/families/dmv.hpp>
#include <brouwer/ensemble/families/double_pendulum.hpp>
#include <brouwer/ensemble/families/double_well.hpp>
#include <brouwer/ensemble/families/elliptic.hpp>
#include <brouwer/ensemble/families/henon_heiles.hpp>
#include <brouwer/ensemble/families/kepler.hpp>
#include <brouwer/ensemble/families/outer_solar_system.hpp>
#include <brouwer/ensemble/families/pendulum.hpp>
#include <brouwer/ensemble/families/rigid_body_field.hpp>
#include <brouwer/ensemble/families/rigid_body_splitting.hpp>

namespace brouwer::benchmarks {
namespace {

/// A counting scalar for a name: of E, which has the operations; nothing where it cannot be counted.
template <class Use>
void with_counting_scalar(std::string const& arithmetic, Use use) {
  if (arithmetic == "float") use.template operator()<Counting<float>, float>();
  if (arithmetic == "double") use.template operator()<Counting<double>, double>();
  if (arithmetic == "double-double") use.template operator()<DoubleDouble<Counting<double>>, double>();
}

/// Sine, arc tangent … are our own operations in float and double, and a library's elsewhere.
template <class Family>
inline constexpr bool calls_functions = false;
template <template <class, class> class S>
inline constexpr bool calls_functions<OverFunctions<S>> = true;

/// Stages are weighted with numbers of the scalar's element, which a double-double of counting numbers does not mix with.
template <class Family>
inline constexpr bool weighs_stages = false;
template <template <class> class System>
inline constexpr bool weighs_stages<ImplicitRungeKuttaOf<System>> = true;
template <template <class> class System, class Method>
inline constexpr bool weighs_stages<WithData<ExplicitRungeKutta, System, Method>> = true;

template <class T, class Family>
inline constexpr bool is_counted = (OwnElementary<T> || !calls_functions<Family>)&&(std::same_as<Leading<T>, T> ||
                                                                                    !weighs_stages<Family>);

/// Calls use(std::type_identity<S>, make) for the kernel's stepper over T.
template <class T, class Use>
void with_stepper(Kernel const& kernel, Use use) {
  TrajectoryRequest request;
  request.special_functions = kernel.cell.special_functions;
  request.coefficients = kernel.cell.coefficients;
  auto const visit = [&]<class Family>(Family const& family, MethodText const& text) {
    if constexpr (is_counted<T, Family>)
      if (text.name == kernel.cell.method && text.system == kernel.cell.system) family.template choose<T>(request, use);
  };
#define BROUWER_VISIT(family) families::family::for_each_method(visit);
  BROUWER_FAMILIES(BROUWER_VISIT)
}

template <class S>
Setup<typename S::System> setup_from(Start const& start, Kernel const& kernel) {
  using T = typename S::Scalar;
  std::vector<T> const parameters(start.parameters.begin(), start.parameters.end());
  std::vector<T> const state(start.state.begin(), start.state.end());
  return {typename S::System(std::span<T const>(parameters)), T(kernel.cell.step),
          S::State::from_components(std::span<T const>(state)), kernel.whole_state};
}

constexpr int counted_members = 4;
constexpr int counted_steps = 50;

/// As Trajectories advance numbers or packs.
template <class Y, class S>
void take_steps(S const& step, typename S::State const& start, bool packs) {
  Y y(start);
  if (packs)
    advance_block(std::span<S const>(&step, 1), std::span<Y>(&y, 1), counted_steps);
  else
    advance(step, y, counted_steps);
}

template <class S, class E, class Make>
Operations count_all(std::vector<Start> const& starts, Kernel const& kernel, Make const& make) {
  bool const packs = kernel.set != InstructionSet::none;
  Operations sum;
  for (std::size_t member = 0; member < counted_members; ++member) {
    auto const setup = setup_from<S>(starts[member], kernel);
    S const step = make(setup);
    auto& done = Counting<E>::done = sum;
    if constexpr (IncrementStep<S>)
      if (kernel.cell.compensation) take_steps<Compensated<typename S::State>>(step, setup.start, packs);
    if (!kernel.cell.compensation) take_steps<typename S::State>(step, setup.start, packs);
    sum = done;
  }
  return sum;
}

StepCost per_step(Operations const& all) {
  auto const mean = [](std::int64_t n) { return static_cast<double>(n) / (counted_members * counted_steps); };
  return {mean(all.additions), mean(all.multiplications), mean(all.divisions), mean(all.roots),
          mean(all.fused),     mean(all.comparisons),     mean(all.flops())};
}

}  // namespace

std::optional<StepCost> count_step(Catalogue const& catalogue, Kernel const& kernel) {
  std::optional<StepCost> cost;
  auto const starts = starts_of_members(catalogue, kernel.cell.system);
  with_counting_scalar(kernel.cell.arithmetic, [&]<class T, class E>() {
    with_stepper<T>(kernel, [&]<class S>(std::type_identity<S>, auto const& make) {
      cost = per_step(count_all<S, E>(starts, kernel, make));
    });
  });
  return cost;
}

}  // namespace brouwer::benchmarks
