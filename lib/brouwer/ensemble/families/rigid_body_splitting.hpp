#pragma once
#include <brouwer/ensemble/method.hpp>
#include <brouwer/integrators/rigid_body_splitting.hpp>

/// The rigid body by rotations about its axes.
namespace brouwer::families::rigid_body_splitting {

struct Line {
  char const* name;
  char const* summary;
  Composition const* composition;
};

inline constexpr Line lines[] = {
    {"splitting-2", "five rotations about the axes, symmetric", &base_method},
    {"splitting-forest-ruth-4", "three splitting steps, the middle one backwards", &forest_ruth_4},
    {"splitting-suzuki-4", "five splitting steps: a fractal composition", &suzuki_4},
    {"splitting-mclachlan-4", "five splitting steps, for small error constants", &mclachlan_4},
    {"splitting-yoshida-6", "seven splitting steps: the fewest of order 6", &yoshida_6},
    {"splitting-kahan-li-6", "nine splitting steps, for small error constants", &kahan_li_6},
    {"splitting-suzuki-umeno-8", "fifteen splitting steps: the fewest of order 8", &suzuki_umeno_8},
    {"splitting-kahan-li-8", "seventeen splitting steps, for small error constants", &kahan_li_8}};

/// One class for all compositions.
struct Composed {
  using OfDouble = RigidBodySplitting<double>;
  Composition const* composition;
  int order() const { return composition->order; }
  static void describe(MethodEntry&) {}

  template <class T, class Use>
  void choose(TrajectoryRequest const&, Use use) const {
    use(std::type_identity<RigidBodySplitting<T>>{},
        [data = composition](Setup<RigidBody<T>> const& setup) { return RigidBodySplitting<T>(setup, *data); });
  }
};

template <class Visit>
void for_each_method(Visit visit) {
  char const* const splitting = "R. I. McLachlan, Phys. Rev. Lett. 71 (1993) 3043; S. Reich, Physica D 76 (1994) 375";
  for (auto const& line : lines)
    visit(Composed{line.composition},
          MethodText{line.name, "rigid_body", line.summary,
                     line.composition == &base_method ? splitting : line.composition->source.data()});
}

}  // namespace brouwer::families::rigid_body_splitting
