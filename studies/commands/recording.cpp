#include "studies/commands/recording.hpp"

#include <fmt/format.h>

#include <array>
#include <brouwer/store/folder.hpp>
#include <brouwer/store/whole_file.hpp>
#include <cstdio>
#include <memory>
#include <set>
#include <sstream>

namespace brouwer {
namespace {

/// With what it was computed, of the last block of provenance.txt; when and on how many threads has no influence.
std::vector<std::pair<std::string, std::string>> provenance_of(std::string const& text) {
  static std::set<std::string> const without_influence = {"date", "kernel", "threads"};
  auto const last = text.rfind("\n\n");
  std::istringstream lines(last == std::string::npos ? text : text.substr(last + 2));
  std::vector<std::pair<std::string, std::string>> entries;
  for (std::string line; std::getline(lines, line);)
    if (auto const equals = line.find(" = "); equals != std::string::npos)
      if (auto const key = line.substr(0, equals); !without_influence.contains(key))
        entries.emplace_back(key, line.substr(equals + 3));
  return entries;
}

/// In single quotes, where a shell substitutes nothing.
std::string shell_word(std::string const& text) {
  std::string word = "'";
  for (char const c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

/// The first line that a command prints, or nothing.
std::string first_line_of(std::string const& command) {
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> const pipe(popen(command.c_str(), "r"), pclose);
  std::array<char, 256> line{};
  if (!pipe || !std::fgets(line.data(), static_cast<int>(line.size()), pipe.get())) return "";
  std::string const text = line.data();
  return text.substr(0, text.find('\n'));
}

}  // namespace

BaselineEntry recorded(Findings const& findings, std::filesystem::path const& folder) {
  auto const plan = read_plan(folder);
  BaselineEntry entry{"", "", plan.study_hash, plan.canonical_text, {}, {}};
  entry.provenance = provenance_of(read_whole(folder / "provenance.txt"));
  for (std::size_t row = 0; row < findings.rows().size(); ++row)
    entry.rows.push_back(baseline_row(findings.ensemble(row), findings.rows()[row]));
  return entry;
}

std::string default_label(std::filesystem::path const& place) {
  auto const folder = std::filesystem::is_directory(place) ? place : place.parent_path();
  auto const commit =
      first_line_of(fmt::format("git -C {} describe --always --dirty --abbrev=12 --exclude '*' 2>/dev/null",
                                shell_word(folder.empty() ? "." : folder.string())));
  return commit.empty() ? BROUWER_VERSION : BROUWER_VERSION " at " + commit;
}

}  // namespace brouwer
