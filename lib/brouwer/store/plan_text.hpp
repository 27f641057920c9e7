#pragma once
#include <string>

#include <brouwer/store/folder.hpp>

namespace brouwer {

/// plan.txt's text, and back: numbers are written so that they return to the same bits.
std::string to_text(FolderPlan const& plan);
/// @throws std::invalid_argument naming the line that is not understood
FolderPlan plan_of_text(std::string const& text);

/// How two canonical texts differ, for people: "step was 0.01 there and is 0.02 here; …".
std::string differences(std::string const& there, std::string const& here);

}  // namespace brouwer
