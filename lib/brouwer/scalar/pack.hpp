#pragma once
#include <array>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <functional>
#include <limits>
#include <ostream>

#include <brouwer/scalar/eigen_traits.hpp>
#include <brouwer/scalar/exact.hpp>
#include <brouwer/scalar/vector_instructions.hpp>
#include <brouwer/scalar/wider.hpp>

namespace brouwer {

namespace detail {

/// What a vector register of the target holds, in bytes.
inline constexpr std::size_t register_size =
#if defined(__AVX512F__)
    64;
#elif defined(__AVX__)
    32;
#else
    16;
#endif

/// Numbers and sizes that vector registers are made for: 16, 32, 64 … bytes of float or double.
template <class T, int N>
inline constexpr bool in_registers =
    (std::same_as<T, float> || std::same_as<T, double>)&&N * sizeof(T) >= 16 && std::has_single_bit(N * sizeof(T));

/// One register, two, four … of them (pack_halves.hpp); everything else lives in an array.
template <class T, int N>
inline constexpr bool in_register = in_registers<T, N>&& N * sizeof(T) <= register_size;
template <class T, int N>
inline constexpr bool in_halves = in_registers<T, N>&& N * sizeof(T) > register_size;

/// AVX-512 compares into a register of bits; the others into a vector of all ones and zeros.
template <class T, int N>
inline constexpr bool in_mask_register =
#if defined(__AVX512F__)
    in_register<T, N>&& N * sizeof(T) == 64;
#else
    false;
#endif

template <class T, int N>
struct LaneStorage {
  using Values = std::array<T, static_cast<std::size_t>(N)>;
  using Flags = std::array<bool, static_cast<std::size_t>(N)>;
};

/// T is float or double, I the integer of its size, and `bytes` the register's width.
#define BROUWER_LANE_STORAGE(T, I, bytes)                                                     \
  template <>                                                                                 \
  struct LaneStorage<T, bytes / sizeof(T)> {                                                  \
    typedef T Values __attribute__((vector_size(bytes)));                                     \
    typedef I Integers __attribute__((vector_size(bytes)));                                   \
    typedef I Integer;                                                                        \
    using Bits = std::conditional_t<sizeof(T) == 8, std::uint8_t, std::uint16_t>;             \
    using Flags = std::conditional_t<in_mask_register<T, bytes / sizeof(T)>, Bits, Integers>; \
  };
BROUWER_LANE_STORAGE(double, std::int64_t, 16)
BROUWER_LANE_STORAGE(double, std::int64_t, 32)
BROUWER_LANE_STORAGE(double, std::int64_t, 64)
BROUWER_LANE_STORAGE(float, std::int32_t, 16)
BROUWER_LANE_STORAGE(float, std::int32_t, 32)
BROUWER_LANE_STORAGE(float, std::int32_t, 64)
#undef BROUWER_LANE_STORAGE

}  // namespace detail

/// One flag a lane: what comparing two packs gives.
template <class T, int N>
struct PackMask {
  using Flags = typename detail::LaneStorage<T, N>::Flags;
  Flags flags;

  PackMask() = default;
  explicit PackMask(Flags const& f) : flags(f) {}
  /// The same flag in every lane.
  PackMask(bool flag) : flags{} {  // NOLINT: a bool is the mask of a pack of one lane
    for (int i = 0; i < N; ++i) set(i, flag);
  }

  bool operator[](int i) const {
    if constexpr (detail::in_mask_register<T, N>)
      return ((flags >> i) & 1) != 0;
    else
      return flags[static_cast<std::size_t>(i)] != 0;
  }
  void set(int i, bool flag) {
    if constexpr (detail::in_mask_register<T, N>)
      flags = static_cast<Flags>((flags & ~(1 << i)) | (static_cast<int>(flag) << i));
    else if constexpr (detail::in_register<T, N>)
      flags[static_cast<std::size_t>(i)] = flag ? -1 : 0;
    else
      flags[static_cast<std::size_t>(i)] = flag;
  }
};

/// N numbers that go through the same operations at once: a member of an ensemble in each lane. Every operation is the
/// scalar's, lane by lane, so that each lane is bit for bit the scalar run of its member; nothing adds across lanes.
///
/// float and double that fill a vector register are one vector of the compiler's, those that fill several are halves
/// (pack_halves.hpp); any other T or N, as the wide arithmetic in which a pack's constants are formed, is an array.
template <class T, int N>
class Pack {
 public:
  using Element = T;
  using Values = typename detail::LaneStorage<T, N>::Values;
  static constexpr int size = N;
  static constexpr bool in_register = detail::in_register<T, N>;

