// A family's methods over float and double with chosen rounding, constants and contraction.
#include BROUWER_FAMILY_HEADER
#include <brouwer/ensemble/families.hpp>

#define BROUWER_ADD_MODELLED(family) BROUWER_ADD(family, modelled)
extern "C" void BROUWER_ADD_MODELLED(BROUWER_FAMILY)(brouwer::Catalogue& catalogue) {
  brouwer::families::BROUWER_FAMILY::for_each_method([&](auto const& steppers, brouwer::MethodText const& text) {
    brouwer::add_modelled(catalogue.method(text.system, text.name), steppers);
  });
}
