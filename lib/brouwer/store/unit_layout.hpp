#pragma once
// What a unit file is called inside: shared by its writer and its reader.
#include <cstdint>

namespace brouwer::unit_layout {

inline constexpr char const* format = "brouwer unit";
inline constexpr std::int64_t version = 1;

inline constexpr char const* errors = "errors";  // group
inline constexpr char const* member = "member";
inline constexpr char const* step = "step";
inline constexpr char const* time = "time";
inline constexpr char const* start = "start";
inline constexpr char const* start_component = "start_component";
inline constexpr char const* final_state = "final_state";
inline constexpr char const* state_component = "state_component";
inline constexpr char const* failed_at = "failed_at";  // this and the following: only where there is something to say
inline constexpr char const* failure = "failure";
inline constexpr char const* states = "states";
inline constexpr char const* count = "count";  // attribute of a series

}  // namespace brouwer::unit_layout
