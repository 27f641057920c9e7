#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

namespace brouwer {

// timings.csv of a result folder: what each unit cost. It lies beside the units because their files are the same bytes
// whoever computes them, and a time never is.
//
//     unit,members,seconds
//     units/cell-000/members-000000.h5,16,0.734201

struct Timing {
  std::int64_t members = 0;
  double seconds = 0;  ///< of CPU, of all members together
};

/// Notes what a unit cost. Threads and processes may do so at once: a line is one write at the end of the file.
/// @param unit     relative to the folder, as unit_path says
/// @param seconds  CPU seconds of all its members
/// @throws RunError with the system's reason
void append_timing(std::filesystem::path const& folder, std::filesystem::path const& unit, std::int64_t members,
                   double seconds);

/// By unit, as unit_path names it; of a unit that was computed again the last line counts. Empty where there is no such
/// file. What is not a line of it (half of one, from a killed process) is passed over: a time that is missing spoils
/// nothing.
std::map<std::string, Timing> read_timings(std::filesystem::path const& folder);

}  // namespace brouwer
