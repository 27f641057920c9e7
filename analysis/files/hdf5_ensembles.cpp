#include "analysis/files/hdf5_ensembles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <brouwer/error.hpp>
#include <brouwer/spelling.hpp>
#include <brouwer/store/unit_layout.hpp>
#include <cmath>

#include "analysis/escape.hpp"
#include "analysis/files/foreign_ensembles.hpp"
#include "analysis/files/hdf5_times.hpp"

namespace brouwer {
namespace {

using hdf5::Handle;
using Datasets = std::vector<Hdf5Dataset>;

/// What was asked for, and of which file.
struct Request {
  std::string file, dataset, times;
  FileValues values;
};

// --- which data sets ------------------------------------------------------------------------------

std::vector<std::string> paths_of(Datasets const& datasets) {
  std::vector<std::string> paths;
  for (auto const& dataset : datasets) paths.push_back(dataset.path);
  return paths;
}

Datasets matrices_in(Datasets const& datasets, std::string const& group) {
  Datasets matrices;
  for (auto const& dataset : datasets)
    if (dataset.is_matrix() && is_below(dataset, group)) matrices.push_back(dataset);
  return matrices;
}

/// Also one that says so of a quantity which nobody observed, and is empty, is none.
bool is_called_error(Hdf5Dataset const& dataset) {
  if (dataset.extent[0] == 0 || dataset.extent[1] == 0) return false;
  return lower_case(dataset.path).find("error") != std::string::npos;
}

/// "energy (64 × 100), time (100)"; of many the first.
std::string listed(Datasets const& datasets) {
  constexpr std::size_t most = 8;
  std::vector<std::string> words;
  for (auto const& dataset : datasets)
    if (words.size() < most)
      words.push_back(fmt::format("'{}' ({})", one_line(dataset.path), shape_in_words(dataset.extent)));
  return fmt::format("{}{}", fmt::join(words, ", "), datasets.size() > most ? " …" : "");
}

Datasets named(Request const& request, Datasets const& all) {
  for (auto const& dataset : all) {
    if (dataset.path != request.dataset) continue;
    if (dataset.is_matrix()) return {dataset};
    throw InputError(fmt::format("{}: '{}' is {}, expected a matrix of numbers, members × times or times × members",
                                 request.file, request.dataset,
                                 dataset.is_numeric ? shape_in_words(dataset.extent) : "no set of numbers"));
  }
  auto const below = matrices_in(all, request.dataset);
  if (!below.empty()) return below;
  throw InputError(fmt::format("{}: there is no data set '{}'{}", request.file, request.dataset,
                               suggestion(request.dataset, paths_of(all))));
}

Datasets guessed(Request const& request, Datasets const& all) {
  auto const matrices = matrices_in(all, "");
  if (matrices.empty())
    throw InputError(fmt::format("{}: there is no matrix of numbers (members × times or times × members); {}",
                                 request.file, all.empty() ? "the file has no data set" : "there is " + listed(all)));
  if (matrices.size() == 1) return matrices;
  Datasets errors;
  if (request.values == FileValues::errors)
    std::copy_if(matrices.begin(), matrices.end(), std::back_inserter(errors), is_called_error);
  if (errors.empty())
    throw InputError(fmt::format("{}: which of these are the ensemble: {}? Name it with --dataset, or its group",
                                 request.file, listed(matrices)));
  return errors;
}

// --- what they are called -------------------------------------------------------------------------

/// An attribute of the data set, or of the nearest group above it that has it.
std::string label(hid_t file, Hdf5Dataset const& dataset, char const* name) {
  for (std::string_view path = dataset.path;; path = folder_of(path)) {
    Handle const object(H5Oopen(file, path.empty() ? "/" : std::string(path).c_str(), H5P_DEFAULT));
    if (auto const text = text_attribute(object, name)) return *text;
    if (path.empty()) return "";
  }
}

/// Groups tell methods apart where nothing else does; a group that only says "errors" tells nothing.
std::string method_by_group(Hdf5Dataset const& dataset) {
  auto const group = folder_of(dataset.path);
  return leaf_of(group) == unit_layout::errors ? std::string(folder_of(group)) : std::string(group);
}

Ensemble labelled(hid_t file, Hdf5Dataset const& dataset) {
  Ensemble ensemble;
  auto const quantity = label(file, dataset, "quantity");
  ensemble.quantity = leaf_of(dataset.path);
  ensemble.family = quantity.empty() ? ensemble.quantity : quantity;
  ensemble.unit = label(file, dataset, "units");
  ensemble.cell.system = label(file, dataset, "system");
  ensemble.cell.method = label(file, dataset, "method");
  ensemble.cell.arithmetic = label(file, dataset, "arithmetic");
  if (ensemble.cell.method.empty()) ensemble.cell.method = method_by_group(dataset);
  if (text_attribute(file, "format") == unit_layout::format)  // one of our own units
    ensemble.count = hdf5::has(hdf5::open(file, dataset.path), unit_layout::count);
  return ensemble;
}

// --- the numbers ----------------------------------------------------------------------------------

void require_times(std::vector<double> const& times, std::string const& where) {
  for (std::size_t j = 0; j < times.size(); ++j) {
    if (!std::isfinite(times[j]) || times[j] < 0)
      throw InputError(fmt::format("{}: expected finite times from 0 on, found {} as number {}", where, times[j], j));
    if (j > 0 && times[j] <= times[j - 1])
      throw InputError(fmt::format("{}: expected increasing times, found {} after {}", where, times[j], times[j - 1]));
  }
}

ErrorMatrix members_by_times(std::vector<double> const& numbers, hdf5::Extent const& extent, unsigned time_axis) {
  Eigen::Map<ErrorMatrix const> const stored(numbers.data(), static_cast<Eigen::Index>(extent[0]),
                                             static_cast<Eigen::Index>(extent[1]));
  return time_axis == 1 ? ErrorMatrix(stored) : ErrorMatrix(stored.transpose());
}

void require_finite(Ensemble const& ensemble, std::string const& where) {
  for (Eigen::Index i = 0; i < ensemble.errors.rows(); ++i)
    for (Eigen::Index j = 0; j < ensemble.errors.cols(); ++j)
      if (!std::isfinite(ensemble.errors(i, j)))
        throw InputError(fmt::format("{}: expected finite numbers, found {} of member {} (from 0) at time {}", where,
                                     ensemble.errors(i, j), i, ensemble.times[static_cast<std::size_t>(j)]));
}

/// Errors count from time 0: what stands there must be 0, and is left out.
void leave_out_zero(Ensemble& ensemble, std::string const& where) {
  if (ensemble.times.empty() || ensemble.times.front() != 0) return;
  double const most = ensemble.errors.col(0).cwiseAbs().maxCoeff();
  if (most != 0)
    throw InputError(
        fmt::format("{}: the errors at time 0 reach {:g}, and errors are counted from 0 there: are these values? "
                    "--subtract-start or --relative-to-start makes errors of them",
                    where, most));
  ErrorMatrix later = ensemble.errors.rightCols(ensemble.errors.cols() - 1);
  ensemble.errors = std::move(later);
  ensemble.times.erase(ensemble.times.begin());
}

Ensemble read_one(hid_t file, Datasets const& all, Hdf5Dataset const& dataset, Request const& request) {
  auto const where = fmt::format("{}: '{}'", request.file, one_line(dataset.path));
  auto const times = times_of(file, all, dataset, request.times, where);
  Ensemble ensemble = labelled(file, dataset);
  ensemble.time_unit = times.unit;
  ensemble.times = numbers_of(file, times.dataset);
  require_times(ensemble.times, fmt::format("{}: '{}'", request.file, one_line(times.dataset.path)));
  ensemble.errors = members_by_times(numbers_of(file, dataset), dataset.extent, times.axis);
  require_an_ensemble(ensemble, where);
  require_finite(ensemble, where);
  if (request.values == FileValues::errors) leave_out_zero(ensemble, where);
  count_from_start(ensemble, request.values, where);
  require_an_ensemble(ensemble, where);
  return ensemble;
}

}  // namespace

std::vector<Ensemble> read_hdf5(std::filesystem::path const& file, std::string const& dataset, std::string const& times,
                                FileValues values) {
  Request const request{file.string(), dataset, times, values};
  hdf5::Session const session;
  try {
    Handle const opened = hdf5::open_to_read(file);
    auto const all = datasets_in(opened);
    std::vector<Ensemble> ensembles;
    for (auto const& chosen : dataset.empty() ? guessed(request, all) : named(request, all))
      ensembles.push_back(read_one(opened, all, chosen, request));
    return ensembles;
  } catch (hdf5::Failure const& failure) {
    throw InputError(fmt::format("{}: cannot be read as HDF5: {}", request.file, failure.what()));
  }
}

}  // namespace brouwer
