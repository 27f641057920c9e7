// Ensembles of other programs in HDF5: every way of storing the same numbers gives the same matrix, and every complaint
// names the file, the data set, and what was expected.
#include "tests/analysis/hdf5_writer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <brouwer/error.hpp>
#include <cmath>
#include <fstream>
#include <functional>

#include "analysis/ensembles_file.hpp"
#include "analysis/factors.hpp"
#include "tests/store/sample_unit.hpp"

namespace brouwer {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<double> const by_member = {1e-17, -2e-17, 3e-17, 4e-17, 5e-17, 0};  // 3 members × 2 times
std::vector<double> const by_time = {1e-17, 3e-17, 5e-17, -2e-17, 4e-17, 0};
std::vector<double> const times = {1, 2};

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

void expect_the_ensemble(std::vector<Ensemble> const& ensembles) {
  ASSERT_EQ(ensembles.size(), 1U);
  EXPECT_THAT(ensembles[0].times, ElementsAre(1, 2));
  ErrorMatrix expected(3, 2);
  expected << 1e-17, -2e-17, 3e-17, 4e-17, 5e-17, 0;
  EXPECT_EQ(ensembles[0].errors, expected);
}

// --- what is understood ---------------------------------------------------------------------------

struct Form {
  char const* name;
  std::function<void(std::filesystem::path const&)> write;
};
void PrintTo(Form const& form, std::ostream* out) { *out << form.name; }

struct UnderstoodHdf5 : Hdf5Ensembles, testing::WithParamInterface<Form> {};
TEST_P(UnderstoodHdf5, IsTheSameEnsemble) {
  GetParam().write(file);
  expect_the_ensemble(read());
}

std::vector<double> with_zeros(std::vector<double> numbers, std::ptrdiff_t count) {
  numbers.insert(numbers.begin(), static_cast<std::size_t>(count), 0.0);
  return numbers;
}

INSTANTIATE_TEST_SUITE_P(
    Forms, UnderstoodHdf5,
    testing::Values(
        Form{"members_by_times",
             [](auto const& f) {
               Hdf5Writer(f).numbers("errors", {3, 2}, by_member).numbers("t", {2}, times);
             }},
        Form{"times_by_members",
             [](auto const& f) {
               Hdf5Writer(f).numbers("errors", {2, 3}, by_time).numbers("t", {2}, times);
             }},
        Form{"chunked_and_compressed",
             [](auto const& f) {
               Hdf5Writer(f)
                   .numbers("errors", {3, 2}, by_member, {H5T_IEEE_F64LE, {2, 1}, true})
                   .numbers("t", {2}, times);
             }},
        Form{"big_endian",
             [](auto const& f) {
               Hdf5Writer(f).numbers("errors", {3, 2}, by_member, {H5T_IEEE_F64BE}).numbers("t", {2}, times);
             }},
        Form{"times_as_integers",
             [](auto const& f) {
               Hdf5Writer(f).numbers("errors", {3, 2}, by_member).numbers("Time", {2}, times, {H5T_STD_I16LE});
             }},
        Form{"one_matrix_of_any_name",
             [](auto const& f) {
               Hdf5Writer(f).numbers("dE", {3, 2}, by_member).numbers("times", {2}, times);
             }},
        Form{"errors_told_from_other_matrices",
             [](auto const& f) {
               Hdf5Writer(f)
                   .numbers("positions", {3, 2}, by_time)
                   .numbers("energy_error", {3, 2}, by_member)
                   .numbers("t", {2}, times);
             }},
        Form{"times_in_a_group_above",
             [](auto const& f) {
               Hdf5Writer(f).group("a").group("a/b").numbers("a/b/error", {3, 2}, by_member).numbers("t", {2}, times);
             }},
        Form{"times_as_a_dimension_scale_elsewhere",
             [](auto const& f) {
               Hdf5Writer(f)
                   .group("axes")
                   .numbers("axes/time", {2}, times)
                   .numbers("error", {2, 3}, by_time)
                   .scale("error", 0, "axes/time");
             }},
        Form{"time_zero_left_out",
             [](auto const& f) {
               Hdf5Writer(f)
                   .numbers("error", {3, 3}, with_zeros(by_time, 3))
                   .numbers("t", {3}, {0, 1, 2})
                   .scale("error", 0, "t");
             }},
        Form{"behind_a_user_block",
             [](auto const& f) {
               Hdf5Writer(f, 2048).numbers("errors", {3, 2}, by_member).numbers("t", {2}, times);
             }}),
    [](auto const& one) { return one.param.name; });

TEST_F(Hdf5Ensembles, AreToldByTheirFirstBytesNotByTheirName) {
  auto const named_csv = scratch / "errors.csv";
  Hdf5Writer(named_csv).numbers("errors", {3, 2}, by_member).numbers("t", {2}, times);
  expect_the_ensemble(read_ensembles(named_csv));
  std::ofstream(file) << "time,a,b,c\n1,1e-17,3e-17,5e-17\n2,-2e-17,4e-17,0\n";
  expect_the_ensemble(read());
}

TEST_F(Hdf5Ensembles, OfFloatsAreTheNumbersThatFloatsHold) {
  Hdf5Writer(file).numbers("errors", {3, 2}, by_member, {H5T_IEEE_F32LE}).numbers("t", {2}, times);
  EXPECT_EQ(read()[0].errors(0, 0), static_cast<double>(1e-17F));
}

TEST_F(Hdf5Ensembles, ADimensionScaleTellsWhichAxisOfASquareIsTime) {
  std::vector<double> const square = {1, 2, 3, 4};
  Hdf5Writer(file).numbers("error", {2, 2}, square).numbers("t", {2}, times).scale("error", 0, "t");
  EXPECT_EQ(read()[0].errors(0, 1), 3);
  Hdf5Writer(file).numbers("error", {2, 2}, square).numbers("t", {2}, times).scale("error", 1, "t");
  EXPECT_EQ(read()[0].errors(0, 1), 2);
}

TEST_F(Hdf5Ensembles, OfSeveralGroupsAreSeveral) {
  Hdf5Writer(file)
      .numbers("steps", {2}, times)
      .group("leapfrog")
      .numbers("leapfrog/energy_error", {3, 2}, by_member)
      .group("rk4")
      .numbers("rk4/energy_error", {2, 3}, by_time)
      .text("rk4", "method", "Runge–Kutta")
      .text("rk4/energy_error", "units", "J")
      .text("/", "arithmetic", "float64");
  auto const all = read();
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].cell.method, "leapfrog");
  EXPECT_EQ(all[1].cell.method, "Runge–Kutta");
  for (auto const& ensemble : all) {
    EXPECT_EQ(ensemble.quantity, "energy_error");
    EXPECT_EQ(ensemble.time_unit, "step");
    EXPECT_EQ(ensemble.cell.arithmetic, "float64");
  }
  EXPECT_EQ(all[1].unit, "J");
  EXPECT_EQ(describe(all[0].cell), "leapfrog, float64") << "how another program sums, nobody knows";
  expect_the_ensemble(read({.dataset = "rk4"}));
  expect_the_ensemble(read({.dataset = "leapfrog/energy_error"}));
}

