// calibrate FILE          simulates, and writes the tables into FILE (docs/statistics.md; the target `calibration`);
//                         exit status 1 if a rate that is promised is out of its bounds
// calibrate --speed FILE  measures what the inference takes, and writes that table
#include <fmt/format.h>

#include <brouwer/error.hpp>
#include <cstdio>

#include "tests/calibration/document.hpp"
#include "tests/calibration/speed.hpp"
#include "tests/calibration/tables.hpp"

namespace brouwer::calibration {
namespace {

/// Every model in every design; at the strict level, the walk.
std::vector<Tally> all_tallies() {
  std::vector<Tally> tallies;
  for (auto const& design : designs()) {
    fmt::print(stderr, "{}\n", design.name());
    for (auto const& law : models())
      if (!design.strict || &law == &model("walk")) tallies.push_back(tally(law, design));
  }
  return tallies;
}

std::string page(std::vector<Tally> const& tallies) {
  return fmt::format(
      "### What is promised, and whether it holds\n\n{}\n### Models\n\n{}\n### Every rate, in %\n\n{}### Verdicts, in "
      "%\n\n{}",
      summary_table(tallies), model_list(), claim_tables(tallies), verdict_tables(tallies));
}

int calibrate(std::string const& file) {
  auto const tallies = all_tallies();
  replace_part(file, "calibration", page(tallies));
  auto const broken = broken_promises(tallies);
  for (auto const& sentence : broken) fmt::print(stderr, "{}\n", sentence);
  return broken.empty() ? 0 : 1;
}

int write_speed(std::string const& file) {
  replace_part(file, "speed", speed_table());
  return 0;
}

int run(std::vector<std::string> const& arguments) {
  if (arguments.size() == 1) return calibrate(arguments[0]);
  if (arguments.size() == 2 && arguments[0] == "--speed") return write_speed(arguments[1]);
  throw InputError("expected is the file that has the tables, with or without --speed before it");
}

}  // namespace
}  // namespace brouwer::calibration

int main(int argc, char** argv) {
  try {
    return brouwer::calibration::run({argv + 1, argv + argc});
  } catch (std::exception const& error) {
    fmt::print(stderr, "calibrate: {}\n", error.what());
    return dynamic_cast<brouwer::InputError const*>(&error) ? 2 : 3;
  }
}
