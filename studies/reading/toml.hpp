#pragma once
/// toml++, compiled once (toml.cpp) instead of in every file that reads TOML.
#define TOML_HEADER_ONLY 0
#define TOML_FLOAT_CHARCONV 1  // the shortest digits that return to the same double: 0.4, not 0.40000000000000002
#include <toml++/toml.h>

#include <string>

namespace brouwer {

/// Parses a text; `file` is for messages and may be empty. Use this instead of toml::parse, which some malformed
/// texts lead into undefined behaviour (see toml.cpp).
/// @throws InputError "file:line:column: what is wrong", without the place where `file` is empty
toml::table parse_toml(std::string const& text, std::string const& file);

}  // namespace brouwer