  Pack() = default;
  explicit Pack(Values const& values) : values_(values) {}
  /// The same number in every lane.
  Pack(T const& a) { fill(a); }  // NOLINT: a number is a pack of equal lanes
  template <std::integral I>
  Pack(I a) {
    fill(T(a));
  }  // NOLINT
  /// Lane by lane, rounded once where T is narrower.
  template <class U>
  explicit Pack(Pack<U, N> const& other) {
    for (int i = 0; i < N; ++i) set(i, static_cast<T>(other[i]));
  }
  /// Any other number, in every lane, rounded once where T is narrower.
  template <class U>
  requires(std::constructible_from<T, U> && !std::same_as<T, U> && !std::integral<U>) explicit Pack(U const& a) {
    fill(static_cast<T>(a));
  }

  T operator[](int i) const { return values_[static_cast<std::size_t>(i)]; }
  void set(int i, T const& a) { values_[static_cast<std::size_t>(i)] = a; }
  Values const& values() const { return values_; }

  /// f lane by lane.
  template <class F, class... Packs>
  static Pack map(F f, Packs const&... packs) {
    Pack result;
    for (int i = 0; i < N; ++i) result.set(i, T(f(packs[i]...)));
    return result;
  }

  friend Pack operator-(Pack const& a) {
    if constexpr (in_register)
      return Pack(Values(-a.values_));
    else
      return map(std::negate<>(), a);
  }
  friend Pack operator+(Pack const& a, Pack const& b) { return each(std::plus<>(), a, b); }
  friend Pack operator-(Pack const& a, Pack const& b) { return each(std::minus<>(), a, b); }
  friend Pack operator*(Pack const& a, Pack const& b) { return each(std::multiplies<>(), a, b); }
  friend Pack operator/(Pack const& a, Pack const& b) { return each(std::divides<>(), a, b); }
  Pack& operator+=(Pack const& b) { return *this = *this + b; }
  Pack& operator-=(Pack const& b) { return *this = *this - b; }
  Pack& operator*=(Pack const& b) { return *this = *this * b; }
  Pack& operator/=(Pack const& b) { return *this = *this / b; }

  friend PackMask<T, N> operator<(Pack const& a, Pack const& b) { return compared(std::less<>(), a, b); }
  friend PackMask<T, N> operator>(Pack const& a, Pack const& b) { return compared(std::less<>(), b, a); }
  friend PackMask<T, N> operator<=(Pack const& a, Pack const& b) { return compared(std::less_equal<>(), a, b); }
  friend PackMask<T, N> operator>=(Pack const& a, Pack const& b) { return compared(std::less_equal<>(), b, a); }
  friend PackMask<T, N> operator==(Pack const& a, Pack const& b) { return compared(std::equal_to<>(), a, b); }
  friend PackMask<T, N> operator!=(Pack const& a, Pack const& b) { return negated(a == b); }

  friend std::ostream& operator<<(std::ostream& out, Pack const& a) {
    for (int i = 0; i < N; ++i) out << (i == 0 ? "(" : ", ") << a[i];
    return out << ')';
  }

 private:
  void fill(T const& a) {
    if constexpr (in_register)
      values_ = a - Values{};  // a broadcast that keeps −0
    else
      values_.fill(a);
  }

  template <class Operation>
  static Pack each(Operation f, Pack const& a, Pack const& b) {
    if constexpr (in_register)
      return Pack(Values(f(a.values_, b.values_)));
    else
      return map(f, a, b);
  }

  template <class Relation>
  static PackMask<T, N> compared(Relation r, Pack const& a, Pack const& b) {
#if defined(__AVX512F__)
    if constexpr (detail::in_mask_register<T, N>) {
      constexpr int predicate = std::same_as<Relation, std::less<>>         ? _CMP_LT_OQ
                                : std::same_as<Relation, std::less_equal<>> ? _CMP_LE_OQ
                                                                            : _CMP_EQ_OQ;
      if constexpr (std::same_as<T, double>)
        return PackMask<T, N>(_mm512_cmp_pd_mask(__m512d(a.values_), __m512d(b.values_), predicate));
      else
        return PackMask<T, N>(_mm512_cmp_ps_mask(__m512(a.values_), __m512(b.values_), predicate));
    } else
#endif
        if constexpr (in_register) {
      return PackMask<T, N>(r(a.values_, b.values_));
    } else {
      PackMask<T, N> mask;
      for (int i = 0; i < N; ++i) mask.set(i, r(a[i], b[i]));
      return mask;
    }
  }

