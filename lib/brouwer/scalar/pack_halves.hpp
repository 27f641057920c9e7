#pragma once
// Included at the end of pack.hpp.

namespace brouwer {

template <class T, int N>
requires detail::in_halves<T, N>
struct PackMask<T, N> {
  using Half = PackMask<T, N / 2>;
  Half first, second;

  PackMask() = default;
  PackMask(Half const& a, Half const& b) : first(a), second(b) {}
  PackMask(PackMask const& other) : first(other.first), second(other.second) {}  // NOLINT: as for Pack
  PackMask& operator=(PackMask const& other) {                                   // NOLINT
    first = other.first;
    second = other.second;
    return *this;
  }
  /// The same flag in every lane.
  PackMask(bool flag) : first(flag), second(flag) {}  // NOLINT

  bool operator[](int i) const { return i < N / 2 ? first[i] : second[i - N / 2]; }
  void set(int i, bool flag) { i < N / 2 ? first.set(i, flag) : second.set(i - N / 2, flag); }
};

/// A pack of two, four … registers, half by half: of more registers than the target's, or of two on purpose, so that each
/// fills the time in which the other waits for its results. (A vector of the compiler's that is wider than a register goes
/// through memory.)
template <class T, int N>
requires detail::in_halves<T, N>
class Pack<T, N> {
 public:
  using Element = T;
  using Half = Pack<T, N / 2>;
  static constexpr int size = N;
  static constexpr bool in_register = false;

  Pack() = default;
  Pack(Half const& a, Half const& b) : first_(a), second_(b) {}
  // Written out: g++ 12 copies a trivial class of this size through memory in pieces of 16 bytes.
  Pack(Pack const& other) : first_(other.first_), second_(other.second_) {}  // NOLINT
  Pack& operator=(Pack const& other) {                                       // NOLINT
    first_ = other.first_;
    second_ = other.second_;
    return *this;
  }
  /// The same number in every lane.
  Pack(T const& a) : first_(a), second_(a) {}  // NOLINT
  template <std::integral I>
  Pack(I a) : Pack(T(a)) {}  // NOLINT
  /// Lane by lane, rounded once where T is narrower.
  template <class U>
  explicit Pack(Pack<U, N> const& other) {
    for (int i = 0; i < N; ++i) set(i, static_cast<T>(other[i]));
  }
  /// Any other number, in every lane, rounded once where T is narrower.
  template <class U>
  requires(std::constructible_from<T, U> && !std::same_as<T, U> && !std::integral<U>) explicit Pack(U const& a)
      : Pack(static_cast<T>(a)) {}

  T operator[](int i) const { return i < N / 2 ? first_[i] : second_[i - N / 2]; }
  void set(int i, T const& a) { i < N / 2 ? first_.set(i, a) : second_.set(i - N / 2, a); }
  Half const& first() const { return first_; }
  Half const& second() const { return second_; }

  /// f lane by lane.
  template <class F, class... Packs>
  static Pack map(F f, Packs const&... packs) {
    Pack result;
    for (int i = 0; i < N; ++i) result.set(i, T(f(packs[i]...)));
    return result;
  }

  [[gnu::always_inline]] friend Pack operator-(Pack const& a) { return {-a.first_, -a.second_}; }
  [[gnu::always_inline]] friend Pack operator+(Pack const& a, Pack const& b) {
    return {a.first_ + b.first_, a.second_ + b.second_};
  }
  [[gnu::always_inline]] friend Pack operator-(Pack const& a, Pack const& b) {
    return {a.first_ - b.first_, a.second_ - b.second_};
  }
  [[gnu::always_inline]] friend Pack operator*(Pack const& a, Pack const& b) {
    return {a.first_ * b.first_, a.second_ * b.second_};
  }
  [[gnu::always_inline]] friend Pack operator/(Pack const& a, Pack const& b) {
    return {a.first_ / b.first_, a.second_ / b.second_};
  }
  Pack& operator+=(Pack const& b) { return *this = *this + b; }
  Pack& operator-=(Pack const& b) { return *this = *this - b; }
  Pack& operator*=(Pack const& b) { return *this = *this * b; }
  Pack& operator/=(Pack const& b) { return *this = *this / b; }

