#include "studies/program.hpp"

#include <fmt/format.h>

#include <brouwer/error.hpp>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <new>
#include <system_error>

#include "studies/commands/command_line.hpp"

namespace brouwer {
namespace {

/// One line a sentence, each with the program's name.
void say(std::string const& sentences) {
  std::size_t begin = 0;
  while (begin <= sentences.size()) {
    std::size_t const end = std::min(sentences.find('\n', begin), sentences.size());
    fmt::print(stderr, "brouwer: {}\n", sentences.substr(begin, end - begin));
    begin = end + 1;
  }
}

int failed(ExitStatus status, std::string const& sentences) {
  std::fflush(stdout);
  say(sentences);
  return status;
}

int parse_and_carry_out(int argc, char const* const* argv, Catalogue const& catalogue) {
  CommandLine command_line;
  try {
    command_line.parse(argc, argv);
  } catch (CLI::Success const& asked) {  // --help or --version: CLI11 prints it
    command_line.app().exit(asked);
    return done;
  }
  return command_line.carry_out(catalogue);
}

int guarded(int argc, char const* const* argv, Catalogue const& catalogue) {
  try {
    return parse_and_carry_out(argc, argv, catalogue);
  } catch (InputError const& error) {
    return failed(wrong_input, error.what());
  } catch (RunError const& error) {
    return failed(run_failed, error.what());
  } catch (std::bad_alloc const&) {
    return failed(run_failed, "there is not enough memory");
  } catch (std::system_error const& error) {
    return error.code().value() == EPIPE ? done : failed(run_failed, error.what());  // | head has read enough
  } catch (std::exception const& error) {
    return failed(run_failed, error.what());
  }
}

/// What is still in the buffer may not fit on a full disk.
int flushed(int status) {
  if (std::fflush(stdout) == 0 || errno == EPIPE || status != done) return status;
  return failed(run_failed, fmt::format("standard output cannot be written ({})", std::strerror(errno)));
}

}  // namespace

int program(int argc, char const* const* argv, Catalogue const& catalogue) {
  std::signal(SIGPIPE, SIG_IGN);  // a closed pipe is then an error of writing, and ends quietly
  return flushed(guarded(argc, argv, catalogue));
}

}  // namespace brouwer
