#include "studies/commands/run_study.hpp"

#include <fmt/format.h>

#include <brouwer/ensemble/run.hpp>
#include <brouwer/error.hpp>

#include "analysis/factors.hpp"
#include "studies/commands/interrupt.hpp"
#include "studies/commands/progress_line.hpp"

namespace brouwer {
namespace {

std::string reference_text(Reference const& reference) {
  switch (reference.kind) {
    case Reference::Kind::none:
      return "none";
    case Reference::Kind::exact:
      return fmt::format("the exact flow, for {} members", reference.members);
    case Reference::Kind::same_method:
      return fmt::format("the same method in {}, for {} members", reference.arithmetic, reference.members);
  }
  return "";
}

void print_entry(std::string const& name, std::string const& text) {
  if (!text.empty()) fmt::print("{:<10} {}\n", name, text);
}

std::string runs_text(StudyFile const& file) {
  return fmt::format("{} cells × {} members, {:.3g} member-steps in {} units", file.plan.cells.size(),
                     file.study.members, member_steps(file), file.plan.units.size());
}

}  // namespace

double member_steps(StudyFile const& file) {
  double steps = 0;
  for (auto const& cell : file.plan.cells)
    steps += static_cast<double>(cell.steps) * static_cast<double>(file.study.members);
  return steps;
}

Levels levels_of(StudyFile const& file, RunSettings const& settings) {
  Levels levels = settings.levels;
  if (!levels.correction) levels.correction = file.correction.value_or(Correction::none);
  return levels;
}

std::filesystem::path result_folder(StudyFile const& file, RunSettings const& settings) {
  if (!settings.folder.empty()) return settings.folder;
  std::filesystem::path const results = "results";
  if (settings.overrides.empty()) return results / file.study.name;
  return results / fmt::format("{}-{:.8}", file.study.name, study_hash(file.study));
}

std::vector<std::pair<std::string, std::string>> run_entries(StudyFile const& file, Catalogue const& catalogue) {
  Study const& study = file.study;
  std::vector<std::pair<std::string, std::string>> entries;
  entries.emplace_back("System", fmt::format("{}: {}", study.system, catalogue.system(study.system).title));
  entries.emplace_back("Runs", runs_text(file));
  auto const varying = varying_factors(file.plan.cells);
  for (auto const& cell : file.plan.cells) entries.emplace_back("", short_label(cell, varying));
  if (file.plan.cells.size() > 1)
    entries.emplace_back("All with", describe(file.plan.cells.front(), constant_factors(file.plan.cells)));
  entries.emplace_back("Observes",
                       fmt::format("{}; {} samples", fmt::join(study.quantities, ", "), study.samples.count));
  entries.emplace_back("Reference", reference_text(study.reference));
  for (auto const& skipped : file.plan.skipped)
    entries.emplace_back("Left out", fmt::format("{}: {}", describe(skipped.cell), skipped.reason));
  return entries;
}

void print_study(StudyFile const& file, Catalogue const& catalogue, std::filesystem::path const& folder) {
  print_entry("Question", file.study.question);
  print_entry("Source", file.study.source);
  for (auto const& [name, text] : run_entries(file, catalogue)) print_entry(name, text);
  print_entry("Results", folder.string());
  std::fflush(stdout);  // before progress appears on the other stream
}

RunOptions run_options(RunSettings const& settings) {
  RunOptions options;
  options.threads = settings.threads;
  if (!settings.lanes.empty()) options.widest = instruction_set(settings.lanes);
  return options;
}

bool run_missing(StudyFile const& file, Catalogue const& catalogue, std::filesystem::path const& folder,
                 RunOptions options) {
  InterruptGuard const guard;
  Progress progress;
  bool finished = false;
  {
    ProgressLine const line(progress);
    options.stop = &InterruptGuard::flag();
    finished = run(file.study, file.text, catalogue, file.plan, folder, options, progress);
  }
  for (auto const& notice : progress.notices) fmt::print(stderr, "brouwer: {}\n", notice);
  if (!finished)
    fmt::print(stderr, "brouwer: interrupted: {} of {} units are finished in {}; the same command resumes\n",
               progress.units_before + progress.units_done.load(), progress.units_total, folder.string());
  return finished;
}

}  // namespace brouwer
