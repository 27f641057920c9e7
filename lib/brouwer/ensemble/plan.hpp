#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <brouwer/ensemble/catalogue.hpp>
#include <brouwer/ensemble/study.hpp>
#include <brouwer/store/record.hpp>

namespace brouwer {

/// A block of consecutive members of one cell: computed by one thread, stored in one file.
struct Unit {
  std::size_t cell = 0;
  std::int64_t first_member = 0;
  std::int64_t members = 0;
  std::filesystem::path file;  ///< relative to the result folder: units/cell-000/members-000000.h5
};

/// A combination of levels that does not exist and is not run, with the reason.
struct Skipped {
  CellLabels cell;
  std::string reason;  ///< "elliptic-naive computes new values, not increments: compensation does not apply"
};

struct Plan {
  std::vector<CellLabels> cells;
  std::vector<Unit> units;
  std::vector<Skipped> skipped;
  /// With what each cell's states are compared: "none", "exact", or the arithmetic in which the same method runs, which
  /// check_references may have replaced by a wider one.
  std::vector<std::string> references;
  std::vector<std::string> warnings;  ///< sentences that people should read before they believe the numbers
};

/// Crosses the factors of a study, merges cells that a factor does not touch, cuts them into units.
/// Checks every name and value; throws InputError (one sentence) where something is impossible.
Plan make_plan(Study const& study, Catalogue const& catalogue);

/// How many members of a unit have a reference.
std::int64_t compared_members(Study const& study, Unit const& unit);

/// Step numbers at which a cell of `steps` steps is observed: strictly increasing, the last is `steps`.
std::vector<std::int64_t> sample_steps(Samples const& samples, std::int64_t steps);

}  // namespace brouwer
