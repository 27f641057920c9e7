#include <brouwer/store/timings.hpp>

#include <cerrno>
#include <charconv>
#include <cmath>
#include <fcntl.h>
#include <fmt/format.h>
#include <optional>
#include <sstream>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

#include <brouwer/error.hpp>
#include <brouwer/store/whole_file.hpp>

namespace brouwer {
namespace {

namespace fs = std::filesystem;

char const* const timings_name = "timings.csv";
char const* const heading = "unit,members,seconds\n";

/// The lock is for the heading alone; where locks do not exist there may be two of them, and reading passes over both.
int open_for_appending(fs::path const& file) {
  int const fd = ::open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (fd >= 0) ::flock(fd, LOCK_EX);
  return fd;
}

bool is_empty(int fd) {
  struct stat status = {};
  return ::fstat(fd, &status) == 0 && status.st_size == 0;
}

/// 0, or why not.
int append(int fd, std::string const& text) {
  ssize_t written = 0;
  do written = ::write(fd, text.data(), text.size());
  while (written < 0 && errno == EINTR);
  return written < 0 ? errno : static_cast<std::size_t>(written) < text.size() ? ENOSPC : 0;
}

template <class Number>
std::optional<Number> number(std::string const& text) {
  Number value = 0;
  auto const end = text.data() + text.size();
  auto const [rest, error] = std::from_chars(text.data(), end, value);
  return error == std::errc() && rest == end ? std::optional(value) : std::nullopt;
}

std::optional<Timing> timing_of(std::string const& members, std::string const& seconds) {
  auto const count = number<std::int64_t>(members);
  auto const time = number<double>(seconds);
  if (!count || !time || *count <= 0 || !std::isfinite(*time) || *time < 0) return std::nullopt;
  return Timing{*count, *time};
}

}  // namespace

void append_timing(fs::path const& folder, fs::path const& unit, std::int64_t members, double seconds) {
  auto const file = folder / timings_name;
  int const fd = open_for_appending(file);
  auto const line = fmt::format("{},{},{:.6g}\n", unit.generic_string(), members, seconds);
  int const error = fd < 0 ? errno : append(fd, is_empty(fd) ? heading + line : line);
  if (fd >= 0) ::close(fd);
  if (error != 0)
    throw RunError(fmt::format("cannot write {}: {}", file.string(), std::generic_category().message(error)));
}

std::map<std::string, Timing> read_timings(fs::path const& folder) {
  std::map<std::string, Timing> timings;
  std::error_code none;
  if (!fs::exists(folder / timings_name, none)) return timings;
  std::istringstream lines(read_whole(folder / timings_name));
  for (std::string line; std::getline(lines, line);) {
    auto const last = line.rfind(','), first = line.find(',');
    if (last == first || lines.eof()) continue;  // a line without its end may be half of one
    auto const timing = timing_of(line.substr(first + 1, last - first - 1), line.substr(last + 1));
    if (timing) timings[line.substr(0, first)] = *timing;
  }
  return timings;
}

}  // namespace brouwer
