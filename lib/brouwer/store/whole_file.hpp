#pragma once
#include <filesystem>
#include <string>
#include <string_view>

namespace brouwer {

/// Puts `bytes` into `file` so that, whatever happens, the file is there whole or as it was before: written under
/// a temporary name in the same folder, fsync, rename, fsync of the folder.
/// @throws RunError with the system's reason (no space, no permission, no such folder); the temporary is gone then.
void write_whole(std::filesystem::path const& file, std::string_view bytes);

/// Makes new names in `folder` themselves survive a power failure. @throws RunError
void sync_folder(std::filesystem::path const& folder);

/// Removes the temporaries that killed processes left in `folder` and below. Those that a living process is
/// still writing are locked, and stay. A folder that is not there is no error.
void remove_leftovers(std::filesystem::path const& folder);

/// Is this the name of such a temporary?
bool is_leftover(std::filesystem::path const& file);

/// The whole of `file`. @throws RunError with the system's reason.
std::string read_whole(std::filesystem::path const& file);

}  // namespace brouwer
