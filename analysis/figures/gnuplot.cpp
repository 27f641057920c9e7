#include "analysis/figures/gnuplot.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <fstream>

#include "analysis/escape.hpp"

extern char** environ;  // POSIX

namespace brouwer {
namespace {

/// What a process shall do between its birth and gnuplot.
class Preparation {
 public:
  Preparation(std::string const& folder, std::string const& log) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addchdir_np(&actions_, folder.c_str());
    posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&actions_, STDERR_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  }
  ~Preparation() { posix_spawn_file_actions_destroy(&actions_); }
  Preparation(Preparation const&) = delete;
  Preparation& operator=(Preparation const&) = delete;

  posix_spawn_file_actions_t const* actions() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_;
};

/// Exit status of `gnuplot --default-settings script`, or −errno where it could not be started.
int exit_status(std::string const& folder, std::string script, std::string const& log) {
  Preparation const preparation(folder, log);
  std::string program = "gnuplot", settings = "--default-settings";
  std::array<char*, 4> arguments = {program.data(), settings.data(), script.data(), nullptr};
  pid_t child = 0;
  int const failed = posix_spawnp(&child, "gnuplot", preparation.actions(), nullptr, arguments.data(), environ);
  if (failed != 0) return -failed;
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR) return -errno;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128;
}

/// gnuplot shows the line and a caret first; what it says stands in the last line that is not empty.
std::string last_line(std::filesystem::path const& file) {
  std::ifstream stream(file);
  std::string last;
  for (std::string line; std::getline(stream, line);)
    if (line.find_first_not_of(" \t") != std::string::npos) last = line;
  return one_line(last);
}

bool has_content(std::filesystem::path const& file) {
  std::error_code error;
  auto const size = std::filesystem::file_size(file, error);
  return !error && size > 0;
}

}  // namespace

std::optional<std::string> gnuplot_complaint(std::filesystem::path const& folder, std::string const& script,
                                             std::string const& figure) {
  std::string const log = script + ".log";
  int const status = exit_status(folder.string(), script, log);
  std::string const said = last_line(folder / log);
  std::error_code ignored;
  std::filesystem::remove(folder / log, ignored);
  if (status == 0 && has_content(folder / figure)) return std::nullopt;
  if (status == -ENOENT) return "gnuplot is not installed or not on PATH";
  std::filesystem::remove(folder / figure, ignored);
  return fmt::format("gnuplot failed on {}{}{}", script, said.empty() ? "" : ": ", said);
}

}  // namespace brouwer
