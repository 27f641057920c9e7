#pragma once
#include <brouwer/store/results.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "analysis/files/from_start.hpp"

namespace brouwer {

/// How a file of another program is to be read.
struct FileReading {
  std::string dataset = {}, times = {};  ///< paths inside an HDF5 file; "": guess
  FileValues values = FileValues::errors;
};

/// The ensembles in a file of another program: csv (csv.hpp), HDF5 or netCDF-4 (hdf5_ensembles.hpp). Of which kind it
/// is, its first bytes say, whatever its name.
/// @throws InputError as those two do; for other kinds that are known, what to do about it; where a data set is named in
///         a text file
std::vector<Ensemble> read_ensembles(std::filesystem::path const& file, FileReading const& reading = {});

}  // namespace brouwer
