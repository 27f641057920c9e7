#include <brouwer/ensemble/builtin.hpp>
#include <brouwer/ensemble/rigid_body_methods.hpp>

namespace brouwer {

void add_dmv_methods(Catalogue& catalogue) {
  for_each_dmv_method([&]<class Family>(Family, MethodText const& text) {
    catalogue.methods.push_back(described<Family>(text));
    add_numbers<Family, HardwareArithmetics>(catalogue.methods.back());
  });
}

}  // namespace brouwer
