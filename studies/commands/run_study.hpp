#pragma once
#include <brouwer/ensemble/run.hpp>
#include <filesystem>

#include "studies/commands/commands.hpp"
#include "studies/read.hpp"

namespace brouwer {

/// Where a study's results go: as asked for, or results/NAME, or results/NAME-xxxxxxxx where options have changed it.
std::filesystem::path result_folder(StudyFile const& file, RunSettings const& settings);

/// What a study runs and leaves out, entry by entry: {"Observes", "energy, casimir; 64 samples"}.
std::vector<std::pair<std::string, std::string>> run_entries(StudyFile const& file, Catalogue const& catalogue);

/// What is asked, run and left out, on standard output.
void print_study(StudyFile const& file, Catalogue const& catalogue, std::filesystem::path const& folder);

/// The levels that options ask for; the correction is the study's where they ask for none.
Levels levels_of(StudyFile const& file, RunSettings const& settings);

/// Steps of all members of all cells.
double member_steps(StudyFile const& file);

/// Threads and packs.
/// @throws InputError if this processor does not have the instructions that were asked for
RunOptions run_options(RunSettings const& settings);

/// Computes the units that are missing, with progress on standard error.
/// @return false if interrupted; how to resume has been said then
bool run_missing(StudyFile const& file, Catalogue const& catalogue, std::filesystem::path const& folder,
                 RunOptions options);

}  // namespace brouwer
