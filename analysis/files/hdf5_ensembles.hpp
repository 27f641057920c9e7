#pragma once
#include <brouwer/store/results.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "analysis/files/from_start.hpp"

namespace brouwer {

/// Ensembles that another program wrote as HDF5, also as netCDF-4: matrices members × times or times × members with a
/// vector of times, of integers or floating-point numbers of any width, chunked or compressed as it may be.
///
/// Which data sets are ensembles: the one that is named, all matrices of the group that is named, or those that have
/// `error` in their path; a single matrix by whatever name. Their times: hdf5_times.hpp. A data set's name is the
/// ensemble's quantity; attributes `quantity`, `system`, `method`, `arithmetic` and `units` of it or of the groups above
/// it label it, and otherwise its group's path is its method. Nothing else is asked of the file.
/// Times must be finite, not negative and increasing; at a time 0 errors must be 0, and are left out.
/// @param dataset, times  paths; "": guess
/// @throws InputError in one sentence with the file, the data set, what was found and what was expected
std::vector<Ensemble> read_hdf5(std::filesystem::path const& file, std::string const& dataset = "",
                                std::string const& times = "", FileValues values = FileValues::errors);

}  // namespace brouwer
