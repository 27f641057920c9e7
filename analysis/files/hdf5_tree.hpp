#pragma once
// What another program's HDF5 file holds, before any number is read.
#include <brouwer/store/hdf5.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace brouwer {

/// A data set, by its path from the root: "leapfrog/energy_error".
struct Hdf5Dataset {
  std::string path;
  hdf5::Extent extent;
  bool is_numeric = false;  ///< integers or floating-point numbers of any width
  bool is_scale = false;    ///< of the dimensions of others (HDF5's dimension scales; a netCDF file's coordinates)

  bool is_matrix() const { return is_numeric && !is_scale && extent.size() == 2; }
  bool is_vector() const { return is_numeric && extent.size() == 1; }
};

/// All data sets of the file, each once, in the order of their paths. Links into other files are not followed.
std::vector<Hdf5Dataset> datasets_in(hid_t file);

/// The last part of a path, and what stands before it ("" at the root).
std::string_view leaf_of(std::string_view path);
std::string_view folder_of(std::string_view path);

/// Is the data set in this group or below it? Everything is below "".
bool is_below(Hdf5Dataset const& dataset, std::string_view group);

/// "64 × 100"
std::string shape_in_words(hdf5::Extent const& extent);

/// The text of an attribute; nothing where there is none, or where it is no single text.
std::optional<std::string> text_attribute(hid_t object, char const* name);

/// The paths of the scales of one axis of a data set.
std::vector<std::string> scales_of(hid_t dataset, unsigned axis);

/// All numbers, row by row, as doubles: chunked, compressed, of whatever width, as HDF5 converts them.
/// @throws hdf5::Failure with HDF5's reason
std::vector<double> numbers_of(hid_t file, Hdf5Dataset const& dataset);

}  // namespace brouwer
