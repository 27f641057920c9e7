#pragma once
/// toml++, compiled once (toml.cpp) instead of in every file that reads TOML.
#define TOML_HEADER_ONLY 0
#define TOML_FLOAT_CHARCONV 1  // the shortest digits that return to the same double: 0.4, not 0.40000000000000002
#include <toml++/toml.h>
