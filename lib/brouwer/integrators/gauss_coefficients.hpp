#pragma once
#include <array>
#include <span>

#include <brouwer/scalar/wider.hpp>
#include <brouwer/special/gauss_legendre.hpp>

namespace brouwer {

/// An implicit Runge–Kutta method: collocation at the zeros of Legendre's polynomial of degree s (order 2s, symmetric,
/// symplectic), or implicit Euler.
struct ImplicitMethod {
  static constexpr std::size_t most_stages = 8;
  char const* name;
  int order;
  char const* summary;
  char const* source;
  int stages;

  constexpr bool is_gauss() const { return order == 2 * stages; }
};

/// How the coefficients aᵢⱼ, bᵢ are held in floating point. Rounded ones satisfy neither the conditions of order nor those
/// of symplecticity, and err by the same in every step: a drift. It is a factor of a study, therefore.
enum class CoefficientForm {
  standard,  ///< aᵢⱼ and bᵢ rounded; the iteration is stopped at a tolerance
  split,  ///< aᵢⱼ = a*ᵢⱼ + ãᵢⱼ, a* a multiple of 2⁻¹⁰, and b likewise. E. Hairer, R. I. McLachlan, A. Razakarivony,
          ///< BIT Numer. Math. 48 (2008) 231
  symplectic,  ///< aᵢⱼ = μᵢⱼbⱼ, with μᵢⱼ + μⱼᵢ = 1 exactly in floating point. M. Antoñana, J. Makazaga, A. Murua, Numer.
               ///< Algorithms 76 (2017) 861
};

inline constexpr std::array coefficient_forms{CoefficientForm::standard, CoefficientForm::split,
                                              CoefficientForm::symplectic};

constexpr char const* name_of(CoefficientForm form) {
  constexpr std::array names{"standard", "split", "symplectic"};
  return names[static_cast<std::size_t>(form)];
}

/// The forms that differ: implicit Euler's coefficient is 1, its condition of symplecticity hopeless.
inline std::span<CoefficientForm const> forms_of(ImplicitMethod const& method) {
  return std::span(coefficient_forms).first(method.is_gauss() ? coefficient_forms.size() : 1);
}

template <Real E>
using StageVector = std::array<E, ImplicitMethod::most_stages>;
template <Real E>
using StageMatrix = std::array<StageVector<E>, ImplicitMethod::most_stages>;

/// a and b of a method, to the digits of W.
template <Real W>
struct ImplicitTableau {
  std::size_t stages = 1;
  StageMatrix<W> a{};
  StageVector<W> b{};
};

/// bⱼ and aᵢⱼ = ∫₀^{cᵢ} ℓⱼ, ℓⱼ the Lagrange polynomial of node j, by the quadrature itself, which is exact for it.
template <Real W>
ImplicitTableau<W> gauss_tableau(int stages) {
  auto const nodes = GaussLegendre<W>(stages).nodes();
  auto const lagrange = [&nodes](std::size_t j, W const& x) {
    W product(1);
    for (std::size_t m = 0; m < nodes.size(); ++m)
      if (m != j) product = product * ((x - nodes[m].x) / (nodes[j].x - nodes[m].x));
    return product;
  };
  ImplicitTableau<W> tableau;
  tableau.stages = nodes.size();
  for (std::size_t j = 0; j < nodes.size(); ++j) {
    tableau.b[j] = nodes[j].weight;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      W integral(0);
      for (auto const& node : nodes) integral = integral + node.weight * lagrange(j, W(nodes[i].x * node.x));
      tableau.a[i][j] = nodes[i].x * integral;
    }
  }
  return tableau;
}

template <Real W>
ImplicitTableau<W> implicit_euler_tableau() {
  ImplicitTableau<W> tableau;
  tableau.a[0][0] = tableau.b[0] = W(1);
  return tableau;
}

/// What a step with stages Yᵢ and their changes kᵢ = hwᵢ rate(Yᵢ) works with, in arithmetic E:
///     Yᵢ = y + Σⱼ mᵢⱼkⱼ (+ Σⱼ m̃ᵢⱼkⱼ)    y' = y + Σⱼ vⱼkⱼ (+ Σⱼ ṽⱼkⱼ)
/// standard: m = a, v = b, w = 1; split: the same in two parts; symplectic: m = μ, v = 1, w = b.
template <Real E>
struct ImplicitCoefficients {
  std::size_t stages = 1;
  StageMatrix<E> m{}, m_rest{};
  StageVector<E> v{}, v_rest{};
  bool has_rest = false;
  StageVector<Wider<E>> w{};
};

