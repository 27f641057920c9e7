#define TOML_IMPLEMENTATION
#include "studies/reading/toml.hpp"
