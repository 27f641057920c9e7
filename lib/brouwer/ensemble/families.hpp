#pragma once

namespace brouwer {
class Catalogue;
}

// The families of methods that the program has, in the order in which it lists them. A family is a header of
// ensemble/families, families::NAME::for_each_method: the only place where its names meet types. It is compiled by itself
// (CMakeLists.txt, add_family), once for each set of scalars:
//     hardware             numbers that the processor computes
//     software             numbers of libraries
//     modelled             float and double with chosen operations
//     sse2, avx2, avx512   packs. Each is an object that shows one symbol and keeps everything else to itself, so that no
//                          function that needs the instructions can be taken for its namesake elsewhere. Only to be called
//                          where the processor has them.
// clang-format off
#define BROUWER_FAMILIES(family) \
  family(elliptic)               \
  family(rigid_body_splitting)   \
  family(dmv)                    \
  family(rigid_body_field)       \
  family(double_well)            \
  family(pendulum)               \
  family(henon_heiles)           \
  family(double_pendulum)        \
  family(kepler)                 \
  family(outer_solar_system)
// clang-format on

#define BROUWER_ADD(family, scalars) brouwer_add_##family##_##scalars
#define BROUWER_DECLARE_FAMILY(family)                                \
  extern "C" {                                                        \
  void BROUWER_ADD(family, hardware)(brouwer::Catalogue & catalogue); \
  void BROUWER_ADD(family, software)(brouwer::Catalogue & catalogue); \
  void BROUWER_ADD(family, modelled)(brouwer::Catalogue & catalogue); \
  void BROUWER_ADD(family, sse2)(brouwer::Catalogue & catalogue);     \
  void BROUWER_ADD(family, avx2)(brouwer::Catalogue & catalogue);     \
  void BROUWER_ADD(family, avx512)(brouwer::Catalogue & catalogue);   \
  }
BROUWER_FAMILIES(BROUWER_DECLARE_FAMILY)
