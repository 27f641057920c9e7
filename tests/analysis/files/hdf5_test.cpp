// Ensembles of other programs in HDF5: every way of storing the same numbers gives the same matrix.
#include <brouwer/store/file.hpp>
#include <fstream>
#include <functional>

#include "analysis/factors.hpp"
#include "tests/analysis/files/hdf5_ensembles.hpp"

namespace brouwer {
namespace {

using testing::ElementsAre;

void expect_the_ensemble(std::vector<Ensemble> const& ensembles) {
  ASSERT_EQ(ensembles.size(), 1U);
  EXPECT_THAT(ensembles[0].times, ElementsAre(1, 2));
  ErrorMatrix expected(3, 2);
  expected << 1e-17, -2e-17, 3e-17, 4e-17, 5e-17, 0;
  EXPECT_EQ(ensembles[0].errors, expected);
}

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

}  // namespace
}  // namespace brouwer
