#pragma once
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <brouwer/error.hpp>
#include <vector>

#include "analysis/files/ensembles_file.hpp"
#include "tests/analysis/files/hdf5_writer.hpp"
#include "tests/store/sample_unit.hpp"

namespace brouwer {

inline std::vector<double> const by_member = {1e-17, -2e-17, 3e-17, 4e-17, 5e-17, 0};  // 3 members × 2 times
inline std::vector<double> const by_time = {1e-17, 3e-17, 5e-17, -2e-17, 4e-17, 0};
inline std::vector<double> const times = {1, 2};

/// A file in a folder of its own, and what is made of it.
struct Hdf5Ensembles : testing::Test {
  Scratch scratch;
  std::filesystem::path const file = scratch / "run.h5";

  std::vector<Ensemble> read(FileReading const& reading = {}) const { return read_ensembles(file, reading); }

  /// What is said of the file, without the folder.
  std::string complaint(FileReading const& reading = {}) const {
    try {
      read(reading);
    } catch (InputError const& error) {
      std::string const message = error.what(), place = scratch.path().string() + "/";
      return message.starts_with(place) ? message.substr(place.size()) : message;
    }
    return "nothing";
  }
};

}  // namespace brouwer