  friend PackMask<T, N> operator<(Pack const& a, Pack const& b) { return {a.first_ < b.first_, a.second_ < b.second_}; }
  friend PackMask<T, N> operator>(Pack const& a, Pack const& b) { return b < a; }
  friend PackMask<T, N> operator<=(Pack const& a, Pack const& b) {
    return {a.first_ <= b.first_, a.second_ <= b.second_};
  }
  friend PackMask<T, N> operator>=(Pack const& a, Pack const& b) { return b <= a; }
  friend PackMask<T, N> operator==(Pack const& a, Pack const& b) {
    return {a.first_ == b.first_, a.second_ == b.second_};
  }
  friend PackMask<T, N> operator!=(Pack const& a, Pack const& b) { return negated(a == b); }

  friend std::ostream& operator<<(std::ostream& out, Pack const& a) { return out << a.first_ << a.second_; }

 private:
  Half first_, second_;
};

template <class T, int N>
requires detail::in_halves<T, N> PackMask<T, N> both(PackMask<T, N> const& a, PackMask<T, N> const& b) {
  return {both(a.first, b.first), both(a.second, b.second)};
}
template <class T, int N>
requires detail::in_halves<T, N> PackMask<T, N> either(PackMask<T, N> const& a, PackMask<T, N> const& b) {
  return {either(a.first, b.first), either(a.second, b.second)};
}
template <class T, int N>
requires detail::in_halves<T, N> PackMask<T, N> negated(PackMask<T, N> const& a) {
  return {negated(a.first), negated(a.second)};
}
template <class T, int N>
requires detail::in_halves<T, N>
bool any(PackMask<T, N> const& mask) { return any(either(mask.first, mask.second)); }

template <class T, int N>
requires detail::in_halves<T, N> Pack<T, N> select(PackMask<T, N> const& mask, Pack<T, N> const& yes,
                                                   Pack<T, N> const& no) {
  return {select(mask.first, yes.first(), no.first()), select(mask.second, yes.second(), no.second())};
}

template <class T, int N>
requires detail::in_halves<T, N> Pack<T, N> sqrt(Pack<T, N> const& a) { return {sqrt(a.first()), sqrt(a.second())}; }
template <class T, int N>
requires detail::in_halves<T, N> Pack<T, N> abs(Pack<T, N> const& a) { return {abs(a.first()), abs(a.second())}; }
template <class T, int N>
requires detail::in_halves<T, N> Pack<T, N> fused_add(Pack<T, N> const& a, Pack<T, N> const& b, Pack<T, N> const& c) {
  return {fused_add(a.first(), b.first(), c.first()), fused_add(a.second(), b.second(), c.second())};
}
template <class T, int N>
requires detail::in_halves<T, N> Pack<T, N> fused_subtract(Pack<T, N> const& a, Pack<T, N> const& b,
                                                           Pack<T, N> const& c) {
  return {fused_subtract(a.first(), b.first(), c.first()), fused_subtract(a.second(), b.second(), c.second())};
}

template <class T, int N>
requires detail::in_halves<T, N> Pack<T, N> larger(Pack<T, N> const& a, Pack<T, N> const& b) {
  return {larger(a.first(), b.first()), larger(a.second(), b.second())};
}
template <class T, int N>
requires detail::in_halves<T, N> Pack<T, N> smaller(Pack<T, N> const& a, Pack<T, N> const& b) {
  return {smaller(a.first(), b.first()), smaller(a.second(), b.second())};
}
template <class T, int N>
requires detail::in_halves<T, N> Pack<T, N> copysign(Pack<T, N> const& a, Pack<T, N> const& b) {
  return {copysign(a.first(), b.first()), copysign(a.second(), b.second())};
}

}  // namespace brouwer
