#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/baseline/baseline_row.hpp"
#include "analysis/expectations/expectation.hpp"

namespace brouwer {

/// The estimates of one study at one time.
struct BaselineEntry {
  std::string label;  ///< "0.1.0 at 3544ae9"
  std::string date;   ///< as it was given; "" where none was
  std::string study_hash;
  std::string study;                                            ///< canonical text: one `key = value` a line
  std::vector<std::pair<std::string, std::string>> provenance;  ///< versions, compiler, flags, CPU
  std::vector<BaselineRow> rows;

  /// The same with the rows of one component in the selected cells alone. @throws InputError if there are none
  BaselineEntry only(std::string const& quantity, Selector const& where = {}) const;
};

/// The history of one study's estimates, the latest last: a file that is kept beside the code.
struct Baseline {
  std::string name;  ///< the study's
  std::vector<BaselineEntry> entries;

  /// The entry of that label; the last for "". @throws InputError with the nearest label
  BaselineEntry const& entry(std::string const& label = "") const;
};

/// As a file: JSON, one line a row, numbers that return to the same bits, null where none is defined. Equal baselines
/// give equal bytes. The members' slopes are kept of the last entry alone.
std::string to_json(Baseline const& baseline);

/// @param file  named in complaints
/// @throws InputError with the line, or the entry, row and key, where the text is no baseline
Baseline baseline_of_json(std::string const& text, std::string const& file);

/// Reads a file. @throws InputError where it is not there, or no baseline
Baseline read_baseline(std::filesystem::path const& file);

/// Adds an entry. One that has its label already must say the same bits, and is not added twice.
/// @return  whether it was new
/// @throws InputError where the label is another entry's, or where the study is another one (study_change.hpp)
bool append(Baseline& baseline, BaselineEntry entry);

}  // namespace brouwer
