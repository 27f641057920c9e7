#pragma once
#include <filesystem>
#include <string>

#include "analysis/baseline/baseline.hpp"
#include "studies/commands/findings.hpp"

namespace brouwer {

/// What a baseline records of one result folder; without label and date.
BaselineEntry recorded(Findings const& findings, std::filesystem::path const& folder);

/// "0.1.0 at 3544ae9": the program's version, and the commit (with -dirty where files have changed) if `place` lies in a
/// git checkout and git is there to ask.
std::string default_label(std::filesystem::path const& place);

}  // namespace brouwer
