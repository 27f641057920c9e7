#pragma once
#include <string>
#include <vector>

#include "analysis/files/hdf5_tree.hpp"

namespace brouwer {

/// The times of a matrix of errors: where they stand, along which axis, and their unit.
struct Hdf5Times {
  Hdf5Dataset dataset;
  unsigned axis = 1;
  std::string unit;  ///< "step" or "time unit", as their name implies
};

/// Finds the times of `matrix`: the vector that is named, or that is a dimension scale of one of its axes, or that
/// stands beside it or in a group above it, by a name for times (csv_forms.hpp). Which axis they belong to, the scale
/// says, or else their number.
/// @param named  its path; "": guess
/// @throws InputError that says what was found and what was expected; `where` begins it
Hdf5Times times_of(hid_t file, std::vector<Hdf5Dataset> const& datasets, Hdf5Dataset const& matrix,
                   std::string const& named, std::string const& where);

}  // namespace brouwer
