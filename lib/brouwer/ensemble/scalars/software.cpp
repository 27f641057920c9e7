// A family's methods over the numbers of libraries.
#include BROUWER_FAMILY_HEADER
#include <brouwer/ensemble/families.hpp>

#define BROUWER_ADD_SOFTWARE(family) BROUWER_ADD(family, software)
extern "C" void BROUWER_ADD_SOFTWARE(BROUWER_FAMILY)(brouwer::Catalogue& catalogue) {
  brouwer::families::BROUWER_FAMILY::for_each_method([&](auto const& steppers, brouwer::MethodText const& text) {
    brouwer::add_numbers<brouwer::SoftwareArithmetics>(catalogue.method(text.system, text.name), steppers);
  });
}
