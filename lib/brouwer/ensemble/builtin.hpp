#pragma once
#include <brouwer/ensemble/catalogue.hpp>

namespace brouwer {

// Names are turned into types here, a file a family of methods, because each compiles many scalars at once.

void add_elliptic_methods(Catalogue& catalogue);
void add_dmv_methods(Catalogue& catalogue);
/// Adds the arithmetics of libraries to those entries.
void add_elliptic_software(Catalogue& catalogue);
void add_dmv_software(Catalogue& catalogue);

}  // namespace brouwer

// The same in packs, once for each instruction set. Each is an object that
// shows this one symbol and keeps everything else to itself (CMakeLists.txt, add_packs), so that no function that needs
// the instructions can be taken for its namesake elsewhere. Only to be called where the processor has them.
#define BROUWER_PACKS_NAME(family, set) brouwer_add_##family##_packs_##set
#define BROUWER_PACKS(family, set) extern "C" void BROUWER_PACKS_NAME(family, set)(brouwer::Catalogue & catalogue)
BROUWER_PACKS(elliptic, sse2);
BROUWER_PACKS(elliptic, avx2);
BROUWER_PACKS(elliptic, avx512);
BROUWER_PACKS(dmv, sse2);
BROUWER_PACKS(dmv, avx2);
BROUWER_PACKS(dmv, avx512);
