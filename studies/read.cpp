#include "studies/read.hpp"

#include <fmt/format.h>

#include <brouwer/error.hpp>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <sstream>

#include "studies/reading/expectation_sections.hpp"
#include "studies/reading/reach.hpp"
#include "studies/reading/study_sections.hpp"
#include "studies/reading/tests_section.hpp"

namespace brouwer {
namespace {

constexpr std::size_t most_bytes = 1 << 18;

std::string read_text(std::filesystem::path const& file) {
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored))
    throw InputError(fmt::format("{}: is a folder, expected a study file (TOML)", file.string()));
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> const stream(std::fopen(file.c_str(), "rb"), std::fclose);
  if (!stream) throw InputError(fmt::format("{}: cannot be read ({})", file.string(), std::strerror(errno)));
  std::string text(most_bytes + 1, '\0');
  text.resize(std::fread(text.data(), 1, text.size(), stream.get()));
  if (std::ferror(stream.get()))
    throw InputError(fmt::format("{}: cannot be read ({})", file.string(), std::strerror(errno)));
  return text;
}

toml::table parse(std::string const& text, std::string const& file) {
  if (text.size() > most_bytes)
    throw InputError(fmt::format("{}: is larger than {} KiB, expected a study file (TOML)", file, most_bytes / 1024));
  return parse_toml(text, file);
}

std::string serialised(toml::table const& table) {
  std::ostringstream text;
  text << table << '\n';
  return text.str();
}

Plan plan_of(Study const& study, Catalogue const& catalogue, std::string const& file) {
  try {
    return make_plan(study, catalogue);
  } catch (InputError const& error) {
    throw InputError(fmt::format("{}: {}", file, error.what()));
  }
}

/// Sorts out what the study cannot judge.
void judge_reach(StudyFile& file, Reading& reading, Catalogue const& catalogue, Reach reach) {
  std::vector<Expectation> judged;
  for (auto const& expectation : file.expectations) {
    auto const why = out_of_reach(expectation, file.study, catalogue, file.plan.cells);
    if (!why) {
      judged.push_back(expectation);
      continue;
    }
    std::string const sentence = fmt::format("{}:{}: [[expect]] {}", reading.file, expectation.line, *why);
    if (reach == Reach::strict) reading.complaints.add(sentence);
    file.unjudged.push_back(sentence);
  }
  file.expectations = std::move(judged);
}

}  // namespace

StudyFile parse_study(std::string const& text, std::filesystem::path const& file, Catalogue const& catalogue,
                      std::vector<Override> const& overrides, Reach reach) {
  toml::table table = parse(text, file.string());
  apply(overrides, table);
  StudyFile result{file, {}, {}, {}, {}, {}, overrides.empty() ? text : serialised(table)};
  Reading reading{file.string(), overrides, {}};
  Section root(reading, &table, "");
  result.study.name = file.stem().string();
  read_study_sections(root, catalogue, result.study);
  TestsSection const tests = read_tests(root);
  result.correction = tests.correction;
  if (!result.study.system.empty())
    result.expectations = read_expectations(root, reading, catalogue, result.study.system, tests.level);
  reading.complaints.raise();
  result.plan = plan_of(result.study, catalogue, file.string());
  judge_reach(result, reading, catalogue, reach);
  reading.complaints.raise();
  return result;
}

StudyFile read_study(std::filesystem::path const& file, Catalogue const& catalogue,
                     std::vector<Override> const& overrides) {
  return parse_study(read_text(file), file, catalogue, overrides, overrides.empty() ? Reach::strict : Reach::lenient);
}

StudyFile read_stored_study(std::filesystem::path const& folder, Catalogue const& catalogue) {
  auto const file = folder / "study.toml";
  StudyFile stored = parse_study(read_text(file), file, catalogue, {}, Reach::lenient);
  auto const path =
      std::filesystem::absolute(folder / "").lexically_normal();  // ends with a slash, however it was given
  stored.study.name = path.parent_path().filename().string();
  return stored;
}

}  // namespace brouwer
