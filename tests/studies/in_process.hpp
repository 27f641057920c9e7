#pragma once
#include <gtest/gtest.h>
#include <stdlib.h>  // mkdtemp

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "studies/program.hpp"

namespace brouwer {

/// A folder with a study, and the command line on it, in this process: with any catalogue.
class InProcess : public testing::Test {
 protected:
  InProcess(char const* study_text, Catalogue const& catalogue) : catalogue_(catalogue) {
    std::string name = (std::filesystem::temp_directory_path() / "brouwer-test-XXXXXX").string();
    folder = mkdtemp(name.data());
    std::ofstream(study()) << study_text;
  }
  ~InProcess() override { std::filesystem::remove_all(folder); }

  std::string study() const { return (folder / "toy.toml").string(); }
  std::string results() const { return (folder / "results").string(); }

  struct Said {
    int status;
    std::string out, err;
  };
  /// What `brouwer ARGUMENTS` says.
  Said brouwer(std::vector<std::string> const& arguments) const {
    std::vector<char const*> words = {"brouwer"};
    for (auto const& argument : arguments) words.push_back(argument.c_str());
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    Said said{program(static_cast<int>(words.size()), words.data(), catalogue_), "", ""};
    said.out = testing::internal::GetCapturedStdout();
    said.err = testing::internal::GetCapturedStderr();
    return said;
  }
  /// What it writes to standard output where nothing is wrong.
  std::string said(std::vector<std::string> const& arguments) const {
    auto const all = brouwer(arguments);
    EXPECT_EQ(all.status, 0) << all.err;
    return all.out;
  }

  std::filesystem::path folder;

 private:
  Catalogue const& catalogue_;
};

}  // namespace brouwer
