#include <brouwer/ensemble/run.hpp>

#include <omp.h>

#include <algorithm>

#include <brouwer/ensemble/first_failure.hpp>
#include <brouwer/ensemble/reference.hpp>
#include <brouwer/error.hpp>
#include <brouwer/store/file.hpp>
#include <brouwer/store/folder.hpp>
#include <brouwer/store/provenance.hpp>
#include <brouwer/store/timings.hpp>

namespace brouwer {
namespace {

/// Is this unit there, whole, and the planned one? A damaged or misplaced file is said, not overwritten.
bool finished(std::filesystem::path const& file, std::string const& hash, Unit const& unit) {
  if (!std::filesystem::exists(file)) return false;
  auto const header = read_unit_header(file);
  if (header.study_hash != hash)
    throw RunError(file.string() + " belongs to another study: it is neither used nor overwritten");
  if (header.first_member != unit.first_member || header.members != unit.members)
    throw RunError(file.string() + " does not hold the members that its name says; delete it to have it computed anew");
  return true;
}

/// Member-steps of a unit, with those of its reference.
std::int64_t work_of(Study const& study, Catalogue const& catalogue, Plan const& plan, Unit const& unit) {
  bool const companion = study.reference.kind == Reference::Kind::same_method && needs_reference(study, catalogue);
  return plan.cells[unit.cell].steps * (unit.members + (companion ? compared_members(study, unit) : 0));
}

}  // namespace

int threads_of(RunOptions const& options) { return options.threads > 0 ? options.threads : omp_get_max_threads(); }

bool run(Study const& study, std::string const& study_text, Catalogue const& catalogue, Plan const& planned,
         std::filesystem::path const& folder, RunOptions const& options, Progress& progress) {
  int const threads = threads_of(options);
  Plan plan = planned;
  std::string const hash = study_hash(study);
  auto made_by = provenance(threads);
  made_by.entries.emplace_back("lanes", name_of(options.widest));
  create_result_folder(folder, hash, canonical_text(study), study_text, made_by, plan.cells);

  std::vector<Unit> missing;
  for (auto const& unit : plan.units)
    if (!finished(folder / unit.file, hash, unit)) missing.push_back(unit);
  progress.units_total = static_cast<std::int64_t>(plan.units.size());
  progress.units_before = progress.units_total - static_cast<std::int64_t>(missing.size());
  progress.steps_total = 0;
  for (auto const& unit : missing) progress.steps_total += work_of(study, catalogue, plan, unit);

  progress.notices = plan.warnings;
  if (!missing.empty())
    for (auto const& failed : check_references(study, catalogue, plan)) progress.notices.push_back(failed);

  FirstFailure failure;
  std::atomic<bool> const* stop = options.stop;
  auto const leave = [&] { return failure.seen() || (stop != nullptr && *stop); };
  auto const count = static_cast<std::int64_t>(missing.size());
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads)
  for (std::int64_t i = 0; i < count; ++i) {
    if (leave()) continue;
    try {
      auto const& unit = missing[static_cast<std::size_t>(i)];
      auto const outcome = compute_unit(study, catalogue, plan, unit, hash, progress, stop, options.widest);
      if (!outcome.finished) continue;
      write_unit(folder / unit.file, outcome.record);
      append_timing(folder, unit.file, unit.members, outcome.seconds);
      progress.units_done.fetch_add(1);
    } catch (...) {
      failure.keep_current();
    }
  }
  failure.rethrow();
  return progress.units_done == count;
}

}  // namespace brouwer
