#pragma once
#include <brouwer/store/results.hpp>
#include <string>

namespace brouwer {

/// What the numbers in another program's file are, and what becomes of them.
enum class FileValues {
  errors,             ///< as they stand; 0 at time 0
  subtract_start,     ///< values, energies say: error = value − value at the first time
  relative_to_start,  ///< error = (value − value at the first time) / |value at the first time|
};

/// Makes errors of the values of each member, counted from its value at the first time; that time is left out, and the
/// others are counted from it. A difference of nearby doubles is exact, so nothing but the file's own rounding goes in.
/// @param where  begins complaints: "energies.h5: 'leapfrog/energy'"
/// @throws InputError if fewer than two times are left, or, relative, a member begins with 0
void count_from_start(Ensemble& ensemble, FileValues values, std::string const& where);

}  // namespace brouwer