TEST_F(Hdf5Ensembles, TimesMayBeNamed) {
  Hdf5Writer(file).numbers("error", {3, 2}, by_member).numbers("t", {2}, {7, 9}).numbers("years", {2}, times);
  expect_the_ensemble(read({.times = "years"}));
}

TEST_F(Hdf5Ensembles, AreFoundInAUnitOfOurOwn) {
  write_unit(file, full_unit());
  auto const all = read();
  EXPECT_EQ(all.size(), 11U);  // nine integrals, y1 of three members, iterations
  EXPECT_EQ(all[0].cell.method, sample_cell().method);
  for (auto const& ensemble : all) {
    EXPECT_THAT(ensemble.times, ElementsAre(1, 10, 100, 1000));
    EXPECT_EQ(ensemble.count, ensemble.quantity == "iterations");
  }
}

// --- values instead of errors ---------------------------------------------------------------------

constexpr double energies[] = {-2, -2.5, -1.5, -4, -4, -5};  // 2 members × 3 times

TEST_F(Hdf5Ensembles, ValuesAreCountedFromTheStart) {
  Hdf5Writer(file)
      .numbers("energy", {2, 3}, {std::begin(energies), std::end(energies)})
      .numbers("t", {3}, {10, 11, 13});
  ErrorMatrix difference(2, 2), relative(2, 2);
  difference << -0.5, 0.5, 0, -1;
  relative << -0.25, 0.25, 0, -0.25;
  auto const subtracted = read({.values = FileValues::subtract_start});
  EXPECT_EQ(subtracted[0].errors, difference);
  EXPECT_THAT(subtracted[0].times, ElementsAre(1, 3));
  EXPECT_EQ(read({.values = FileValues::relative_to_start})[0].errors, relative);
}

