#pragma once
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include "tests/scratch.hpp"

namespace brouwer {

/// What a command said, and its exit status; the number of a signal with a minus sign.
struct Said {
  int status = -1;
  std::string text;
};

/// The built program in a folder of its own for each test.
struct ProgramTest : testing::Test {
  void write(std::string const& name, std::string const& text) const { std::ofstream(folder / name) << text; }

  /// Both streams of `brouwer ARGUMENTS`, run in the folder.
  Said brouwer(std::string const& arguments) const { return shell(std::string(BROUWER_PROGRAM) + " " + arguments); }

  Said shell(std::string const& command) const {
    std::string const line = "cd " + folder.string() + " && { " + command + "; } 2>&1";
    FILE* const pipe = popen(line.c_str(), "r");
    Said said;
    std::array<char, 4096> buffer{};
    while (std::size_t const n = fread(buffer.data(), 1, buffer.size(), pipe)) said.text.append(buffer.data(), n);
    int const status = pclose(pipe);
    said.status = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
    return said;
  }

 private:
  Scratch scratch_;

 public:
  std::filesystem::path const folder = scratch_.path();
};

}  // namespace brouwer
