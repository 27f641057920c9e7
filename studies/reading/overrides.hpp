#pragma once
#include <string>
#include <vector>

#include "studies/reading/toml.hpp"

namespace brouwer {

/// A value given on the command line in place of the study file's.
struct Override {
  std::string key;     ///< dotted: ensemble.members
  std::string value;   ///< TOML; a bare word counts as a string
  std::string option;  ///< as typed, for messages: "--members 8"
};

/// From "KEY=VALUE", the argument of --set. Throws InputError where there is no key or no value.
Override parse_override(std::string const& assignment);

/// Puts the values into the study, in order; tables that are missing on the way are made. A length in steps
/// replaces one in time and the other way round. Throws InputError naming the option.
void apply(std::vector<Override> const& overrides, toml::table& study);

/// The option that gave the value at `path` (or a table that holds it), or "" if the file did.
std::string option_behind(std::string const& path, std::vector<Override> const& overrides);

/// "special-functions" and "special_functions" are one key: hyphens become underscores.
std::string folded_key(std::string key);

}  // namespace brouwer
