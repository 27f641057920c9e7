// HDF5 files that hold no ensemble: every complaint names the file, the data set, and what was expected.
#include <fstream>
#include <functional>

#include "tests/analysis/files/hdf5_ensembles.hpp"

namespace brouwer {
namespace {

using testing::HasSubstr;

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
