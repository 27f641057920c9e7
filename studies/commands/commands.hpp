#pragma once
#include <brouwer/ensemble/catalogue.hpp>
#include <brouwer/ensemble/probe.hpp>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "analysis/estimates.hpp"
#include "analysis/files/ensembles_file.hpp"
#include "studies/reading/overrides.hpp"

namespace brouwer {

// What each subcommand was asked for, as data, and the function that carries it out. The functions return the exit
// status and throw InputError or RunError; results go to standard output, progress and remarks to standard error.

enum ExitStatus { done = 0, expectation_failed = 1, wrong_input = 2, run_failed = 3, interrupted = 75 };

/// How a study is run; shared by run, check and plan.
struct RunSettings {
  std::vector<Override> overrides;  ///< --members, --steps, --set, in this order
  std::string folder;               ///< "": results/NAME in the current folder
  int threads = 0;                  ///< 0: all
  std::string lanes;                ///< packs up to this instruction set; "": the widest of the processor
  Levels levels;
};

struct RunCommand {
  std::string study;
  RunSettings settings;
  bool no_figures = false;
};

struct PlanCommand {
  std::string study;
  RunSettings settings;
  std::optional<double> drift;  ///< per step, that should be seen
};

struct ProbeCommand {
  std::string study;
  RunSettings settings;  ///< overrides: of --set alone; folder: of the results to compare with
  ProbeDesign design;
  std::string format = "text";
  bool run = false;  ///< what is missing of the results first
};

struct ExplainCommand {
  std::string study;
  RunSettings settings;              ///< folder: of the whole design
  std::vector<std::string> factors;  ///< those that are changed; empty: all
  std::string format = "text";
  bool only_plan = false;
  bool no_figures = false;
};

struct TableCommand {
  std::vector<std::string> results;
  std::string format = "text";
  Levels levels;
};

struct PlotCommand {
  std::vector<std::string> results;
  std::string folder;  ///< "": figures/ in the result folder
  std::string format = "svg";
  std::vector<std::string> plane;  ///< two state components, for clouds; empty: the system's usual ones
  Levels levels;
};

struct ReportCommand {
  std::vector<std::string> results;  ///< several for a Markdown page only
  std::string file;                  ///< FILE.html, FILE.htm or FILE.md; "": report.html in the result folder
  Levels levels;
};

struct CheckCommand {
  std::string subject;   ///< a study file or a result folder
  std::string junit;     ///< "": none
  std::string baseline;  ///< with what it is compared, too; "": nothing
  std::string entry;     ///< of that baseline, by its label; "": the last
  RunSettings settings;
};

struct BaselineCommand {
  std::string subject;  ///< a study file or a result folder
  std::string file;     ///< where the history is kept
  std::string label;    ///< "": version and commit
  std::string date;     ///< "": none
  std::string list;     ///< a history to show instead; "": none
  RunSettings settings;
};

struct FitCommand {
  std::string file;
  FileReading reading;
  std::string format = "text";
  std::string figures;  ///< "": none
  Levels levels;
};

struct IntegrateCommand {
  std::string study;
  std::vector<Override> overrides;
  std::optional<std::int64_t> member;  ///< none: the nominal start
  std::int64_t every = 1;              ///< steps between two lines
  bool hexadecimal = false;
};

struct ListCommand {
  std::string what;  ///< "": everything
};

int run(RunCommand const& command, Catalogue const& catalogue);
int plan(PlanCommand const& command, Catalogue const& catalogue);
int probe(ProbeCommand const& command, Catalogue const& catalogue);
int explain(ExplainCommand const& command, Catalogue const& catalogue);
int table(TableCommand const& command);
int plot(PlotCommand const& command, Catalogue const& catalogue);
int report(ReportCommand const& command, Catalogue const& catalogue);
int check(CheckCommand const& command, Catalogue const& catalogue);
int baseline(BaselineCommand const& command, Catalogue const& catalogue);
int fit(FitCommand const& command);
int integrate(IntegrateCommand const& command, Catalogue const& catalogue);
int list(ListCommand const& command, Catalogue const& catalogue);
/// What `list` can be asked for.
std::vector<std::string> listing_names();

}  // namespace brouwer
