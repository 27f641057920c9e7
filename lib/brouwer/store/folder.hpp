#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <brouwer/store/provenance.hpp>
#include <brouwer/store/record.hpp>

namespace brouwer {

// A result folder:
//
//     study.toml         the study as it was read, with overrides applied
//     provenance.txt     with what and on what it was computed; a further block for each resumption elsewhere
//     units/cell-000/members-000000.h5 …      finished units (file.hpp); a cell's members from the number on
//     timings.csv        what each unit cost (timings.hpp)
//     plan.txt           what the units are of (FolderPlan); written last: a folder without it is not begun

/// plan.txt: `study = <hash>`, the study's canonical text (`key = value` a line), then one line a cell.
struct FolderPlan {
  std::string study_hash;
  std::string canonical_text;
  std::vector<CellLabels> cells;
};

/// Where a unit lies, relative to the result folder: units/cell-000/members-000000.h5.
std::filesystem::path unit_path(std::size_t cell, std::int64_t first_member);
std::filesystem::path cell_path(std::size_t cell);

/// Makes a result folder, or takes up the one that is there: removes what killed runs left half written, keeps
/// finished units. A crash at any moment leaves nothing or a folder that the next call takes up.
/// @throws InputError if the folder is another study's (what differs is said), is not empty and no result folder,
///         or cannot be made or written; nothing is touched then. RunError if the disk fails.
void create_result_folder(std::filesystem::path const& folder, std::string const& study_hash,
                          std::string const& canonical_text, std::string const& study_toml,
                          Provenance const& provenance, std::vector<CellLabels> const& cells);

/// Why these results are not the given study's ("step was 0.01 there and is 0.02 here"), if they are not.
/// Nothing where the folder is not there, or not begun.
std::optional<std::string> difference_to(std::filesystem::path const& folder, std::string const& study_hash,
                                         std::string const& canonical_text);

/// @throws InputError if there is no plan.txt, RunError if it is damaged
FolderPlan read_plan(std::filesystem::path const& folder);

}  // namespace brouwer
