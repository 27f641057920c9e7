// A family's methods over the numbers that the processor computes, and their entries in the catalogue.
#include BROUWER_FAMILY_HEADER
#include <brouwer/ensemble/families.hpp>

#define BROUWER_ADD_HARDWARE(family) BROUWER_ADD(family, hardware)
extern "C" void BROUWER_ADD_HARDWARE(BROUWER_FAMILY)(brouwer::Catalogue& catalogue) {
  brouwer::families::BROUWER_FAMILY::for_each_method([&](auto const& steppers, brouwer::MethodText const& text) {
    catalogue.methods.push_back(brouwer::described(steppers, text));
    brouwer::add_numbers<brouwer::HardwareArithmetics>(catalogue.methods.back(), steppers);
  });
}
