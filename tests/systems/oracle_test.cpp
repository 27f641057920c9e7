// The exact flow against an oracle that shares nothing with it: Taylor series in decimal arithmetic, data/euler_taylor.py.
#include <brouwer/systems/rigid_body_flow.hpp>

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "tests/numbers.hpp"

namespace brouwer {
namespace {

using testing_support::Judge;

struct Row {
  std::size_t body;
  Judge time;
  std::vector<Judge> state;
};

std::vector<Row> oracle() {
  std::ifstream in(BROUWER_SOURCE "/data/rigid_body_flow.csv");
  std::vector<Row> rows;
  std::string line, cell;
  std::getline(in, line);
  while (std::getline(in, line)) {
    std::istringstream cells(line);
    Row row;
    std::getline(cells, cell, ',');
    row.body = std::stoul(cell);
    std::getline(cells, cell, ',');
    row.time = Judge(cell);
    while (std::getline(cells, cell, ',')) row.state.emplace_back(cell);
    rows.push_back(row);
  }
  return rows;
}

/// The bodies of data/euler_taylor.py: exact decimals.
struct OracleBody {
  std::array<char const*, 3> inertia, momentum;
  std::array<char const*, 4> attitude;
};
constexpr OracleBody bodies[] = {{{"0.6", "0.8", "1.0"}, {"1.8", "0.4", "-0.9"}, {"1", "0", "0", "0"}},
                                 {{"0.6", "0.8", "1.0"}, {"0.4", "0.3", "-1.7"}, {"0.5", "-0.5", "0.5", "0.5"}},
                                 {{"0.9", "1.1", "1.7"}, {"-0.6", "0.8", "1.9"}, {"0.1", "0.7", "-0.7", "0.1"}}};

TEST(ExactFlow, AgreesWithTaylorSeriesTo50DigitsInMomentumAndAttitude) {
  auto const rows = oracle();
  ASSERT_EQ(rows.size(), 30U);
  for (auto const& row : rows) {
    auto const& b = bodies[row.body];
    RigidBody<Judge> const body(Vector3<Judge>{Judge(b.inertia[0]), Judge(b.inertia[1]), Judge(b.inertia[2])});
    RigidBodyState<Judge> const start{
        {Judge(b.momentum[0]), Judge(b.momentum[1]), Judge(b.momentum[2])},
        {Judge(b.attitude[0]), Judge(b.attitude[1]), Judge(b.attitude[2]), Judge(b.attitude[3])}};
    auto const reached = RigidBodyFlow<Judge>(body, start)(row.time);
    auto expected = row.state.begin();
    for_components(
        [&](Judge const& component) {
          EXPECT_LT(abs(Judge(component - *expected++)), Judge("1e-50")) << "body " << row.body << ", t = " << row.time;
        },
        reached);
  }
}

}  // namespace
}  // namespace brouwer
