#pragma once
#include <algorithm>
#include <array>
#include <limits>

#include <brouwer/integrators/dmv_preprocessing.hpp>

namespace brouwer {

/// What the discrete Moser–Veselov equation is solved for (dmv.hpp): the midpoint m of a step's momenta, and α.
template <Real T>
struct DmvIterate {
  Vector3<T> m;
  T alpha;
};

/// One turn: twice the line for α, then twice those for m, in Gauss–Seidel order.
/// @return by how much the last line moved m
template <Real T>
Leading<T> dmv_turn(Vector3<T> const& y, DmvConstants<T> const& k, DmvIterate<T>& e) {
  T const S = k.length2(e.m), once = 1 + S * squared(e.alpha), alpha = 1 + S * squared(once);
  T const mu1 = alpha * k.lambda[0], mu2 = alpha * k.lambda[1], mu3 = alpha * k.lambda[2];
  T const a1 = y[0] + mu1 * (e.m[1] * e.m[2]);
  T const a2 = y[1] + mu2 * (e.m[2] * a1);
  T const a3 = y[2] + mu3 * (a1 * a2);
  T const b1 = y[0] + mu1 * (a2 * a3);
  T const b2 = y[1] + mu2 * (a3 * b1);
  T const b3 = y[2] + mu3 * (b1 * b2);
  e.m[0] = b1;
  e.m[1] = b2;
  e.m[2] = b3;
  e.alpha = alpha;
  return largest_difference<T>({b1, b2, b3}, {a1, a2, a3});
}

/// How the equation is iterated along one trajectory: how many turns settle it is found at the start, in wider
/// arithmetic, lane by lane. A step makes these, all but the last without looking, which lets packs run side by side.
/// Where the last line still moved m by more than is accepted it goes on, each lane until it stands still or no longer
/// comes closer. Where it never settles (h is too large) α becomes NaN: the member has failed.
template <Real T>
class DmvTurns {
 public:
  static constexpr int limit = 50 + 8 * significand_bits<T>;  ///< linear convergence, at worst 1/8 bit a turn

  /// @param y, eta  of the trajectory's start
  /// @param first   the iterate from which a step there begins
  DmvTurns(Vector3<T> const& y, Vector3<T> const& eta, DmvIterate<T> const& first) {
    auto counts = find(y, eta, first);
    for (int& count : counts) count = std::max(count, 1);
    own_ = from_lanes<Size>([&](int i) { return Element<Size>(counts[at(i)]); });
    fewest_ = *std::min_element(counts.begin(), counts.end());
    most_ = *std::max_element(counts.begin(), counts.end());
  }

  /// Turns that every lane makes without looking.
  int blind() const { return fewest_ - 1; }

  /// The other turns, after `made` blind ones.
  void settle(Vector3<T> const& y, DmvConstants<T> const& k, DmvIterate<T>& e, int made) const {
    Size change{};
    if (made + 1 == most_) {
      change = dmv_turn(y, k, e);
    } else {
      for (int i = made; i < most_; ++i) {
        auto const own = Size(i) < own_;
        change = select(own, turn_where(own, y, k, e), change);
      }
    }
    auto const unsettled = negated(change <= accepted_);
    if (any(unsettled)) go_on(unsettled, change, y, k, e);
  }

  void solve(Vector3<T> const& y, DmvConstants<T> const& k, DmvIterate<T>& e) const {
    for (int i = 0; i < blind(); ++i) dmv_turn(y, k, e);
    settle(y, k, e, blind());
  }

 private:
  using Size = Leading<T>;  ///< moves of m are compared by their leading parts
  /// By how many ulp rounding moves m; an operation of double-double errs by several.
  static constexpr int noise = std::same_as<Size, T> ? 2 : 16;
  static constexpr std::size_t at(int i) { return static_cast<std::size_t>(i); }

  static Size turn_where(Mask<Size> const& mask, Vector3<T> const& y, DmvConstants<T> const& k, DmvIterate<T>& e) {
    DmvIterate<T> next = e;
    Size const change = dmv_turn(y, k, next);
    e = {select_vector<T>(mask, next.m, e.m), select(mask, next.alpha, e.alpha)};
    return change;
  }

  /// Rare: kept out of the loop over steps. Rounding may keep m moving to and fro by a few ulp: that is settled, too.
  [[gnu::noinline]] void go_on(Mask<Size> active, Size change, Vector3<T> const& y, DmvConstants<T> const& k,
                               DmvIterate<T>& e) const {
    Size const to_and_fro = Size(8) * accepted_;
    for (int i = 0; any(active) && i < limit; ++i) {
      Size const before = change;
      change = select(active, turn_where(active, y, k, e), change);
      active = both(active, both(change > Size(0), either(change<before, change> to_and_fro)));
    }
    e.alpha = select(change <= to_and_fro, e.alpha, T(std::numeric_limits<T>::quiet_NaN()));
  }

  /// Turns from `first` after which the increment's correction (dmv.hpp) leaves less than 2⁻¹⁴ ulp of |y|, and α is
  /// settled to what that is worth (of a ball, α alone moves); 0 where that is never so. The correction leaves as much
  /// of what m is off as a line does: the ratio of two moves. What a look accepts lies between the rounding's noise and
  /// eight times that; it is negative where m never settles, so that the first look fails.
  std::array<int, lanes<T>> find(Vector3<T> const& y, Vector3<T> const& eta, DmvIterate<T> const& first) {
    using W = Wider<T>;
    using math::abs;
    using math::sqrt;
    auto const wide = [](Vector3<T> const& v) { return Vector3<W>{W(v[0]), W(v[1]), W(v[2])}; };
    auto const wide_y = wide(y);
    DmvIterate<W> e{wide(first.m), W(first.alpha)};
    DmvConstants<W> const k(wide(eta));
    W const length = sqrt(squared_norm(wide_y)), ulp = W(epsilon<T>()) * length;
    std::array<int, lanes<T>> counts{};
    W accepted = W(-1), last = W(0);
    auto active = W(0) < W(1);
    for (int i = 0; i < limit && any(active); ++i) {
      auto const before = e;
      W const line = dmv_turn(wide_y, k, e);
      W const off = larger(W(length * k.length2(before.m) * abs(W(e.alpha - before.alpha))),
                           largest_difference<W>(e.m, before.m));
      if (i > 0) {
        auto const settled = both(active, both(off * off <= last * ulp / W(1 << 14), last <= W(4 * noise) * ulp));
        accepted = select(settled, acceptable(ulp, off, last), accepted);
        active = both(active, negated(settled));
      }
      last = line;
      for (int l = 0; l < lanes<T>; ++l) counts[at(l)] += is_set(active, l) ? 1 : 0;
    }
    for (int l = 0; l < lanes<T>; ++l)
      if (is_set(active, l)) counts[at(l)] = 0;
    accepted_ = rounded<Size>(accepted);
    return counts;
  }

  /// The move of a line that leaves 2⁻¹² ulp after the correction, where the next turn moves m by `off` after `line`.
  template <class W>
  static W acceptable(W const& ulp, W const& off, W const& line) {
    auto const moves = off > W(0);
    W const ratio = line / select(moves, off, W(1)), most = W(8 * noise) * ulp;
    W const leaves = select(moves, ratio * ratio * ulp / W(1 << 12), most);
    return larger(W(W(noise) * ulp), select(leaves < most, leaves, most));
  }

  int fewest_, most_;  ///< over the lanes
  Size own_, accepted_;
};

}  // namespace brouwer
