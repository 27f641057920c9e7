#pragma once
#include <brouwer/store/results.hpp>
#include <filesystem>
#include <vector>

#include "analysis/files/from_start.hpp"

namespace brouwer {

/// Ensembles that another program wrote, as text. Two forms, told apart by the first line:
///
///     long   a header with `time`, `member`, `error`, then one error a line. Every member needs an error at every
///     time.
///            Columns `quantity`, `system`, `method`, `arithmetic` label separate ensembles; other columns are ignored.
///     wide   one time a line: first column `time`, then one column a member; the header may be missing.
///
/// Lines may come in any order; members are sorted by number (by name where one is no number), times by value, so that
/// the order does not change a bit of what follows. `t` stands for time, `step` or `steps` for a time counted in steps.
/// Fields are separated by commas, semicolons, tabs or blanks; # begins a comment line; double quotes, CRLF and a byte
/// order mark are understood. A time 0, where every error must be 0, is left out: errors count from there.
/// Where the numbers are values and no errors (FileValues), the column `error` may be called `value`.
/// Units: errors and times in whatever unit the file has; Ensemble::time_unit is "time unit", or "step".
/// Streams: memory is 24 bytes an error (long form) beside the matrix; 2·10⁷ lines are read in about 4 s.
/// @throws InputError with file and line for what cannot be read: text where a number belongs, NaN, infinities,
/// negative
///         times, holes, duplicates, missing columns, a single member or time, no data, binary data.
std::vector<Ensemble> read_csv(std::filesystem::path const& file, FileValues values = FileValues::errors);

}  // namespace brouwer
