#pragma once
#include <brouwer/ensemble/catalogue.hpp>

namespace brouwer {

/// The command line `brouwer`. A program with systems and integrators of its own adds them to
/// `builtin_catalogue()` and calls this from its main.
/// @return exit status: 0 done, 1 an expectation failed, 2 wrong usage or input, 3 failed at run time, 75 interrupted
int program(int argc, char const* const* argv, Catalogue const& catalogue);

}  // namespace brouwer
