#include "studies/commands/command_line.hpp"

#include <fmt/format.h>

#include <brouwer/error.hpp>
#include <brouwer/spelling.hpp>

#include "studies/commands/completion.hpp"
#include "studies/commands/help.hpp"
#include "studies/factorial_design.hpp"

namespace brouwer {
namespace {

void check_levels(Levels const& levels) {
  auto const inside = [](double x) { return x > 0 && x < 1; };
  if (!inside(levels.test)) throw InputError(fmt::format("--level {}: expected a number between 0 and 1", levels.test));
  if (!inside(levels.confidence))
    throw InputError(fmt::format("--confidence {}: expected a number between 0 and 1", levels.confidence));
}

void add_levels(CLI::App& app, Levels& levels) {
  app.add_option("--level", levels.test, "level at which a drift or persistence counts as seen")->capture_default_str();
  app.add_option("--confidence", levels.confidence, "of the intervals")->capture_default_str();
  app.add_option_function<std::string>(
         "--correction", [&levels](std::string const& name) { levels.correction = correction_of(name); },
         "where many drifts are tested: holm (no false alarm among all), fdr (few among those seen) or none; default: "
         "the study's")
      ->type_name("NAME");
  app.parse_complete_callback([&levels] { check_levels(levels); });
}

/// Options that stand for a key of the study, kept as typed, so that complaints can name them.
void add_override(CLI::App& app, std::vector<Override>& overrides, std::string const& option, std::string const& key,
                  std::string const& help) {
  app.add_option_function<std::string>(
         option,
         [&overrides, option, key](std::string const& value) {
           overrides.push_back({key, value, option + " " + value});
         },
         help)
      ->type_name("VALUE");
}

void add_set(CLI::App& app, std::vector<Override>& overrides) {
  app.add_option_function<std::vector<std::string>>(
         "--set",
         [&overrides](std::vector<std::string> const& assignments) {
           for (auto const& assignment : assignments) overrides.push_back(parse_override(assignment));
         },
         "any value of the study, in TOML: --set observe.samples.count=32")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->take_all();
}

/// A whole number from `least` on.
CLI::Validator at_least(std::int64_t least) {
  return {[least](std::string& text) {
            std::int64_t number = 0;
            bool const whole = CLI::detail::lexical_cast(text, number);
            return whole && number >= least ? std::string()
                                            : fmt::format("expected a whole number from {}, found '{}'", least, text);
          },
          fmt::format("from {}", least)};
}

/// What a study is computed with.
void add_computing(CLI::App& app, RunSettings& settings) {
  add_set(app, settings.overrides);
  app.add_option("--threads", settings.threads, "threads to compute with (default: all)")->check(CLI::Range(1, 4096));
  app.add_option("--lanes", settings.lanes,
                 fmt::format("members side by side in packs up to these instructions: {} (default: the widest of this "
                             "processor); the numbers are the same",
                             fmt::join(instruction_set_names(), ", ")))
      ->type_name("SET");
  add_levels(app, settings.levels);
}

void add_run_settings(CLI::App& app, RunSettings& settings, std::string const& folder_option = "-o,--output") {
  app.add_option(folder_option, settings.folder, "folder of the results (default: results/NAME)")->type_name("DIR");
  add_override(app, settings.overrides, "--members", "ensemble.members", "members in place of the study's");
  add_override(app, settings.overrides, "--steps", "integrate.steps", "steps in place of the study's");
  add_computing(app, settings);
}

void add_file_reading(CLI::App& app, FileReading& reading) {
  app.add_option("--dataset", reading.dataset, "the matrix in an HDF5 file, or a group of them (default: guess)")
      ->type_name("PATH");
  app.add_option("--times", reading.times, "the times in an HDF5 file (default: guess)")->type_name("PATH");
  auto const say = [&](FileValues values) { return [&reading, values](std::int64_t) { reading.values = values; }; };
  auto* const subtract =
      app.add_flag_function("--subtract-start", say(FileValues::subtract_start),
                            "the file holds values (energies), no errors: error = value − value at the first time");
  app.add_flag_function("--relative-to-start", say(FileValues::relative_to_start),
                        "likewise, divided by the size of the value at the first time")
      ->excludes(subtract);
}

std::vector<std::string> subcommand_names(CLI::App const& app) {
  std::vector<std::string> names;
  for (auto const* subcommand : app.get_subcommands({})) names.push_back(subcommand->get_name());
  return names;
}

std::vector<std::string> option_names(CLI::App const& app) {
  std::vector<std::string> names;
  for (auto const* option : app.get_options())
    for (auto const& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

/// Which argument was not understood, and what may have been meant.
std::string complaint_about(std::string const& extra, CLI::App const& command) {
  std::string const where = command.get_parent() ? " of 'brouwer " + command.get_name() + "'" : "";
  if (!extra.starts_with("-")) return fmt::format("unexpected argument '{}'{}", extra, where);
  std::string const name = extra.substr(0, extra.find('='));
  return fmt::format("there is no option '{}'{}{}", name, where, suggestion(name, option_names(command)));
}

CLI::App const& parsed_command(CLI::App const& app) {
  auto const chosen = app.get_subcommands();
  return chosen.empty() ? app : *chosen.front();
}

}  // namespace

template <class Command>
std::pair<CLI::App*, std::shared_ptr<Command>> CommandLine::add(std::string const& name, std::string const& summary,
                                                                Action<Command> action) {
  auto* app = app_.add_subcommand(name, summary);
  auto command = std::make_shared<Command>();
  app->final_callback([this, command, action] {
    chosen_ = [command, action](Catalogue const& catalogue) { return action(*command, catalogue); };
  });
  app->footer(help_footer(name));
  return {app, command};
}

CommandLine::CommandLine() : app_(help_introduction(), "brouwer") {
  app_.set_version_flag("--version", version_text, "version, and those of the libraries");
  app_.set_help_flag("-h,--help", "this text; after a subcommand: its options and examples");
  app_.require_subcommand(1);
  app_.footer(help_footer(""));
  add_run();
  add_plan();
  add_probe();
  add_explain();
  add_check();
  add_baseline();
  add_table();
  add_plot();
  add_report();
  add_fit();
  add_integrate();
  add_list();
  add_completion();
}

void CommandLine::add_run() {
  auto [app, command] = add<RunCommand>("run", "run what is missing of a study, then say what was found", run);
  app->add_option("study", command->study, "study file (TOML)")->type_name("STUDY")->required();
  add_run_settings(*app, command->settings);
  app->add_flag("--no-figures", command->no_figures, "do not draw figures");
}

void CommandLine::add_plan() {
  auto [app, command] = add<PlanCommand>("plan", "what a study would run, how long, and what it could see", plan);
  app->add_option("study", command->study, "study file (TOML)")->type_name("STUDY")->required();
  add_run_settings(*app, command->settings);
  app->add_option("--drift", command->drift, "what it would take to see this drift per step, and to exclude it")
      ->type_name("X");
}

void CommandLine::add_probe() {
  auto [app, command] =
      add<ProbeCommand>("probe", "errors of single steps: their causes, and what they predict", probe);
  auto& design = command->design;
  app->add_option("study", command->study, "study file (TOML)")->type_name("STUDY")->required();
  app->add_option("--members", design.members, "the study's first members are probed")
      ->check(at_least(2))
      ->capture_default_str();
  app->add_option("--windows", design.windows, "windows of consecutive steps of each member")
      ->check(at_least(2))
      ->capture_default_str();
  app->add_option("--length", design.length, "steps in a window, a multiple of 4; more where σ asks for it")
      ->check(at_least(4))
      ->capture_default_str();
  app->add_option("--cover", design.covered, "the windows lie in so many steps from the start")
      ->check(at_least(8))
      ->capture_default_str();
  app->add_option("-o,--output", command->settings.folder, "results to compare with (default: results/NAME)")
      ->type_name("DIR");
  app->add_flag("--run", command->run, "run what is missing of these results first");
  app->add_option("--format", command->format, "text or json")->capture_default_str();
  add_computing(*app, command->settings);
}

void CommandLine::add_explain() {
  auto [app, command] = add<ExplainCommand>(
      "explain", "what makes a drift: the study again with other roundings, constants, sums, precisions", explain);
  app->add_option("study", command->study, "study file (TOML)")->type_name("STUDY")->required();
  add_run_settings(*app, command->settings);
  app->add_option("--factors", command->factors,
                  fmt::format("what is changed, of {} (default: all)", fmt::join(design_factors(), ", ")))
      ->type_name("NAME,…")
      ->delimiter(',')
      ->allow_extra_args(false);
  app->add_option("--format", command->format, "text, markdown or json")->capture_default_str();
  app->add_flag("--plan", command->only_plan, "only say what would be run, and how long it would take");
  app->add_flag("--no-figures", command->no_figures, "do not draw figures");
}

void CommandLine::add_check() {
  auto [app, command] = add<CheckCommand>("check", "the expectations of a study: exit status 0 or 1", check);
  app->add_option("subject", command->subject, "study file, or a folder of results")
      ->type_name("STUDY|RESULT")
      ->required();
  app->add_option("--junit", command->junit, "write the outcome as JUnit XML")->type_name("FILE");
  app->add_option("--baseline", command->baseline, "compare with what was recorded there, too")->type_name("FILE");
  app->add_option("--entry", command->entry, "with this entry of the baseline (default: the last)")->type_name("LABEL");
  add_run_settings(*app, command->settings);
}

void CommandLine::add_baseline() {
  auto [app, command] =
      add<BaselineCommand>("baseline", "record estimates, for later runs to be compared with", baseline);
  app->add_option("subject", command->subject, "study file, or a folder of results")->type_name("STUDY|RESULT");
  app->add_option("-o,--output", command->file, "the baseline: a new file, or one that gets a further entry")
      ->type_name("FILE.json");
  app->add_option("--label", command->label, "of the entry (default: version and commit)")->type_name("TEXT");
  app->add_option("--date", command->date, "kept with the entry (default: none)")->type_name("TEXT");
  app->add_option("--list", command->list, "show the history in this file, and record nothing")->type_name("FILE.json");
  add_run_settings(*app, command->settings, "--results");
}

void CommandLine::add_table() {
  auto [app, command] = add<TableCommand>("table", "the growth table of results",
                                          [](TableCommand const& c, Catalogue const&) { return table(c); });
  app->add_option("results", command->results, "result folders")->type_name("RESULT")->required();
  app->add_option("--format", command->format, "text, csv, markdown, latex or json")->capture_default_str();
  add_levels(*app, command->levels);
}

void CommandLine::add_plot() {
  auto [app, command] = add<PlotCommand>("plot", "figures of results", plot);
  app->add_option("results", command->results, "result folders")->type_name("RESULT")->required();
  app->add_option("-o,--output", command->folder, "folder of the figures (default: RESULT/figures)")->type_name("DIR");
  app->add_option("--format", command->format, "svg, png or pdf")->capture_default_str();
  app->add_option("--plane", command->plane, "state components X,Y of clouds in phase space")
      ->type_name("X,Y")
      ->delimiter(',')
      ->expected(2);
  add_levels(*app, command->levels);
}

void CommandLine::add_report() {
  auto [app, command] = add<ReportCommand>("report", "one page of results", report);
  app->add_option("results", command->results, "result folders; several for a Markdown page")
      ->type_name("RESULT")
      ->required();
  app->add_option("-o,--output", command->file, "the page, FILE.html or FILE.md (default: RESULT/report.html)")
      ->type_name("FILE");
  add_levels(*app, command->levels);
}

void CommandLine::add_fit() {
  auto [app, command] = add<FitCommand>("fit", "the same inference on anybody's ensemble, from a csv or HDF5 file",
                                        [](FitCommand const& c, Catalogue const&) { return fit(c); });
  app->add_option("file", command->file, "csv (columns time, member, error; or time and one column a member) or HDF5")
      ->type_name("FILE")
      ->required();
  add_file_reading(*app, command->reading);
  app->add_option("--format", command->format, "text, csv, markdown, latex or json")->capture_default_str();
  app->add_option("--plot", command->figures, "draw figures there")->type_name("DIR");
  add_levels(*app, command->levels);
}

void CommandLine::add_integrate() {
  auto [app, command] = add<IntegrateCommand>("integrate", "one trajectory, csv to standard output", integrate);
  auto& overrides = command->overrides;
  app->add_option("study", command->study, "study file (TOML)")->type_name("STUDY")->required();
  app->add_option("--member", command->member, "start as this member does (default: the nominal start)")
      ->check(CLI::NonNegativeNumber);
  add_override(*app, overrides, "--method", "integrate.methods",
               "default of this and the next: the study's first level");
  add_override(*app, overrides, "--arithmetic", "integrate.arithmetic", "double, float128, mpfr-256 …");
  add_override(*app, overrides, "--compensation", "integrate.compensation", "true or false");
  add_override(*app, overrides, "--special-functions", "integrate.special_functions", "own, gsl or boost");
  add_override(*app, overrides, "--coefficients", "integrate.coefficients",
               "per-step, per-trajectory; standard, split, symplectic");
  add_override(*app, overrides, "--rounding", "integrate.rounding", "nearest, up, down, toward-zero or stochastic");
  add_override(*app, overrides, "--constants", "integrate.constants", "of the method: rounded or exact");
  add_override(*app, overrides, "--contraction", "integrate.contraction", "products fused with sums: true or false");
  add_override(*app, overrides, "--step", "integrate.step", "step size h");
  add_override(*app, overrides, "--steps", "integrate.steps", "how many steps");
  add_override(*app, overrides, "--until", "integrate.until", "how long, in the system's unit of time");
  add_set(*app, overrides);
  app->add_option("--every", command->every, "steps between two lines")->check(at_least(1))->capture_default_str();
  app->add_flag("--hex", command->hexadecimal, "hexadecimal floating point: exact in every arithmetic");
}

void CommandLine::add_list() {
  auto [app, command] = add<ListCommand>("list", "names that a study may use", list);
  app->add_option("what", command->what,
                  "systems, methods, arithmetics, operations, quantities or studies; all where left out");
}

void CommandLine::add_completion() {
  auto* app = app_.add_subcommand("completion", "completion of this command line for a shell");
  auto shell = std::make_shared<std::string>();
  app->add_option("shell", *shell, "bash or zsh")->required();
  app->footer(help_footer("completion"));
  app->final_callback([this, shell] {
    chosen_ = [this, shell](Catalogue const&) {
      fmt::print("{}", completion_script(*shell, app_));
      return static_cast<int>(done);
    };
  });
}

void CommandLine::parse(int argc, char const* const* argv) {
  auto const names = subcommand_names(app_);
  if (argc < 2)
    throw InputError(fmt::format("expected a subcommand, one of {}; try 'brouwer --help'", fmt::join(names, ", ")));
  std::string const first = argv[1];
  bool const known = std::find(names.begin(), names.end(), first) != names.end();
  if (first.starts_with("--") && !app_.get_option_no_throw(first)) throw InputError(complaint_about(first, app_));
  if (!first.starts_with("-") && !known)
    throw InputError(fmt::format("there is no subcommand '{}'{}", first, suggestion(first, names)));
  try {
    app_.parse(argc, argv);
  } catch (CLI::Success const&) {
    throw;
  } catch (CLI::ExtrasError const&) {
    auto const extras = app_.remaining(true);
    throw InputError(complaint_about(extras.empty() ? "" : extras.front(), parsed_command(app_)));
  } catch (CLI::Error const& error) {
    throw InputError(fmt::format("{}; try 'brouwer {}--help'", error.what(), known ? first + " " : ""));
  }
}

}  // namespace brouwer