  Values values_;
};

// --- masks ------------------------------------------------------------------------------------------------------------

namespace detail {
template <class T, int N, class Operation>
PackMask<T, N> combined(Operation f, PackMask<T, N> const& a, PackMask<T, N> const& b) {
  using Flags = typename PackMask<T, N>::Flags;
  if constexpr (in_register<T, N>) return PackMask<T, N>(static_cast<Flags>(f(a.flags, b.flags)));
  PackMask<T, N> mask;
  for (int i = 0; i < N; ++i) mask.set(i, f(a[i], b[i]));
  return mask;
}
}  // namespace detail

template <class T, int N>
PackMask<T, N> both(PackMask<T, N> const& a, PackMask<T, N> const& b) {
  return detail::combined(std::bit_and<>(), a, b);
}
template <class T, int N>
PackMask<T, N> either(PackMask<T, N> const& a, PackMask<T, N> const& b) {
  return detail::combined(std::bit_or<>(), a, b);
}
template <class T, int N>
PackMask<T, N> negated(PackMask<T, N> const& a) {
  return detail::combined(std::bit_xor<>(), a, PackMask<T, N>(true));
}

template <class T, int N>
bool is_set(PackMask<T, N> const& mask, int lane) {
  return mask[lane];
}
template <class T, int N>
bool any(PackMask<T, N> const& mask) {
  if constexpr (detail::in_mask_register<T, N>) {
    return mask.flags != 0;
  } else if constexpr (detail::in_register<T, N>) {
    auto lanes = mask.flags[0];
    for (std::size_t i = 1; i < std::size_t(N); ++i) lanes |= mask.flags[i];
    return lanes != 0;
  } else {
    for (int i = 0; i < N; ++i)
      if (mask[i]) return true;
    return false;
  }
}
template <class T, int N>
bool all(PackMask<T, N> const& mask) {
  return !any(negated(mask));
}

template <class T, int N>
Pack<T, N> select(PackMask<T, N> const& mask, Pack<T, N> const& yes, Pack<T, N> const& no) {
#if defined(__AVX512F__)
  if constexpr (detail::in_mask_register<T, N>) {
    using Values = typename Pack<T, N>::Values;
    if constexpr (std::same_as<T, double>)
      return Pack<T, N>(Values(_mm512_mask_blend_pd(mask.flags, __m512d(no.values()), __m512d(yes.values()))));
    else
      return Pack<T, N>(Values(_mm512_mask_blend_ps(mask.flags, __m512(no.values()), __m512(yes.values()))));
  } else
#endif
      if constexpr (Pack<T, N>::in_register) {
    return Pack<T, N>(typename Pack<T, N>::Values(mask.flags ? yes.values() : no.values()));
  } else {
    Pack<T, N> chosen;
    for (int i = 0; i < N; ++i) chosen.set(i, mask[i] ? yes[i] : no[i]);
    return chosen;
  }
}

// --- functions --------------------------------------------------------------------------------------------------------

/// Correctly rounded, as IEEE asks.
template <class T, int N>
Pack<T, N> sqrt(Pack<T, N> const& a) {
  if constexpr (requires { detail::vector_sqrt(a.values()); })
    return Pack<T, N>(typename Pack<T, N>::Values(detail::vector_sqrt(a.values())));
  using math::sqrt;
  return Pack<T, N>::map([](T const& x) { return sqrt(x); }, a);
}

template <class T, int N>
Pack<T, N> abs(Pack<T, N> const& a) {
  if constexpr (Pack<T, N>::in_register) {
    using Storage = detail::LaneStorage<T, N>;
    auto const magnitude = typename Storage::Integers{} + std::numeric_limits<typename Storage::Integer>::max();
    return Pack<T, N>(typename Storage::Values(typename Storage::Integers(a.values()) & magnitude));
  }
  using math::abs;
  return Pack<T, N>::map([](T const& x) { return abs(x); }, a);
}

/// The instructions max and min are select(a > b, a, b) and select(a < b, a, b) to the last bit, NaN and ±0 included.
template <class T, int N>
Pack<T, N> larger(Pack<T, N> const& a, Pack<T, N> const& b) {
  if constexpr (requires { detail::vector_max(a.values(), b.values()); })
    return Pack<T, N>(typename Pack<T, N>::Values(detail::vector_max(a.values(), b.values())));
  return select(a > b, a, b);
}
template <class T, int N>
Pack<T, N> smaller(Pack<T, N> const& a, Pack<T, N> const& b) {
  if constexpr (requires { detail::vector_min(a.values(), b.values()); })
    return Pack<T, N>(typename Pack<T, N>::Values(detail::vector_min(a.values(), b.values())));
  return select(a < b, a, b);
}

/// |a| with the sign of b, that of zero included.
template <class T, int N>
Pack<T, N> copysign(Pack<T, N> const& a, Pack<T, N> const& b) {
  if constexpr (Pack<T, N>::in_register) {
    using Storage = detail::LaneStorage<T, N>;
    using Integers = typename Storage::Integers;
    auto const magnitude = Integers{} + std::numeric_limits<typename Storage::Integer>::max();
    return Pack<T, N>(
        typename Storage::Values((Integers(a.values()) & magnitude) | (Integers(b.values()) & ~magnitude)));
  }
  using math::copysign;
  return Pack<T, N>::map([](T const& x, T const& y) { return copysign(x, y); }, a, b);
}

/// a·b + c rounded once.
template <class T, int N>
Pack<T, N> fused_add(Pack<T, N> const& a, Pack<T, N> const& b, Pack<T, N> const& c) {
  if constexpr (requires { detail::vector_fused_add(a.values(), b.values(), c.values()); })
    return Pack<T, N>(typename Pack<T, N>::Values(detail::vector_fused_add(a.values(), b.values(), c.values())));
  return Pack<T, N>::map([](T const& x, T const& y, T const& z) { return fused_add(x, y, z); }, a, b, c);
}

/// a·b − c rounded once.
template <class T, int N>
Pack<T, N> fused_subtract(Pack<T, N> const& a, Pack<T, N> const& b, Pack<T, N> const& c) {
  if constexpr (requires { detail::vector_fused_subtract(a.values(), b.values(), c.values()); })
    return Pack<T, N>(typename Pack<T, N>::Values(detail::vector_fused_subtract(a.values(), b.values(), c.values())));
  return Pack<T, N>::map([](T const& x, T const& y, T const& z) { return fused_subtract(x, y, z); }, a, b, c);
}

// The library's functions of the element, lane by lane.
template <class T, int N>
Pack<T, N> sin(Pack<T, N> const& a) {
  using math::sin;
  return Pack<T, N>::map([](T const& x) { return sin(x); }, a);
}
template <class T, int N>
Pack<T, N> cos(Pack<T, N> const& a) {
  using math::cos;
  return Pack<T, N>::map([](T const& x) { return cos(x); }, a);
}
template <class T, int N>
Pack<T, N> cosh(Pack<T, N> const& a) {
  using math::cosh;
  return Pack<T, N>::map([](T const& x) { return cosh(x); }, a);
}
template <class T, int N>
Pack<T, N> tanh(Pack<T, N> const& a) {
  using math::tanh;
  return Pack<T, N>::map([](T const& x) { return tanh(x); }, a);
}
template <class T, int N>
Pack<T, N> atan2(Pack<T, N> const& y, Pack<T, N> const& x) {
  using math::atan2;
  return Pack<T, N>::map([](T const& b, T const& a) { return atan2(b, a); }, y, x);
}
template <class T, int N>
Pack<T, N> floor(Pack<T, N> const& a) {
  using std::floor;
  return Pack<T, N>::map([](T const& x) { return floor(x); }, a);
}
template <class T, int N>
Pack<T, N> ldexp(Pack<T, N> const& a, int exponent) {
  using std::ldexp;
  return Pack<T, N>::map([exponent](T const& x) { return ldexp(x, exponent); }, a);
}
template <class T, int N>
Pack<T, N> pow(Pack<T, N> const& a, Pack<T, N> const& b) {
  using std::pow;
  return Pack<T, N>::map([](T const& x, T const& y) { return pow(x, y); }, a, b);
}

// --- lanes ------------------------------------------------------------------------------------------------------------

template <class T, int N>
struct Lanes<Pack<T, N>> {
  using Element = T;
  static constexpr int count = N;
  static T get(Pack<T, N> const& pack, int i) { return pack[i]; }
  static void set(Pack<T, N>& pack, int i, T const& a) { pack.set(i, a); }
};

/// What judges a pack is the pack of what judges its lanes.
template <class T, int N>
struct WiderThan<Pack<T, N>> {
  using type = Pack<Wider<T>, N>;
};

}  // namespace brouwer

template <class T, int N>
struct std::numeric_limits<brouwer::Pack<T, N>> : std::numeric_limits<T> {
  using Pack = brouwer::Pack<T, N>;
  static Pack epsilon() { return Pack(std::numeric_limits<T>::epsilon()); }
  static Pack infinity() { return Pack(std::numeric_limits<T>::infinity()); }
  static Pack quiet_NaN() { return Pack(std::numeric_limits<T>::quiet_NaN()); }
  static Pack min() { return Pack(std::numeric_limits<T>::min()); }
  static Pack max() { return Pack(std::numeric_limits<T>::max()); }
};

template <class T, int N>
struct Eigen::NumTraits<brouwer::Pack<T, N>> : brouwer::EigenTraits<brouwer::Pack<T, N>, 1, 1, 1> {};

#include <brouwer/scalar/pack_halves.hpp>
