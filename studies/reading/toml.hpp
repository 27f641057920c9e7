#pragma once
/// toml++, compiled once (toml.cpp) instead of in every file that reads TOML.
#define TOML_HEADER_ONLY 0
#include <toml++/toml.h>
