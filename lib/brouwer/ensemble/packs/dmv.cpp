#include <brouwer/ensemble/builtin.hpp>
#include <brouwer/ensemble/rigid_body_methods.hpp>

BROUWER_PACKS(dmv, BROUWER_INSTRUCTION_SET) {
  brouwer::for_each_dmv_method([&]<class Family>(Family, brouwer::MethodText const& text) {
    brouwer::add_packs<Family>(catalogue.method(text.system, text.name));
  });
}
