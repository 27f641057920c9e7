#pragma once
#include <string>
#include <vector>

#include "analysis/expectations/expectation.hpp"

namespace brouwer {

/// JUnit XML of one suite, as continuous-integration systems read it: one test case an outcome, named by its claim;
/// what was found is the message of a failure, and the output of a passed case.
std::string to_junit(std::string const& suite, std::vector<Outcome> const& outcomes);

}  // namespace brouwer
