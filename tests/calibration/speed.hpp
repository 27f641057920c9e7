#pragma once
#include <string>

namespace brouwer::calibration {

/// What the inference takes for ten quantities of 10⁵ members at 200 sample times each, all that `estimate` says included:
/// Markdown, a line a quantity. The ensembles are simulated one at a time, outside of what is measured.
std::string speed_table();

}  // namespace brouwer::calibration
