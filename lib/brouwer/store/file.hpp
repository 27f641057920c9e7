#pragma once
#include <filesystem>

#include <brouwer/store/record.hpp>

namespace brouwer {

/// Writes a unit as one HDF5 file that is there whole or not at all: built in memory (H5FD_CORE),
/// written under a temporary name in the same folder, fsync, rename, fsync of the folder.
/// The same record gives the same bytes. Throws RunError with one sentence (folder unwritable, disk full).
void write_unit(std::filesystem::path const& file, UnitRecord const& record);

/// Reads a unit back. Throws RunError naming the file where it is damaged, truncated or not a unit.
UnitRecord read_unit(std::filesystem::path const& file);

/// Reads everything but the numbers (errors, start and final state stay empty): cheap.
UnitRecord read_unit_header(std::filesystem::path const& file);

}  // namespace brouwer
