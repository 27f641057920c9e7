#include "analysis/files/hdf5_tree.hpp"

#include <fmt/format.h>
#include <hdf5_hl.h>  // H5DS: dimension scales

#include <algorithm>

namespace brouwer {
namespace {

using hdf5::checked;
using hdf5::Handle;

/// More is no ensemble, or a damaged file that says it holds so much.
constexpr hsize_t most_numbers = 1'000'000'000;

bool is_numeric(hid_t dataset) {
  Handle const type(H5Dget_type(dataset));
  auto const kind = H5Tget_class(type);
  return kind == H5T_INTEGER || kind == H5T_FLOAT;
}

hdf5::Extent extent_of(hid_t dataset) {
  Handle const space(H5Dget_space(dataset));
  hdf5::Extent extent(static_cast<std::size_t>(checked(H5Sget_simple_extent_ndims(space))));
  checked(H5Sget_simple_extent_dims(space, extent.data(), nullptr));
  return extent;
}

herr_t note_dataset(hid_t, char const* name, H5O_info_t const* info, void* paths) {
  if (info->type == H5O_TYPE_DATASET) static_cast<std::vector<std::string>*>(paths)->emplace_back(name);
  return 0;
}

/// HDF5 calls these; nothing may be thrown through it.
herr_t note_scale(hid_t, unsigned, hid_t scale, void* paths) {
  auto const size = H5Iget_name(scale, nullptr, 0);
  if (size <= 0) return -1;
  std::string name(static_cast<std::size_t>(size), '\0');
  H5Iget_name(scale, name.data(), name.size() + 1);
  static_cast<std::vector<std::string>*>(paths)->push_back(name.substr(1));  // without the root's slash
  return 0;
}

/// Of variable length, as Python and netCDF write texts: HDF5 allocates it.
std::string variable_text(hid_t attribute, hid_t type) {
  char* text = nullptr;
  checked(H5Aread(attribute, type, static_cast<void*>(&text)));
  std::string const copy = text ? text : "";
  H5free_memory(text);
  return copy;
}

}  // namespace

std::vector<Hdf5Dataset> datasets_in(hid_t file) {
  std::vector<std::string> paths;
  checked(H5Ovisit2(file, H5_INDEX_NAME, H5_ITER_INC, note_dataset, &paths, H5O_INFO_BASIC));
  std::vector<Hdf5Dataset> datasets;
  for (auto const& path : paths) {
    Handle const dataset = hdf5::open(file, path);
    datasets.push_back({path, extent_of(dataset), is_numeric(dataset), H5DSis_scale(dataset) > 0});
  }
  return datasets;
}

std::string_view leaf_of(std::string_view path) {
  auto const slash = path.rfind('/');
  return slash == std::string_view::npos ? path : path.substr(slash + 1);
}

std::string_view folder_of(std::string_view path) {
  auto const slash = path.rfind('/');
  return slash == std::string_view::npos ? std::string_view() : path.substr(0, slash);
}

bool is_below(Hdf5Dataset const& dataset, std::string_view group) {
  return group.empty() || dataset.path.starts_with(std::string(group) + '/');
}

std::string shape_in_words(hdf5::Extent const& extent) {
  return extent.empty() ? "a single value" : fmt::format("{}", fmt::join(extent, " × "));
}

std::optional<std::string> text_attribute(hid_t object, char const* name) {
  if (!hdf5::has(object, name)) return std::nullopt;
  Handle const attribute(H5Aopen(object, name, H5P_DEFAULT)), type(H5Aget_type(attribute)),
      space(H5Aget_space(attribute));
  if (H5Tget_class(type) != H5T_STRING || H5Sget_simple_extent_npoints(space) != 1) return std::nullopt;
  return H5Tis_variable_str(type) > 0 ? variable_text(attribute, type) : hdf5::text(object, name);
}

std::vector<std::string> scales_of(hid_t dataset, unsigned axis) {
  std::vector<std::string> paths;
  if (H5DSget_num_scales(dataset, axis) > 0) checked(H5DSiterate_scales(dataset, axis, nullptr, note_scale, &paths));
  return paths;
}

std::vector<double> numbers_of(hid_t file, Hdf5Dataset const& dataset) {
  hsize_t count = 1;
  for (auto const n : dataset.extent)
    if (__builtin_mul_overflow(count, n, &count) || count > most_numbers)
      throw hdf5::Failure("it says that it holds more than 10⁹ numbers");
  std::vector<double> numbers(count);
  Handle const opened = hdf5::open(file, dataset.path);
  if (count > 0) checked(H5Dread(opened, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data()));
  return numbers;
}

}  // namespace brouwer
