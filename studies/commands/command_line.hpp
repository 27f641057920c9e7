#pragma once
#include <CLI/CLI.hpp>
#include <functional>
#include <memory>

#include "studies/commands/commands.hpp"

namespace brouwer {

/// The whole command line: every subcommand with its options, and what was chosen after parsing.
class CommandLine {
 public:
  CommandLine();

  /// @throws InputError one sentence, with the nearest subcommand or option
  /// @throws CLI::Success (CallForHelp, CallForVersion) where a text was asked for
  void parse(int argc, char const* const* argv);

  /// Carries out what was parsed; returns the exit status.
  int carry_out(Catalogue const& catalogue) const { return chosen_(catalogue); }

  CLI::App const& app() const { return app_; }
  CLI::App& app() { return app_; }

 private:
  template <class Command>
  using Action = int (*)(Command const&, Catalogue const&);

  template <class Command>
  std::pair<CLI::App*, std::shared_ptr<Command>> add(std::string const& name, std::string const& summary,
                                                     Action<Command> action);
  void add_run();
  void add_plan();
  void add_probe();
  void add_explain();
  void add_check();
  void add_baseline();
  void add_table();
  void add_plot();
  void add_report();
  void add_fit();
  void add_integrate();
  void add_list();
  void add_completion();

  CLI::App app_;
  std::function<int(Catalogue const&)> chosen_;
};

/// "brouwer 0.1.0" and the libraries it was built with, one a line.
std::string version_text();

}  // namespace brouwer
