#include <brouwer/ensemble/builtin.hpp>
#include <brouwer/ensemble/rigid_body_methods.hpp>

namespace brouwer {

void add_dmv_software(Catalogue& catalogue) {
  for_each_dmv_method([&]<class Family>(Family, MethodText const& text) {
    add_numbers<Family, SoftwareArithmetics>(catalogue.method(text.system, text.name));
  });
}

}  // namespace brouwer