namespace detail {

/// In the leading part a multiple of 2⁻¹⁰, the nearest; in the other what is left, rounded once.
template <Real E, class W>
void split(W const& a, E& leading, E& rest) {
  using std::floor;
  W const nearest = W(floor(W(a * W(1024) + W(1) / W(2)))) / W(1024);
  leading = rounded<E>(nearest);
  rest = rounded<E>(W(a - nearest));
}

/// μᵢⱼ = aᵢⱼ/bⱼ. For j < i it lies between 1/2 and 2, so that 1 − μ is exact; the others are made of these.
template <Real E, class W>
E mu(ImplicitTableau<W> const& t, std::size_t i, std::size_t j) {
  if (i == j) return t.stages == 1 ? rounded<E>(W(t.a[0][0] / t.b[0])) : E(1) / E(2);
  return i > j ? rounded<E>(W(t.a[i][j] / t.b[j])) : E(1) - mu<E>(t, j, i);
}

}  // namespace detail

template <Real E>
ImplicitCoefficients<E> coefficients_in_form(ImplicitTableau<Wider<E>> const& t, CoefficientForm form) {
  ImplicitCoefficients<E> c;
  c.stages = t.stages;
  c.has_rest = form == CoefficientForm::split;
  for (std::size_t i = 0; i < t.stages; ++i) {
    c.w[i] = form == CoefficientForm::symplectic ? t.b[i] : Wider<E>(1);
    if (form == CoefficientForm::standard) c.v[i] = rounded<E>(t.b[i]);
    if (form == CoefficientForm::split) detail::split(t.b[i], c.v[i], c.v_rest[i]);
    if (form == CoefficientForm::symplectic) c.v[i] = E(1);
    for (std::size_t j = 0; j < t.stages; ++j) {
      if (form == CoefficientForm::standard) c.m[i][j] = rounded<E>(t.a[i][j]);
      if (form == CoefficientForm::split) detail::split(t.a[i][j], c.m[i][j], c.m_rest[i][j]);
      if (form == CoefficientForm::symplectic) c.m[i][j] = detail::mu<E>(t, i, j);
    }
  }
  return c;
}

/// Those of a method, computed when first asked for and kept: they are the same in all members whose constants are, or
/// are not, exact.
template <Real E, bool exact>
ImplicitCoefficients<E> const& kept_coefficients(ImplicitMethod const& method, CoefficientForm form) {
  using Forms = std::array<ImplicitCoefficients<E>, coefficient_forms.size()>;
  auto const in_forms = [](ImplicitTableau<Wider<E>> const& t) {
    Forms forms;
    for (std::size_t f = 0; f < forms.size(); ++f) forms[f] = coefficients_in_form<E>(t, coefficient_forms[f]);
    return forms;
  };
  static std::array<Forms, ImplicitMethod::most_stages + 1> const kept = [&] {
    std::array<Forms, ImplicitMethod::most_stages + 1> all;
    all[0] = in_forms(implicit_euler_tableau<Wider<E>>());
    for (std::size_t s = 1; s < all.size(); ++s) all[s] = in_forms(gauss_tableau<Wider<E>>(static_cast<int>(s)));
    return all;
  }();
  auto const which = static_cast<std::size_t>(method.is_gauss() ? method.stages : 0);
  return kept[which][static_cast<std::size_t>(form)];
}

template <Real E>
ImplicitCoefficients<E> const& implicit_coefficients(ImplicitMethod const& method, CoefficientForm form) {
  if constexpr (requires { E::constants_are_exact(); })
    if (E::constants_are_exact()) return kept_coefficients<E, true>(method, form);
  return kept_coefficients<E, false>(method, form);
}

/// All of them: implicit Euler, and Gauss methods by order.
inline std::span<ImplicitMethod const> implicit_methods() {
  constexpr char const* gauss =
      "J. C. Butcher, Math. Comp. 18 (1964) 50; J. Kuntzmann, Z. Angew. Math. Mech. 41 (1961) T28";
  static constexpr std::array methods{
      ImplicitMethod{"implicit-euler", 1, "implicit Euler, by fixed-point iteration",
                     "E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, IV.3", 1},
      ImplicitMethod{"gauss-2", 2, "the implicit midpoint rule", gauss, 1},
      ImplicitMethod{"gauss-4", 4, "collocation at two Gauss points",
                     "P. C. Hammer, J. W. Hollingsworth, Math. Tables Aids Comput. 9 (1955) 92", 2},
      ImplicitMethod{"gauss-6", 6, "collocation at three Gauss points", gauss, 3},
      ImplicitMethod{"gauss-8", 8, "collocation at four Gauss points", gauss, 4},
      ImplicitMethod{"gauss-10", 10, "collocation at five Gauss points", gauss, 5},
      ImplicitMethod{"gauss-12", 12, "collocation at six Gauss points", gauss, 6},
      ImplicitMethod{"gauss-14", 14, "collocation at seven Gauss points", gauss, 7},
      ImplicitMethod{"gauss-16", 16, "collocation at eight Gauss points", gauss, 8}};
  return methods;
}

}  // namespace brouwer
