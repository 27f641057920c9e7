#include "tests/calibration/philox.hpp"

#include <Random123/philox.h>

#include <new>

namespace brouwer::calibration {
namespace {

struct Stream {
  r123::Philox4x64::ctr_type counter{}, block{};
  r123::Philox4x64::key_type key{};
  unsigned taken = 0;  ///< of the eight halves of a block
};

void set(void* place, unsigned long seed) { new (place) Stream{{}, {}, {{seed, 0}}}; }

unsigned long get(void* place) {
  auto& stream = *static_cast<Stream*>(place);
  if (stream.taken % 8 == 0) {
    stream.block = r123::Philox4x64{}(stream.counter, stream.key);
    stream.counter.incr();
    stream.taken = 0;
  }
  unsigned const half = stream.taken++;
  return (stream.block[half / 2] >> (32 * (half % 2))) & 0xFFFFFFFFUL;
}

double get_double(void* place) { return static_cast<double>(get(place)) * 0x1p-32; }

constexpr gsl_rng_type type = {"philox4x64", 0xFFFFFFFFUL, 0, sizeof(Stream), set, get, get_double};

}  // namespace

gsl_rng_type const* philox() { return &type; }

}  // namespace brouwer::calibration
