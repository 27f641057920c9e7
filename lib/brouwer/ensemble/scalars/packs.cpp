// A family's methods in packs of the instruction set for which this is compiled.
#include BROUWER_FAMILY_HEADER
#include <brouwer/ensemble/families.hpp>

#define BROUWER_ADD_PACKS(family, set) BROUWER_ADD(family, set)
extern "C" void BROUWER_ADD_PACKS(BROUWER_FAMILY, BROUWER_INSTRUCTION_SET)(brouwer::Catalogue& catalogue) {
  brouwer::families::BROUWER_FAMILY::for_each_method([&](auto const& steppers, brouwer::MethodText const& text) {
    brouwer::add_packs(catalogue.method(text.system, text.name), steppers);
  });
}
