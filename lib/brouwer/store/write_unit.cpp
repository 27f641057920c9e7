#include <functional>
#include <hdf5_hl.h>  // H5DS: dimension scales
#include <map>
#include <numeric>
#include <stdexcept>

#include <brouwer/error.hpp>
#include <brouwer/store/file.hpp>
#include <brouwer/store/hdf5.hpp>
#include <brouwer/store/unit_layout.hpp>
#include <brouwer/store/whole_file.hpp>

namespace brouwer {
namespace {

using hdf5::checked;
using hdf5::Extent;
using hdf5::Handle;

/// What is inside keeps the order in which it was made, but not the time.
void order_without_time(hid_t creation) {
  checked(H5Pset_obj_track_times(creation, false));
  checked(H5Pset_attr_creation_order(creation, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED));
  checked(H5Pset_link_creation_order(creation, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED));
}

/// A file that lives in memory only. The format is that of HDF5 1.8, the first in which the library
/// guards everything but the numbers by checksums.
Handle file_in_memory() {
  Handle const creation(H5Pcreate(H5P_FILE_CREATE)), access(H5Pcreate(H5P_FILE_ACCESS));
  order_without_time(creation);
  checked(H5Pset_fapl_core(access, 1 << 20, /*backing_store=*/false));
  checked(H5Pset_libver_bounds(access, H5F_LIBVER_V18, H5F_LIBVER_V18));
  return Handle(H5Fcreate("unit", H5F_ACC_TRUNC, creation, access));
}

Handle ordered_group(hid_t file, char const* name) {
  Handle const creation(H5Pcreate(H5P_GROUP_CREATE));
  order_without_time(creation);
  return Handle(H5Gcreate2(file, name, H5P_DEFAULT, creation, H5P_DEFAULT));
}

/// The file as it stands in memory after a flush. H5Fget_file_image would do, but that of HDF5 1.10 clears the flag
/// "open for writing" without renewing the checksum over it; a superblock of version 2 ignores the flag anyway.
std::string bytes_of(hid_t file) {
  checked(H5Fflush(file, H5F_SCOPE_GLOBAL));
  auto const size = checked(H5Fget_file_image(file, nullptr, 0));
  char** memory = nullptr;
  checked(H5Fget_vfd_handle(file, H5P_DEFAULT, reinterpret_cast<void**>(&memory)));
  return {*memory, static_cast<std::size_t>(size)};
}

std::vector<std::int64_t> member_numbers(UnitRecord const& record, std::int64_t count) {
  std::vector<std::int64_t> numbers(static_cast<std::size_t>(count));
  std::iota(numbers.begin(), numbers.end(), record.first_member);
  return numbers;
}

std::vector<double> times(UnitRecord const& record) {
  std::vector<double> result;
  for (auto const step : record.sample_steps) result.push_back(static_cast<double>(step) * record.cell.step);
  return result;
}

/// A coordinate axis that data sets lie along.
struct Axis {
  Handle scale;
  hsize_t size;
};

/// The file under construction.
class UnitFile {
 public:
  explicit UnitFile(UnitRecord const& record)
      : record_(record),
        file_(file_in_memory()),
        step_(axis(unit_layout::step, std::span(record.sample_steps), "number of steps taken")) {}

  std::string finished() {
    set_labels();
    put_time();
    put_table(unit_layout::start, unit_layout::start_component, record_.start_names, record_.start,
              "parameters and state that were integrated");
    Axis const state = put_table(unit_layout::final_state, unit_layout::state_component, record_.state_names,
                                 record_.final_state, "state after the last step, rounded to double");
    put_failures();
    put_states(state);
    Handle const group = ordered_group(file_, unit_layout::errors);
    for (auto const& series : record_.series) put_series(group, series);
    return bytes_of(file_);
  }

 private:
  void set_labels() {
    auto const& cell = record_.cell;
    set(file_, "format", unit_layout::format);
    set(file_, "format_version", unit_layout::version);
    set(file_, "study_hash", record_.study_hash);
    set(file_, "system", cell.system);
    set(file_, "method", cell.method);
    set(file_, "arithmetic", cell.arithmetic);
    set(file_, "special_functions", cell.special_functions);
    set(file_, "coefficients", cell.coefficients);
    set(file_, "compensation", std::int64_t{cell.compensation});
    set(file_, "rounding", cell.rounding);
    set(file_, "constants", cell.constants);
    set(file_, "contraction", std::int64_t{cell.contraction});
    set(file_, "step_size", cell.step);
    set(file_, "steps", cell.steps);
    set(file_, "reference", record_.reference);
    set(file_, "first_member", record_.first_member);
  }

