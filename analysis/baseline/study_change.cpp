#include "analysis/baseline/study_change.hpp"

#include <fmt/format.h>

#include <array>
#include <brouwer/error.hpp>
#include <brouwer/store/plan_text.hpp>
#include <sstream>

namespace brouwer {
namespace {

enum class Role {
  question,  ///< decides what is estimated
  sample,    ///< decides who is in the sample
  cells,     ///< decides which cells there are
};

Role role_of(std::string const& key) {
  if (key.starts_with("system") || key.starts_with("perturb.") || key == "samples" || key == "reference" ||
      key == "format")
    return Role::question;
  return key == "members" || key == "seed" ? Role::sample : Role::cells;
}

/// "float128, 16 members" compares with float128; how many are compared is a matter of the sample.
std::string without_members(std::string const& reference) { return reference.substr(0, reference.find(',')); }

/// Those lines of a canonical text that have one of these roles.
template <class Wanted>
std::string lines_of(std::string const& text, Wanted wanted) {
  std::istringstream lines(text);
  std::string chosen;
  for (std::string line; std::getline(lines, line);) {
    auto const key = line.substr(0, line.find(" = "));
    if (wanted(role_of(key))) chosen += (key == "reference" ? without_members(line) : line) + '\n';
  }
  return chosen;
}

std::string question_of(std::string const& text) {
  return lines_of(text, [](Role role) { return role == Role::question; });
}

}  // namespace

void require_same_question(std::string const& there, std::string const& here) {
  auto const before = question_of(there), now = question_of(here);
  if (before != now)
    throw InputError(fmt::format("the baseline was recorded of another study: {}", differences(before, now)));
}

std::string harmless_changes(std::string const& there, std::string const& here) {
  auto const others = [](Role role) { return role != Role::question; };
  auto const before = lines_of(there, others), now = lines_of(here, others);
  return before == now ? "" : differences(before, now);
}

bool same_members(std::string const& there, std::string const& here) {
  auto const people = [](Role role) { return role != Role::cells; };
  return lines_of(there, people) == lines_of(here, people);
}

}  // namespace brouwer
