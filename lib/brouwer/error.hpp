#pragma once
#include <stdexcept>
#include <string>

namespace brouwer {

/// What the user gave is wrong (study file, option, csv). One sentence: what, where, what was expected.
/// The program ends with exit status 2 and has written nothing.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Something failed while running: a full disk, a damaged unit file. Exit status 3; finished units are kept.
struct RunError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace brouwer
