#pragma once
// A small unit for the store's tests, in which every number is different.
#include <cmath>
#include <cstring>
#include <filesystem>
#include <gtest/gtest.h>
#include <limits>
#include <string>
#include <vector>

#include <brouwer/store/file.hpp>
#include <brouwer/store/folder.hpp>
#include <brouwer/store/hdf5.hpp>

#include "tests/scratch.hpp"

namespace brouwer {

inline std::vector<double> distinct_numbers(std::size_t count, double scale) {
  std::vector<double> numbers(count);
  for (std::size_t i = 0; i < count; ++i) numbers[i] = scale * std::sin(1.0 + static_cast<double>(i));
  return numbers;
}

/// No method has all of these; the store does not ask.
inline CellLabels sample_cell() {
  return {"rigid_body", "elliptic-naive", "double", "own", "per-trajectory", true, 0.1 + 0.2,
          1000,         "stochastic",     "exact",  true};
}

/// `members` members from `first`, of which the first three at most are compared with a reference.
inline UnitRecord sample_unit(std::int64_t first = 64, std::int64_t members = 5) {
  UnitRecord unit;
  unit.study_hash = "f81d4fae-7dec-11d0-a765-00a0c91e6bf6";
  unit.cell = sample_cell();
  unit.first_member = first;
  unit.members = members;
  unit.sample_steps = {1, 10, 100, 1000};
  auto const rows = static_cast<std::size_t>(members), compared = std::min<std::size_t>(rows, 3);
  auto const seed = 1e-16 * static_cast<double>(first + 1);
  for (auto const* name : {"energy", "casimir", "attitude-norm", "spatial-momentum-1", "z", "a", "b", "c", "d"})
    unit.series.push_back({name, "quantity of " + std::string(name), "kg m²/s²", members,
                           distinct_numbers(rows * 4, seed * static_cast<double>(1 + unit.series.size()))});
  unit.series.push_back(
      {"y1", "state", "", static_cast<std::int64_t>(compared), distinct_numbers(compared * 4, 1e-15)});
  unit.series.push_back({"y2", "state", "", 0, {}});
  unit.start_names = {"inertia-1", "y1"};
  unit.start = distinct_numbers(rows * 2, 1);
  unit.state_names = {"y1", "y2", "q0"};
  unit.final_state = distinct_numbers(rows * 3, 2);
  return unit;
}

/// All that a unit may hold: members that failed, a series that counts, states at the samples.
inline UnitRecord full_unit(std::int64_t first = 64) {
  UnitRecord unit = sample_unit(first);
  unit.reference = "mpfr-256";
  unit.series.push_back({"iterations", "iterations", "iterations per step", 5, distinct_numbers(20, 9), true});
  unit.failed_at = {-1, 17, -1, 1000, -1};
  unit.failure = {"", "collision", "", "the iteration did not converge", ""};
  unit.states = distinct_numbers(5 * 4 * 3, 3);
  return unit;
}

/// Makes a unit as it was written before these labels.
inline void forget(std::filesystem::path const& file, std::vector<char const*> const& labels) {
  hdf5::Session const session;
  hdf5::Handle const opened(H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT));
  for (auto const* label : labels) hdf5::checked(H5Adelete(opened, label));
}

inline bool same_bits(std::vector<double> const& a, std::vector<double> const& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0);
}

inline bool same(Series const& a, Series const& b) {
  return a.name == b.name && a.quantity == b.quantity && a.unit == b.unit && a.members == b.members &&
         a.count == b.count && same_bits(a.errors, b.errors);
}

inline bool same(UnitRecord const& a, UnitRecord const& b) {
  return a.study_hash == b.study_hash && a.cell == b.cell && a.reference == b.reference &&
         a.first_member == b.first_member && a.members == b.members && a.sample_steps == b.sample_steps &&
         std::equal(a.series.begin(), a.series.end(), b.series.begin(), b.series.end(),
                    [](auto const& x, auto const& y) { return same(x, y); }) &&
         a.start_names == b.start_names && same_bits(a.start, b.start) && a.state_names == b.state_names &&
         same_bits(a.final_state, b.final_state) && a.failed_at == b.failed_at && a.failure == b.failure &&
         same_bits(a.states, b.states);
}

}  // namespace brouwer
