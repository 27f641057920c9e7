#pragma once
#include <atomic>
#include <cstdint>
#include <filesystem>
#include <string>

#include <brouwer/ensemble/plan.hpp>

namespace brouwer {

/// How far a run is; filled by the workers, read by whoever shows progress.
struct Progress {
  std::int64_t units_total = 0, units_before = 0;  ///< before: finished by an earlier run
  std::int64_t steps_total = 0;                    ///< member-steps still to do when the run began
  std::vector<std::string> notices;                ///< sentences that people should see; complete before the first unit
  std::atomic<std::int64_t> units_done = 0;
  std::atomic<std::int64_t> steps_done = 0;
};

struct RunOptions {
  int threads = 0;                                   ///< 0: all that this process may use
  std::atomic<bool> const* stop = nullptr;           ///< set by a signal handler: workers leave, finished units stay
  InstructionSet widest = widest_instruction_set();  ///< of packs; no influence on the numbers
};

/// How many threads a run with these options uses.
int threads_of(RunOptions const& options);

/// One unit, computed here and now: depends on (study, unit) alone.
/// With `stop` set midway the record is empty and `finished` false.
struct UnitOutcome {
  bool finished = false;
  UnitRecord record;
  double seconds = 0;  ///< processor time of its members' steps: no part of the record, which is the same each time
};
UnitOutcome compute_unit(Study const& study, Catalogue const& catalogue, Plan const& plan, Unit const& unit,
                         std::string const& hash, Progress& progress, std::atomic<bool> const* stop,
                         InstructionSet widest = widest_instruction_set());

/// Makes the folder (study.toml, plan.txt, provenance.txt, units/) or takes up an existing one, and computes the
/// units that are missing, over threads. Throws InputError if the folder holds another study's results (what
/// differs is said), RunError if a unit cannot be stored.
/// @param study_text  the study file as read with overrides applied; stored as study.toml
/// @return true if everything planned is now there, false if stopped
bool run(Study const& study, std::string const& study_text, Catalogue const& catalogue, Plan const& plan,
         std::filesystem::path const& folder, RunOptions const& options, Progress& progress);

}  // namespace brouwer