TEST_F(Hdf5Ensembles, ValuesInTextAreCountedFromTheStart) {
  ErrorMatrix relative(2, 2);
  relative << -0.25, 0.25, 0, -0.25;
  for (auto const* text : {"t,a,b\n0,-2,-4\n1,-2.5,-4\n3,-1.5,-5\n",
                           "t,member,value\n0,1,-2\n1,1,-2.5\n3,1,-1.5\n0,2,-4\n1,2,-4\n3,2,-5\n",
                           "t,member,error\n3,1,-1.5\n3,2,-5\n0,1,-2\n1,1,-2.5\n0,2,-4\n1,2,-4\n"}) {
    std::ofstream(file) << text;
    auto const ensembles = read({.values = FileValues::relative_to_start});
    EXPECT_EQ(ensembles[0].errors, relative) << text;
    EXPECT_THAT(ensembles[0].times, ElementsAre(1, 3));
  }
}

TEST_F(Hdf5Ensembles, ValuesThatCannotBeCountedAreRefused) {
  Hdf5Writer(file).numbers("energy", {2, 3}, {0, 1, 2, 3, 4, 5}).numbers("t", {3}, {0, 1, 2});
  EXPECT_THAT(complaint({.values = FileValues::relative_to_start}), HasSubstr("the 1. member begins with the value 0"));
  Hdf5Writer(file).numbers("energy", {3, 2}, by_member).numbers("t", {2}, {0, 1});
  EXPECT_THAT(complaint({.values = FileValues::subtract_start}),
              HasSubstr("at the start and at 2 or more times after"));
  std::ofstream(file) << "t,member,value\n0,1,1\n1,1,2\n";
  EXPECT_THAT(complaint(), HasSubstr("run.h5:1: expected a column 'error', found 'value': --subtract-start"));
}

// --- what is not ----------------------------------------------------------------------------------

struct BadFile {
  char const* name;
  std::function<void(std::filesystem::path const&)> write;
  FileReading reading;
  char const* complaint;
};
void PrintTo(BadFile const& bad, std::ostream* out) { *out << bad.name; }

struct RefusedHdf5 : Hdf5Ensembles, testing::WithParamInterface<BadFile> {};
TEST_P(RefusedHdf5, InOneSentence) {
  GetParam().write(file);
  EXPECT_THAT(complaint(GetParam().reading), testing::StartsWith(GetParam().complaint));
}

auto writing(std::function<void(Hdf5Writer&)> contents) {
  return [contents](std::filesystem::path const& file) {
    Hdf5Writer writer(file);
    contents(writer);
  };
}
auto bytes(std::string text) {
  return [text](std::filesystem::path const& file) { std::ofstream(file, std::ios::binary) << text; };
}
void errors_and_t(Hdf5Writer& w) { w.numbers("error", {3, 2}, by_member).numbers("t", {2}, times); }
double const nan = std::numeric_limits<double>::quiet_NaN();

