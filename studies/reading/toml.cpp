#include <fmt/format.h>

#include <algorithm>
#include <brouwer/error.hpp>
#include <stdexcept>

// toml++ 3.3 takes some promises for granted that malformed texts break ([.a], [#]): with assertions it aborts, with
// NDEBUG it tells the compiler that the case cannot happen. Here it throws.
namespace {
struct BrokenPromise : std::logic_error {
  using std::logic_error::logic_error;
};
constexpr void hold_to(bool kept, char const* promise) {
  if (!kept) throw BrokenPromise(promise);
}
}  // namespace
#undef NDEBUG
#define TOML_ASSERT(promise) hold_to(static_cast<bool>(promise), #promise)
#define TOML_IMPLEMENTATION
#include "studies/reading/toml.hpp"

namespace brouwer {
namespace {

/// Dotted keys nest as deep as they are long, and what nests is destroyed recursively: this many stay within any stack.
constexpr std::ptrdiff_t most_dots = 4096;

std::string place(std::string const& file, toml::source_position const& at) {
  return file.empty() ? "" : fmt::format("{}:{}:{}: ", file, at.line, at.column);
}

}  // namespace

toml::table parse_toml(std::string const& text, std::string const& file) {
  std::string const prefix = file.empty() ? "" : file + ": ";
  if (std::count(text.begin(), text.end(), '.') > most_dots)
    throw InputError(fmt::format("{}has more than {} dots, too many for a study file", prefix, most_dots));
  try {
    return toml::parse(text, file);
  } catch (toml::parse_error const& error) {
    throw InputError(fmt::format("{}{}", place(file, error.source().begin), error.description()));
  } catch (BrokenPromise const&) {
    throw InputError(fmt::format("{}does not parse as TOML: a table has no name, as in [.a] or [#]", prefix));
  }
}

}  // namespace brouwer
