#include "analysis/expectations/junit.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/escape.hpp"

namespace brouwer {
namespace {

std::string test_case(std::string const& suite, Outcome const& outcome) {
  std::string const claim = xml_text(outcome.claim), found = xml_text(outcome.found);
  std::string const body = outcome.passed ? "<system-out>" + found + "</system-out>"
                                          : "<failure message=\"" + found + "\">" + claim + ": " + found + "</failure>";
  return fmt::format("    <testcase classname=\"{}\" name=\"{}\">{}</testcase>\n", suite, claim, body);
}

}  // namespace

std::string to_junit(std::string const& suite, std::vector<Outcome> const& outcomes) {
  auto const failures = std::count_if(outcomes.begin(), outcomes.end(), [](auto const& o) { return !o.passed; });
  std::string const name = xml_text(suite),
                    counts = fmt::format("tests=\"{}\" failures=\"{}\"", outcomes.size(), failures);
  std::string cases;
  for (auto const& outcome : outcomes) cases += test_case(name, outcome);
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites {0}>\n  <testsuite name=\"{1}\" {0} errors=\"0\">\n"
      "{2}  </testsuite>\n</testsuites>\n",
      counts, name, cases);
}

}  // namespace brouwer