INSTANTIATE_TEST_SUITE_P(
    Complaints, RefusedHdf5,
    testing::Values(
        BadFile{"empty",
                writing([](auto&) {}),
                {},
                "run.h5: there is no matrix of numbers (members × times or times × members); the file has no data set"},
        BadFile{"no_matrix",
                writing([](auto& w) {
                  w.numbers("time", {2}, times).numbers("cube", {1, 1, 2}, times);
                }),
                {},
                "run.h5: there is no matrix of numbers (members × times or times × members); there is 'cube' (1 × 1 × "
                "2), 'time' (2)"},
        BadFile{"two_matrices",
                writing([](auto& w) {
                  w.numbers("a", {3, 2}, by_member).numbers("b", {3, 2}, by_member).numbers("t", {2}, times);
                }),
                {},
                "run.h5: which of these are the ensemble: 'a' (3 × 2), 'b' (3 × 2)? Name it with --dataset"},
        BadFile{"no_times",
                writing([](auto& w) {
                  w.numbers("error", {3, 2}, by_member).numbers("x", {2}, times);
                }),
                {},
                "run.h5: 'error' (3 × 2) has no times: expected a vector 'time', 't' or 'steps' beside it"},
        BadFile{"times_of_another_length",
                writing([](auto& w) {
                  w.numbers("error", {3, 2}, by_member).numbers("t", {4}, {1, 2, 3, 4});
                }),
                {},
                "run.h5: 'error' is 3 × 2, and 't' has 4 times: one of its axes should be that long"},
        BadFile{"square",
                writing([](auto& w) {
                  w.numbers("error", {2, 2}, {1, 2, 3, 4}).numbers("t", {2}, times);
                }),
                {},
                "run.h5: 'error' is 2 × 2, as many members as times, and nothing says which is which; attach 't' to "
                "its axis"},
        BadFile{"times_that_fall",
                writing([](auto& w) {
                  w.numbers("error", {3, 2}, by_member).numbers("t", {2}, {2, 1});
                }),
                {},
                "run.h5: 't': expected increasing times, found 1 after 2"},
        BadFile{"times_below_zero",
                writing([](auto& w) {
                  w.numbers("error", {3, 2}, by_member).numbers("t", {2}, {-1, 1});
                }),
                {},
                "run.h5: 't': expected finite times from 0 on, found -1 as number 0"},
        BadFile{"times_not_a_number",
                writing([](auto& w) {
                  w.numbers("error", {3, 2}, by_member).numbers("t", {2}, {1, nan});
                }),
                {},
                "run.h5: 't': expected finite times from 0 on, found nan as number 1"},
        BadFile{"errors_not_a_number",
                writing([](auto& w) {
                  w.numbers("error", {3, 2}, {1, 2, 3, nan, 5, 6}).numbers("t", {2}, times);
                }),
                {},
                "run.h5: 'error': expected finite numbers, found nan of member 1 (from 0) at time 2"},
        BadFile{"error_at_time_zero",
                writing([](auto& w) {
                  w.numbers("error", {2, 3}, by_member).numbers("t", {3}, {0, 1, 2});
                }),
                {},
                "run.h5: 'error': the errors at time 0 reach 4e-17, and errors are counted from 0 there: are these "
                "values? --subtract-start"},
        BadFile{"one_member",
                writing([](auto& w) {
                  w.numbers("error", {1, 2}, times).numbers("t", {2}, times);
                }),
                {},
                "run.h5: 'error': one member only"},
        BadFile{"no_member",
                writing([](auto& w) {
                  w.numbers("error", {0, 2}, {}).numbers("t", {2}, times);
                }),
                {},
                "run.h5: 'error': no member only"},
        BadFile{"one_time",
                writing([](auto& w) {
                  w.numbers("error", {3, 1}, {1, 2, 3}).numbers("t", {1}, {1});
                }),
                {},
                "run.h5: 'error': one sample time only"},
        BadFile{"misspelt_dataset",
                writing(errors_and_t),
                {.dataset = "eror"},
                "run.h5: there is no data set 'eror'; did you mean 'error'?"},
        BadFile{"misspelt_times",
                writing(errors_and_t),
                {.times = "time"},
                "run.h5: 'error': there is no data set 'time' of times; known are t"},
        BadFile{"vector_as_dataset",
                writing(errors_and_t),
                {.dataset = "t"},
                "run.h5: 't' is 2, expected a matrix of numbers"},
        BadFile{"matrix_as_times",
                writing(errors_and_t),
                {.times = "error"},
                "run.h5: 'error': 'error' (3 × 2) is no vector of numbers"},
        BadFile{"not_hdf5_behind_the_signature",
                bytes("\x89HDF\r\n\x1a\nand nothing else"),
                {},
                "run.h5: cannot be read as HDF5: "},
        BadFile{"classic_netcdf",
                bytes(std::string("CDF\x01") + "rest"),
                {},
                "run.h5: this is a netCDF file of the classic format; 'nccopy -k nc4 OLD NEW'"},
        BadFile{"numpy", bytes("\x93NUMPY and an array"), {}, "run.h5: this is a NumPy array"},
        BadFile{"zip", bytes("PK\x03\x04 and so on"), {}, "run.h5: this is a zip archive (or NumPy's npz)"},
        BadFile{"gzip", bytes("\x1f\x8b and so on"), {}, "run.h5: this is compressed with gzip"},
        BadFile{"dataset_of_a_text",
                bytes("time,a,b\n1,2,3\n2,3,4\n"),
                {.dataset = "a"},
                "run.h5: --dataset names a data set of an HDF5 file, and this is none"}),
    [](auto const& one) { return one.param.name; });

TEST_F(Hdf5Ensembles, TruncatedAnywhereAreRefusedAndNeverCrash) {
  Hdf5Writer(file).numbers("error", {3, 2}, by_member, {H5T_IEEE_F64LE, {1, 2}, true}).numbers("t", {2}, times);
  auto const size = std::filesystem::file_size(file);
  for (auto left = size - 1; left > 8; left -= 97) {
    std::filesystem::resize_file(file, left);
    EXPECT_THAT(complaint(), testing::StartsWith("run.h5: cannot be read as HDF5: ")) << left;
    if (left < 97 + 8) break;
  }
}

TEST_F(Hdf5Ensembles, AnAbsurdSizeAsksForNoMemory) {
  Hdf5Writer(file)
      .numbers("error", {1'000'000, 1'000'000}, {}, {H5T_IEEE_F64LE, {1000, 1000}})
      .numbers("t", {1'000'000}, std::vector<double>(1'000'000, 1));
  EXPECT_THAT(complaint(), HasSubstr("run.h5: "));
}

}  // namespace
}  // namespace brouwer
