#pragma once
#include <brouwer/ensemble/catalogue.hpp>
#include <brouwer/ensemble/plan.hpp>
#include <brouwer/ensemble/study.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "analysis/expectations/expectation.hpp"
#include "studies/reading/overrides.hpp"

namespace brouwer {

/// What to do with an expectation that the study cannot judge because it does not run those levels: in a file as
/// its author wrote it, a mistake; where options have changed the study, it is left out and reported.
enum class Reach { strict, lenient };

/// A study file, read and checked: nothing in it can be refused later for what it says.
struct StudyFile {
  std::filesystem::path path;
  Study study;
  Plan plan;
  std::vector<Expectation> expectations;
  std::optional<Correction> correction;  ///< of all tests of the expectations at once
  std::vector<std::string> unjudged;     ///< expectations left out, a sentence each, why the study cannot judge them
  std::string text;                      ///< TOML: as it was read, or serialised with the overrides applied
};

/// Reads a study file; lenient where there are overrides.
/// @throws InputError one sentence a line (at most ten), each with file and line, or the option, key and value
StudyFile read_study(std::filesystem::path const& file, Catalogue const& catalogue,
                     std::vector<Override> const& overrides = {});

/// The same from a text; `file` is used in messages, its stem names the study.
StudyFile parse_study(std::string const& text, std::filesystem::path const& file, Catalogue const& catalogue,
                      std::vector<Override> const& overrides = {}, Reach reach = Reach::strict);

/// The study that a result folder holds, named after the folder; lenient.
StudyFile read_stored_study(std::filesystem::path const& folder, Catalogue const& catalogue);

}  // namespace brouwer
