#include "analysis/verdict/failures.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace brouwer {
namespace {

/// A reason is a clause ("the iteration did not converge") or one noun ("collision").
std::string because(std::string const& reason) {
  if (reason.empty()) return "because an error is not finite";
  if (reason.find(' ') != std::string::npos) return "because " + reason;
  bool const vowel = std::string("aeiou").find(reason[0]) != std::string::npos;
  return fmt::format("because of {} {}", vowel ? "an" : "a", reason);
}

std::string when(Failures const& failures) {
  if (failures.first_step < 0) return "";
  return fmt::format(" ({}at step {})", failures.members > 1 ? "the first " : "", failures.first_step);
}

}  // namespace

std::string reasons(Estimates const& e) {
  bool const recorded =
      std::any_of(e.failures.begin(), e.failures.end(), [](auto const& failures) { return !failures.reason.empty(); });
  if (!recorded) return "";
  std::vector<std::string> words;
  for (auto const& failures : e.failures)
    words.push_back(fmt::format("{} {}{}", failures.members, because(failures.reason), when(failures)));
  return fmt::format("{}", fmt::join(words, ", "));
}

std::string and_why(Estimates const& e) {
  auto const all = reasons(e);
  if (all.empty()) return "";
  auto const& first = e.failures.front();
  return e.failures.size() > 1 ? ": " + all : " " + because(first.reason) + when(first);
}

std::string left_out(Estimates const& e, std::string const& unrecorded) {
  if (e.failed == 0) return "";
  auto const why = and_why(e);
  return fmt::format("{} of {} members{}", e.failed, members_run(e),
                     why.empty() ? unrecorded : (e.failed == 1 ? " is left out" : " are left out") + why);
}

std::int64_t members_run(Estimates const& e) {
  return e.members + e.failed + (e.far_off.set_aside ? std::ssize(e.far_off.members) : 0);
}

std::string members_in_words(Estimates const& e) {
  if (e.members == members_run(e)) return fmt::format("{} members", e.members);
  return fmt::format("{} of {} members", e.members, members_run(e));
}

bool same_members(Estimates const& a, Estimates const& b) {
  return a.members == b.members && members_run(a) == members_run(b);
}

std::string unfinished_in_words(std::int64_t finished, std::int64_t planned, std::size_t cells) {
  auto const all = static_cast<std::int64_t>(cells) * planned;
  if (finished >= all) return "";
  return fmt::format("unfinished: {} of {} members in {} {}", finished, all, cells, cells == 1 ? "cell" : "cells");
}

}  // namespace brouwer
