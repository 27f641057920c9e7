// Other programs' files that hold values instead of errors, in HDF5 and in text: counted from the start.
#include <fstream>

#include "tests/analysis/files/hdf5_ensembles.hpp"

namespace brouwer {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

struct ValuesInFiles : Hdf5Ensembles {};

constexpr double energies[] = {-2, -2.5, -1.5, -4, -4, -5};  // 2 members × 3 times

TEST_F(ValuesInFiles, ValuesAreCountedFromTheStart) {
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

TEST_F(ValuesInFiles, ValuesInTextAreCountedFromTheStart) {
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

TEST_F(ValuesInFiles, ValuesThatCannotBeCountedAreRefused) {
  Hdf5Writer(file).numbers("energy", {2, 3}, {0, 1, 2, 3, 4, 5}).numbers("t", {3}, {0, 1, 2});
  EXPECT_THAT(complaint({.values = FileValues::relative_to_start}), HasSubstr("the 1. member begins with the value 0"));
  Hdf5Writer(file).numbers("energy", {3, 2}, by_member).numbers("t", {2}, {0, 1});
  EXPECT_THAT(complaint({.values = FileValues::subtract_start}),
              HasSubstr("at the start and at 2 or more times after"));
  std::ofstream(file) << "t,member,value\n0,1,1\n1,1,2\n";
  EXPECT_THAT(complaint(), HasSubstr("run.h5:1: expected a column 'error', found 'value': --subtract-start"));
}

}  // namespace
}  // namespace brouwer