  template <class Values>
  Axis axis(std::string const& name, Values const& values, std::string const& meaning) {
    Handle dataset = create_list(name, values);
    checked(H5DSset_scale(dataset, name.c_str()));
    set(dataset, "long_name", meaning);
    return {std::move(dataset), values.size()};
  }
  Handle create_list(std::string const& name, std::span<std::int64_t const> values) {
    return hdf5::create(file_, name, {values.size()}, values);
  }
  Handle create_list(std::string const& name, std::vector<std::string> const& names) {
    return hdf5::create(file_, name, names);
  }

  /// The axis of the unit's first `count` members.
  Axis const& members(std::int64_t count) {
    auto const known = members_.find(count);
    if (known != members_.end()) return known->second;
    std::string const all = unit_layout::member;
    auto const name = count == record_.members ? all : all + "_" + std::to_string(count);
    auto const numbers = member_numbers(record_, count);
    return members_.emplace(count, axis(name, std::span(numbers), "member of the ensemble")).first->second;
  }

  void put_time() {
    Handle const time = hdf5::create(file_, unit_layout::time, {step_.size}, times(record_));
    checked(H5DSattach_scale(time, step_.scale, 0));
    set(time, "long_name", "time, steps times step size");
  }

  /// An array along these axes, row-major.
  Handle put(hid_t group, std::string const& name, std::vector<Axis const*> const& axes,
             std::vector<double> const& values) {
    Extent extent;
    for (auto const* along : axes) extent.push_back(along->size);
    auto const size = std::accumulate(extent.begin(), extent.end(), hsize_t{1}, std::multiplies<>());
    if (values.size() != size) throw std::logic_error("unit record: wrong size of " + name);
    Handle dataset = hdf5::create(group, name, extent, values);
    for (unsigned i = 0; i < axes.size(); ++i) checked(H5DSattach_scale(dataset, axes[i]->scale, i));
    return dataset;
  }

  Axis put_table(char const* name, char const* component, std::vector<std::string> const& names,
                 std::vector<double> const& values, std::string const& meaning) {
    Axis columns = axis(component, names, "component");
    set(put(file_, name, {&members(record_.members), &columns}, values), "long_name", meaning);
    return columns;
  }

  /// One value a member.
  template <class Values>
  void put_list(char const* name, Values const& values, std::string const& meaning) {
    Axis const& rows = members(record_.members);
    if (values.size() != rows.size) throw std::logic_error(std::string("unit record: wrong size of ") + name);
    Handle const dataset = create_list(name, values);
    checked(H5DSattach_scale(dataset, rows.scale, 0));
    set(dataset, "long_name", meaning);
  }

  /// Absent where nothing is recorded, so that what older units hold is the same bytes when it is written again.
  void put_failures() {
    if (record_.failed_at.empty() && record_.failure.empty()) return;
    put_list(unit_layout::failed_at, std::span(record_.failed_at), "step at which a member had no next state, or -1");
    put_list(unit_layout::failure, record_.failure, "why it had none");
  }

  void put_states(Axis const& components) {
    if (record_.states.empty()) return;
    set(put(file_, unit_layout::states, {&members(record_.members), &step_, &components}, record_.states), "long_name",
        "state at the samples, rounded to double");
  }

  void put_series(hid_t group, Series const& series) {
    Handle const dataset = put(group, series.name, {&members(series.members), &step_}, series.errors);
    set(dataset, "quantity", series.quantity);
    set(dataset, "units", series.unit);
    set(dataset, "long_name", (series.count ? "" : "error of ") + series.name);
    if (series.count) set(dataset, unit_layout::count, std::int64_t{1});
  }

  UnitRecord const& record_;
  Handle file_;
  Axis step_;
  std::map<std::int64_t, Axis> members_;
};

}  // namespace

void write_unit(std::filesystem::path const& file, UnitRecord const& record) {
  auto const bytes = [&] {
    hdf5::Session const session;
    try {
      return UnitFile(record).finished();
    } catch (hdf5::Failure const& failure) {
      throw RunError("cannot build " + file.string() + ": " + failure.what());
    }
  }();
  write_whole(file, bytes);
}

}  // namespace brouwer
