#include "studies/reading/tests_section.hpp"

#include "studies/reading/toml.hpp"

namespace brouwer {

TestsSection read_tests(Section& root) {
  Section tests = root.section("tests");
  TestsSection found;
  found.level = tests.value("level", above_up_to(0, 0.5));
  if (auto const name = tests.value("correction", one_of("correction", correction_names())))
    found.correction = correction_of(*name);
  tests.refuse_unknown_keys();
  return found;
}

std::optional<Correction> correction_in(std::string const& study_text) {
  toml::table const table = parse_toml(study_text, "study.toml");
  Reading reading{"study.toml", {}, {}};
  Section root(reading, &table, "");
  return read_tests(root).correction;
}

}  // namespace brouwer
