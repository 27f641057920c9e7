#include "analysis/files/hdf5_times.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <brouwer/error.hpp>
#include <brouwer/spelling.hpp>
#include <optional>

#include "analysis/escape.hpp"
#include "analysis/files/foreign_ensembles.hpp"

namespace brouwer {
namespace {

using Datasets = std::vector<Hdf5Dataset>;

/// The unit that a name for times implies; nothing where it is none.
std::optional<std::string> unit_of(std::string_view path) {
  auto const leaf = lower_case(leaf_of(path));
  for (auto const& [name, unit] : time_names)
    if (leaf == name) return unit;
  return std::nullopt;
}

Hdf5Dataset const* find(Datasets const& datasets, std::string const& path) {
  auto const found = std::find_if(datasets.begin(), datasets.end(), [&](auto const& d) { return d.path == path; });
  return found == datasets.end() ? nullptr : &*found;
}

/// The axis that is as long as the vector; both are where the matrix is square.
unsigned axis_along(Hdf5Dataset const& times, Hdf5Dataset const& matrix, std::string const& where) {
  auto const n = times.extent[0];
  bool const first = matrix.extent[0] == n, second = matrix.extent[1] == n;
  if (first && second)
    throw InputError(
        fmt::format("{} is {}, as many members as times, and nothing says which is which; attach '{}' to its axis "
                    "as a dimension scale (h5py: dataset.dims[AXIS].attach_scale)",
                    where, shape_in_words(matrix.extent), one_line(times.path)));
  if (!first && !second)
    throw InputError(fmt::format("{} is {}, and '{}' has {} times: one of its axes should be that long", where,
                                 shape_in_words(matrix.extent), one_line(times.path), n));
  return second ? 1 : 0;
}

/// A scale of a time's name says all there is to know.
std::optional<Hdf5Times> from_scales(hid_t file, Datasets const& datasets, Hdf5Dataset const& matrix) {
  hdf5::Handle const opened = hdf5::open(file, matrix.path);
  for (unsigned axis = 0; axis < 2; ++axis)
    for (auto const& path : scales_of(opened, axis)) {
      auto const* scale = find(datasets, path);
      auto const unit = unit_of(path);
      if (scale && unit && scale->is_vector() && scale->extent[0] == matrix.extent[axis])
        return Hdf5Times{*scale, axis, *unit};
    }
  return std::nullopt;
}

/// In the matrix' own group, then in those above it; the best name first.
Hdf5Dataset const* beside(Datasets const& datasets, Hdf5Dataset const& matrix) {
  for (auto group = folder_of(matrix.path);; group = folder_of(group)) {
    for (auto const& [name, unit] : time_names)
      for (auto const& dataset : datasets)
        if (dataset.is_vector() && folder_of(dataset.path) == group && lower_case(leaf_of(dataset.path)) == name)
          return &dataset;
    if (group.empty()) return nullptr;
  }
}

Hdf5Dataset const& named_vector(Datasets const& datasets, std::string const& path, std::string const& where) {
  std::vector<std::string> vectors;
  for (auto const& dataset : datasets)
    if (dataset.is_vector()) vectors.push_back(dataset.path);
  auto const* found = find(datasets, path);
  if (!found)
    throw InputError(fmt::format("{}: there is no data set '{}' of times{}", where, path, suggestion(path, vectors)));
  if (!found->is_vector())
    throw InputError(fmt::format("{}: '{}' ({}) is no vector of numbers, and times are one", where, path,
                                 shape_in_words(found->extent)));
  return *found;
}

}  // namespace

Hdf5Times times_of(hid_t file, Datasets const& datasets, Hdf5Dataset const& matrix, std::string const& named,
                   std::string const& where) {
  std::string const usual = time_names[0].unit;
  if (!named.empty()) {
    auto const& times = named_vector(datasets, named, where);
    return {times, axis_along(times, matrix, where), unit_of(named).value_or(usual)};
  }
  if (auto const found = from_scales(file, datasets, matrix)) return *found;
  auto const* found = beside(datasets, matrix);
  if (!found)
    throw InputError(
        fmt::format("{} ({}) has no times: expected a vector 'time', 't' or 'steps' beside it, of as many numbers as "
                    "one of its axes, or --times NAME",
                    where, shape_in_words(matrix.extent)));
  return {*found, axis_along(*found, matrix, where), unit_of(found->path).value_or(usual)};
}

}  // namespace brouwer
