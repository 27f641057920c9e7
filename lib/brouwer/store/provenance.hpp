#pragma once
#include <string>
#include <utility>
#include <vector>

namespace brouwer {

/// With what, on what and when numbers were made: keys and values, in the order of printing.
struct Provenance {
  std::vector<std::pair<std::string, std::string>> entries;
};

/// Of this program and this machine, now: versions of brouwer, compiler, its flags and the libraries (those linked,
/// not those compiled against), CPU and the instruction sets by which glibc chooses its sin and cos, kernel, threads,
/// date.
Provenance provenance(int threads);

/// One `key = value` a line.
std::string to_text(Provenance const& provenance);

}  // namespace brouwer
