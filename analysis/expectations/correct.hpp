#pragma once
#include <span>
#include <vector>

#include "analysis/expectations/expectation.hpp"

namespace brouwer {

/// Corrects the tests of drift of all these estimates together (of one study, or of what is tabulated at once): p becomes
/// the adjusted one, p_alone keeps the other, and verdicts and sentences follow. Nothing for Correction::none.
void correct(std::span<Estimates> rows, Correction correction);

/// Corrects the tests of all these outcomes together and judges them again, by the adjusted p.
void correct(std::vector<Outcome>& outcomes, Correction correction);

}  // namespace brouwer
