#include <algorithm>
#include <functional>
#include <numeric>

#include <brouwer/error.hpp>
#include <brouwer/store/file.hpp>
#include <brouwer/store/hdf5.hpp>
#include <brouwer/store/unit_layout.hpp>

namespace brouwer {
namespace {

using hdf5::checked;
using hdf5::Failure;
using hdf5::Handle;

Handle open_file(std::filesystem::path const& file) {
  Handle opened = hdf5::open_to_read(file);
  if (hdf5::text(opened, "format") != unit_layout::format) throw Failure("it is no unit file");
  if (hdf5::integer(opened, "format_version") != unit_layout::version)
    throw Failure("its format is of another version");
  return opened;
}

/// Far beyond any ensemble, so that first_member + members does not overflow.
constexpr std::int64_t max_member = std::int64_t{1} << 62;

CellLabels read_labels(hid_t file) {
  CellLabels cell;
  cell.system = hdf5::text(file, "system");
  cell.method = hdf5::text(file, "method");
  cell.arithmetic = hdf5::text(file, "arithmetic");
  cell.special_functions = hdf5::text(file, "special_functions");
  // units from before this factor: no method had it
  cell.coefficients = hdf5::has(file, "coefficients") ? hdf5::text(file, "coefficients") : no_level;
  cell.compensation = hdf5::integer(file, "compensation") != 0;
  if (hdf5::has(file, "rounding")) {  // units from before these factors: the standard
    cell.rounding = hdf5::text(file, "rounding");
    cell.constants = hdf5::text(file, "constants");
    cell.contraction = hdf5::integer(file, "contraction") != 0;
  }
  cell.step = hdf5::real(file, "step_size");
  cell.steps = hdf5::integer(file, "steps");
  return cell;
}

bool has_dataset(hid_t file, char const* name) { return checked(H5Lexists(file, name, H5P_DEFAULT)) > 0; }

/// Length of a one-dimensional data set.
std::size_t length(hid_t dataset) {
  auto const extent = hdf5::extent(dataset);
  if (extent.size() != 1) throw Failure("its arrays do not fit together");
  return extent[0];
}

std::vector<std::int64_t> read_steps(hid_t file) {
  Handle const dataset = hdf5::open(file, unit_layout::step);
  std::vector<std::int64_t> steps(length(dataset));
  hdf5::read(dataset, std::span(steps));
  bool const increasing = std::adjacent_find(steps.begin(), steps.end(), std::greater_equal<>()) == steps.end();
  if (!increasing) throw Failure("its samples are out of order");
  return steps;
}

/// Names of the members of a group in the order in which they were written.
std::vector<std::string> names_in(hid_t group) {
  H5G_info_t info = {};
  checked(H5Gget_info(group, &info));
  std::vector<std::string> names;
  for (hsize_t i = 0; i < info.nlinks; ++i) {
    auto const name_of = [&](char* to, std::size_t size) {
      return checked(H5Lget_name_by_idx(group, ".", H5_INDEX_CRT_ORDER, H5_ITER_INC, i, to, size, H5P_DEFAULT));
    };
    std::string name(static_cast<std::size_t>(name_of(nullptr, 0)), '\0');
    name_of(name.data(), name.size() + 1);
    names.push_back(name);
  }
  return names;
}

Series read_series_header(hid_t group, std::string const& name, UnitRecord const& unit) {
  Handle const dataset = hdf5::open(group, name);
  auto const extent = hdf5::extent(dataset);
  bool const fits =
      extent.size() == 2 && extent[0] <= static_cast<hsize_t>(unit.members) && extent[1] == unit.sample_steps.size();
  if (!fits) throw Failure("its arrays do not fit together");
  auto const members = static_cast<std::int64_t>(extent[0]);
  bool const count = hdf5::has(dataset, unit_layout::count) && hdf5::integer(dataset, unit_layout::count) != 0;
  return {name, hdf5::text(dataset, "quantity"), hdf5::text(dataset, "units"), members, {}, count};
}

/// Units from before failures were recorded, and those of which nothing was, do not have these lists.
void read_failures(hid_t file, UnitRecord& unit) {
  if (!has_dataset(file, unit_layout::failed_at) && !has_dataset(file, unit_layout::failure)) return;
  Handle const at = hdf5::open(file, unit_layout::failed_at), why = hdf5::open(file, unit_layout::failure);
  auto const members = static_cast<std::size_t>(unit.members);
  if (length(at) != members || length(why) != members) throw Failure("its arrays do not fit together");
  unit.failed_at.resize(members);
  hdf5::read(at, std::span(unit.failed_at));
  unit.failure = hdf5::read_texts(why);
}

UnitRecord read_header(hid_t file) {
  UnitRecord unit;
  unit.study_hash = hdf5::text(file, "study_hash");
  unit.cell = read_labels(file);
  if (hdf5::has(file, "reference")) unit.reference = hdf5::text(file, "reference");
  unit.first_member = hdf5::integer(file, "first_member");
  unit.members = static_cast<std::int64_t>(length(hdf5::open(file, unit_layout::member)));
  if (unit.first_member < 0 || unit.first_member > max_member) throw Failure("its members have no number");
  unit.sample_steps = read_steps(file);
  unit.start_names = hdf5::read_texts(hdf5::open(file, unit_layout::start_component));
  unit.state_names = hdf5::read_texts(hdf5::open(file, unit_layout::state_component));
  read_failures(file, unit);
  Handle const group(H5Gopen2(file, unit_layout::errors, H5P_DEFAULT));
  for (auto const& name : names_in(group)) unit.series.push_back(read_series_header(group, name, unit));
  return unit;
}

/// A data set of this shape; hdf5::extent has made sure that the file holds as many numbers.
std::vector<double> read_array(hid_t group, std::string const& name, hdf5::Extent const& shape) {
  Handle const dataset = hdf5::open(group, name);
  if (hdf5::extent(dataset) != shape) throw Failure("its arrays do not fit together");
  std::vector<double> numbers(std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>()));
  hdf5::read(dataset, std::span(numbers));
  return numbers;
}

/// [member][sample][state component]; nothing where the study did not ask for it.
std::vector<double> read_states(hid_t file, UnitRecord const& unit) {
  if (!has_dataset(file, unit_layout::states)) return {};
  return read_array(file, unit_layout::states,
                    {static_cast<hsize_t>(unit.members), unit.sample_steps.size(), unit.state_names.size()});
}

void read_ends(hid_t file, UnitRecord& unit) {
  auto const members = static_cast<hsize_t>(unit.members);
  unit.start = read_array(file, unit_layout::start, {members, unit.start_names.size()});
  unit.final_state = read_array(file, unit_layout::final_state, {members, unit.state_names.size()});
}

void read_numbers(hid_t file, UnitRecord& unit) {
  read_ends(file, unit);
  unit.states = read_states(file, unit);
  Handle const group(H5Gopen2(file, unit_layout::errors, H5P_DEFAULT));
  for (auto& series : unit.series)
    series.errors = read_array(group, series.name, {static_cast<hsize_t>(series.members), unit.sample_steps.size()});
}

/// Runs `read` on the opened file; what HDF5 says of it becomes a sentence about the file.
template <class Read>
auto reading(std::filesystem::path const& file, Read read) {
  hdf5::Session const session;
  try {
    return read(open_file(file));
  } catch (Failure const& failure) {
    throw RunError("cannot read the unit " + file.string() + ": " + failure.what() +
                   "; delete it and run the study again to compute it anew");
  }
}

}  // namespace

UnitRecord read_unit_header(std::filesystem::path const& file) {
  return reading(file, [](Handle const& opened) { return read_header(opened); });
}

UnitRecord read_unit_ends(std::filesystem::path const& file) {
  return reading(file, [](Handle const& opened) {
    UnitRecord unit = read_header(opened);
    read_ends(opened, unit);
    return unit;
  });
}

UnitRecord read_unit(std::filesystem::path const& file) {
  return reading(file, [](Handle const& opened) {
    UnitRecord unit = read_header(opened);
    read_numbers(opened, unit);
    return unit;
  });
}

std::vector<double> read_states(std::filesystem::path const& file) {
  return reading(file, [](Handle const& opened) { return read_states(opened, read_header(opened)); });
}

void read_series(std::filesystem::path const& file, std::string const& name, std::span<double> errors) {
  reading(file, [&](Handle const& opened) {
    Handle const group(H5Gopen2(opened, unit_layout::errors, H5P_DEFAULT));
    hdf5::read(hdf5::open(group, name), errors);
  });
}

}  // namespace brouwer
