#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <brouwer/store/orbits.hpp>
#include <brouwer/store/record.hpp>

namespace brouwer {

using ErrorMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// One scalar quantity of one cell, all members: what the statistics see.
struct Ensemble {
  CellLabels cell;
  std::string quantity;  ///< component name, e.g. "energy", "spatial-momentum-1"
  std::string family;    ///< the quantity it belongs to, e.g. "spatial-momentum"
  std::string unit;
  std::vector<double> times;  ///< increasing, > 0; in steps
  ErrorMatrix errors;         ///< members × times; every entry finite
  std::int64_t failed = 0;    ///< members left out because they failed: no next state, or an error that is not finite
  std::string time_unit = "step";       ///< of `times`; "time unit" for ensembles of other programs
  std::vector<Failures> failures = {};  ///< of the members left out, by reason, those of most members first
  std::vector<std::string> names = {};  ///< of the members in the rows; where empty, row i is member i
  bool count = false;                   ///< `errors` are numbers of something (iterations per step): no law of growth
};

/// A unit's file and what stands in it beside the numbers.
struct FinishedUnit {
  std::filesystem::path file;
  UnitRecord header;
};

/// A result folder that `run` wrote (see folder.hpp for its layout): finished units, read on demand, one
/// quantity of one cell at a time, so that memory holds only what is analysed.
class Results {
 public:
  /// Reads the plan and every unit's header.
  /// @throws InputError if the folder does not exist or is no result folder, RunError if a unit is damaged, is of
  ///         another study, or has members that another unit has
  explicit Results(std::filesystem::path folder);

  std::filesystem::path const& folder() const { return folder_; }
  std::string const& study_hash() const { return study_hash_; }

  /// The study file as it was read (with overrides applied), TOML.
  std::string study_text() const;

  std::size_t cells() const { return cells_.size(); }
  CellLabels const& labels(std::size_t cell) const { return cells_[cell].labels; }
  /// Component names in the order stored; only those that at least one member has.
  std::vector<std::string> const& quantities(std::size_t cell) const { return cells_[cell].quantities; }
  /// How many of the planned members are finished.
  std::int64_t finished_members(std::size_t cell) const { return cells_[cell].members; }

  /// How many members each cell is to have.
  std::int64_t planned_members() const { return planned_members_; }
  /// CPU seconds that a member of the cell took, over those units of which timings.csv knows it; NaN where of none.
  double seconds_per_member(std::size_t cell) const;

  /// All finished members of cell `number` that have this component. @throws InputError if there is none of that name.
  Ensemble load(std::size_t number, std::string const& quantity) const;

  /// The cell's finished units with starts and final states, without errors and states at the samples.
  std::vector<UnitRecord> ends(std::size_t cell) const;

  /// Where the cell's members were; no members where the study did not ask for states.
  Orbits orbits(std::size_t cell) const { return orbits_of(cells_.at(cell).units); }

 private:
  struct Cell {
    CellLabels labels;
    std::vector<std::string> quantities;
    std::vector<FinishedUnit> units;  // by first member
    std::int64_t members = 0;
  };
  std::filesystem::path folder_;
  std::string study_hash_;
  std::int64_t planned_members_ = 0;
  std::vector<Cell> cells_;  // in the order of the plan
};

}  // namespace brouwer
