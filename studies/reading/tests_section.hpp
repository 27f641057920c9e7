#pragma once
#include <optional>
#include <string>

#include "analysis/multiplicity.hpp"
#include "studies/reading/section.hpp"

namespace brouwer {

/// [tests]: how a study's expectations are judged. It changes nothing that is run.
struct TestsSection {
  std::optional<double> level;           ///< of expectations that do not say their own
  std::optional<Correction> correction;  ///< of all tests at once
};

TestsSection read_tests(Section& root);

/// The correction that the text of a study asks for, whatever else it says.
std::optional<Correction> correction_in(std::string const& study_text);

}  // namespace brouwer
