#pragma once
#include <filesystem>
#include <span>
#include <string>

#include <brouwer/store/record.hpp>

namespace brouwer {

/// Writes a unit as one HDF5 file that is there whole or not at all: built in memory (H5FD_CORE),
/// written under a temporary name in the same folder, fsync, rename, fsync of the folder.
/// The same record gives the same bytes.
///
/// Attributes of the file: study_hash, the cell's labels, first_member, format, format_version. Data sets:
///
///     member (members)  step (samples)  time (samples)  start_component  state_component     what the axes mean
///     errors/<series>   (members × samples)             attributes quantity, units, long_name, crc32; count where
///                                                       it is a number of something and no error
///     start             (members × start components)
///     final_state       (members × state components)
///     failed_at, failure (members)                      only where it was recorded which members failed
///     states            (members × samples × state components)   only where the study asked for it
///
/// Axes are dimension scales (H5DS), so that h5py, xarray and ncdump know them. A series that only the unit's
/// first n members have lies along `member_<n>`.
/// @throws RunError with one sentence (folder unwritable, disk full); std::logic_error if the record's arrays do not
///         fit together.
void write_unit(std::filesystem::path const& file, UnitRecord const& record);

/// Reads a unit back. Throws RunError naming the file where it is damaged, truncated or not a unit: HDF5 guards the
/// structure with checksums of its own, `crc32` the numbers.
UnitRecord read_unit(std::filesystem::path const& file);

/// Reads everything but the numbers (errors, states, start and final state stay empty), who failed and why: cheap.
UnitRecord read_unit_header(std::filesystem::path const& file);

/// Reads the header, the starts and the final states: all but errors and states at the samples.
UnitRecord read_unit_ends(std::filesystem::path const& file);

/// Reads the states at the samples alone, [member][sample][state_names]; empty where the unit has none.
std::vector<double> read_states(std::filesystem::path const& file);

/// Reads one series, [member][sample], straight into `errors`, which must have its size.
void read_series(std::filesystem::path const& file, std::string const& name, std::span<double> errors);

}  // namespace brouwer
