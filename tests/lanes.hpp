#pragma once
#include <bit>
#include <brouwer/scalar/pack.hpp>
#include <vector>

// What the tests of packs share: a lane must have the bits of the scalar run.
namespace brouwer::testing_support {

/// The same bits, or both not a number.
template <class E>
bool same_bits(E a, E b) {
  using Bits = std::conditional_t<sizeof(E) == 8, std::uint64_t, std::uint32_t>;
  return std::bit_cast<Bits>(a) == std::bit_cast<Bits>(b) || (a != a && b != b);
}

/// The numbers in packs, in their order; the last pack is filled up from the front.
template <class T>
std::vector<T> packed(std::vector<Element<T>> const& numbers) {
  std::vector<T> packs;
  for (std::size_t first = 0; first < numbers.size(); first += lanes<T>)
    packs.push_back(
        from_lanes<T>([&](int i) { return numbers[(first + static_cast<std::size_t>(i)) % numbers.size()]; }));
  return packs;
}

}  // namespace brouwer::testing_support
