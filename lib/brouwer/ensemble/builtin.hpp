#pragma once
#include <brouwer/ensemble/catalogue.hpp>

namespace brouwer {

// Names are turned into types here, a file a system, because each compiles many scalars at once.

void add_rigid_body(Catalogue& catalogue);

}  // namespace brouwer
