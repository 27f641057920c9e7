#pragma once
#include <string>

namespace brouwer {

/// What the program is, for the head of --help.
std::string help_introduction();

/// Examples and explanations below the options of a subcommand; "" is the program itself.
std::string help_footer(std::string const& subcommand);

}  // namespace brouwer
