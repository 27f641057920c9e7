#pragma once
#include <array>
#include <cstddef>
#include <span>

#include <brouwer/scalar/real.hpp>

namespace brouwer {

/// An exact coefficient.
struct Ratio {
  long long numerator = 0, denominator = 1;

  constexpr bool is_zero() const { return numerator == 0; }
  /// Rounded once.
  template <Real T>
  T in() const {
    return T(numerator) / T(denominator);
  }
};

/// An explicit Runge–Kutta method as data, one constant for each publication:
///     kᵢ = h rate(y + Σ_{j<i} aᵢⱼ kⱼ)    y' = y + Σ bᵢ kᵢ
/// What is not written is zero.
struct ExplicitTableau {
  static constexpr std::size_t most_stages = 13;
  char const* name;
  int order;
  char const* summary;
  char const* source;
  int stages;
  Ratio a[most_stages][most_stages - 1];  ///< row i is stage i's
  Ratio b[most_stages];

  /// Whether a later stage, or y', has the stage.
  constexpr bool uses(std::size_t stage) const {
    bool used = !b[stage].is_zero();
    for (std::size_t i = stage + 1; i < most_stages; ++i) used = used || !a[i][stage].is_zero();
    return used;
  }
};

inline constexpr ExplicitTableau explicit_euler{
    "explicit-euler", 1, "explicit Euler", "L. Euler, Institutionum calculi integralis I, 1768", 1, {{}}, {{1, 1}}};

inline constexpr ExplicitTableau runge_2{
    "runge-2", 2, "explicit midpoint rule", "C. Runge, Math. Ann. 46 (1895) 167", 2, {{}, {{1, 2}}}, {{}, {1, 1}}};

inline constexpr ExplicitTableau heun_3{"heun-3",
                                        3,
                                        "three stages",
                                        "K. Heun, Z. Math. Phys. 45 (1900) 23",
                                        3,
                                        {{}, {{1, 3}}, {{}, {2, 3}}},
                                        {{1, 4}, {}, {3, 4}}};

inline constexpr ExplicitTableau kutta_4{"kutta-4",
                                         4,
                                         "the classical Runge-Kutta method (RK4)",
                                         "W. Kutta, Z. Math. Phys. 46 (1901) 435",
                                         4,
                                         {{}, {{1, 2}}, {{}, {1, 2}}, {{}, {}, {1, 1}}},
                                         {{1, 6}, {1, 3}, {1, 3}, {1, 6}}};

/// The higher order of the pair 5(4), with a fixed step.
inline constexpr ExplicitTableau dormand_prince_5{
    "dormand-prince-5",
    5,
    "six stages: the method of order 5 of the pair 5(4), with a fixed step",
    "J. R. Dormand, P. J. Prince, J. Comput. Appl. Math. 6 (1980) 19",
    6,
    {{},
     {{1, 5}},
     {{3, 40}, {9, 40}},
     {{44, 45}, {-56, 15}, {32, 9}},
     {{19372, 6561}, {-25360, 2187}, {64448, 6561}, {-212, 729}},
     {{9017, 3168}, {-355, 33}, {46732, 5247}, {49, 176}, {-5103, 18656}}},
    {{35, 384}, {}, {500, 1113}, {125, 192}, {-2187, 6784}, {11, 84}}};

/// The higher order of the pair 7(8), with a fixed step.
inline constexpr ExplicitTableau fehlberg_8{
    "fehlberg-8",
    8,
    "twelve of thirteen stages: the method of order 8 of the pair 7(8), with a fixed step",
    "E. Fehlberg, NASA Technical Report R-287, 1968",
    13,
    {{},
     {{2, 27}},
     {{1, 36}, {1, 12}},
     {{1, 24}, {}, {1, 8}},
     {{5, 12}, {}, {-25, 16}, {25, 16}},
     {{1, 20}, {}, {}, {1, 4}, {1, 5}},
     {{-25, 108}, {}, {}, {125, 108}, {-65, 27}, {125, 54}},
     {{31, 300}, {}, {}, {}, {61, 225}, {-2, 9}, {13, 900}},
     {{2, 1}, {}, {}, {-53, 6}, {704, 45}, {-107, 9}, {67, 90}, {3, 1}},
     {{-91, 108}, {}, {}, {23, 108}, {-976, 135}, {311, 54}, {-19, 60}, {17, 6}, {-1, 12}},
     {{2383, 4100}, {}, {}, {-341, 164}, {4496, 1025}, {-301, 82}, {2133, 4100}, {45, 82}, {45, 164}, {18, 41}},
     {{3, 205}, {}, {}, {}, {}, {-6, 41}, {-3, 205}, {-3, 41}, {3, 41}, {6, 41}},
     {{-1777, 4100},
      {},
      {},
      {-341, 164},
      {4496, 1025},
      {-289, 82},
      {2193, 4100},
      {51, 82},
      {33, 164},
      {12, 41},
      {},
      {1, 1}}},
    {{}, {}, {}, {}, {}, {34, 105}, {9, 35}, {9, 35}, {9, 280}, {9, 280}, {}, {41, 840}, {41, 840}}};

/// All of them, by order.
inline std::span<ExplicitTableau const> explicit_tableaux() {
  static constexpr std::array all{explicit_euler, runge_2, heun_3, kutta_4, dormand_prince_5, fehlberg_8};
  return all;
}

}  // namespace brouwer
