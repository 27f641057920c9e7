#include "analysis/causes/explain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <brouwer/error.hpp>
#include <brouwer/spelling.hpp>
#include <cerrno>
#include <system_error>

#include "analysis/causes/causes_figure.hpp"
#include "analysis/causes/explain_table.hpp"
#include "analysis/factors.hpp"
#include "studies/commands/calibration.hpp"
#include "studies/commands/commands.hpp"
#include "studies/commands/findings.hpp"
#include "studies/commands/progress_line.hpp"
#include "studies/commands/run_study.hpp"
#include "studies/factorial_design.hpp"

namespace brouwer {
namespace {

namespace fs = std::filesystem;
using Explanations = std::vector<Explanation>;

struct Format {
  char const* name;
  std::string (*render)(Explanations const&);
};
constexpr Format formats[] = {{"text", explain_text}, {"markdown", explain_markdown}, {"json", explain_json}};

Format const& format_of(std::string const& name) {
  std::vector<std::string> names;
  for (auto const& format : formats) {
    if (name == format.name) return format;
    names.emplace_back(format.name);
  }
  throw InputError(fmt::format("an explanation has no format '{}'{}", name, suggestion(name, names)));
}

/// results/NAME-explain; results/NAME-xxxxxxxx-explain where options have changed the study or the design.
fs::path folder_of(FactorialDesign const& design, ExplainCommand const& command) {
  if (!command.settings.folder.empty()) return command.settings.folder;
  auto const& study = design.parts.front().study.study;
  bool const usual = command.settings.overrides.empty() && command.factors.empty();
  return fs::path("results") /
         (usual ? study.name + "-explain" : fmt::format("{}-{:.8}-explain", study.name, study_hash(study)));
}

double cost_of(DesignPart const& part, Catalogue const& catalogue, RunOptions const& options) {
  double seconds = 0;
  for (auto const& cell : part.study.plan.cells)
    seconds += calibrate(part.study.study, catalogue, cell, options).seconds(part.study.study, cell);
  return seconds / threads_of(options);
}

/// The combinations that do not exist, each reason once.
std::vector<std::string> reasons_of(FactorialDesign const& design) {
  auto reasons = design.left_out;
  for (auto const& part : design.parts)
    for (auto const& skipped : part.study.plan.skipped)
      if (!contains(reasons, skipped.reason)) reasons.push_back(skipped.reason);
  return reasons;
}

/// What is explained, by which cells, and how long it takes from nothing; on standard error, results alone go to the
/// other stream.
void say_design(FactorialDesign const& design, Catalogue const& catalogue, fs::path const& folder,
                RunOptions const& options) {
  auto const varying = varying_factors(design.nominal);
  for (auto const& cell : design.nominal) fmt::print(stderr, "Explains   {}\n", short_label(cell, varying));
  double total = 0;
  for (auto const& part : design.parts) {
    double const seconds = cost_of(part, catalogue, options);
    fmt::print(stderr, "Runs       {}: {} cells × {} members, about {}\n", part.name, part.study.plan.cells.size(),
               part.study.study.members, duration_text(seconds));
    total += seconds;
  }
  for (auto const& reason : reasons_of(design)) fmt::print(stderr, "Left out   {}\n", reason);
  fmt::print(stderr, "Takes      about {} on {} threads, as far as it is not in {} yet\n", duration_text(total),
             threads_of(options), folder.string());
}

/// A cell of the design and where it lies.
struct Place {
  std::size_t part, cell;
};

/// The results of all parts, by question.
class DesignResults {
 public:
  DesignResults(FactorialDesign const& design, fs::path const& folder, Catalogue const& catalogue)
      : catalogue_(catalogue) {
    for (auto const& part : design.parts) results_.emplace_back(folder / part.name);
  }

  /// What each quantity of this nominal cell owes its law of growth to.
  Explanations explained(CellLabels const& nominal, Levels const& levels) const {
    Explanations found;
    auto const places = places_of(nominal);
    for (auto const& quantity : quantities(places.front())) {
      auto const with_it = having(places, quantity);
      Design design{{}, [&](std::size_t c) { return load(with_it[c], quantity); }};
      for (auto const& place : with_it)
        design.cells.push_back({labels(place), catalogue_.arithmetic(labels(place).arithmetic).bits});
      if (auto explanation = explain(design, levels)) found.push_back(std::move(*explanation));
    }
    return found;
  }

 private:
  CellLabels const& labels(Place place) const { return results_[place.part].labels(place.cell); }
  std::vector<std::string> const& quantities(Place place) const { return results_[place.part].quantities(place.cell); }
  Ensemble load(Place place, std::string const& quantity) const {
    return results_[place.part].load(place.cell, quantity);
  }

  /// The nominal cell first, then the others that ask the same.
  std::vector<Place> places_of(CellLabels const& nominal) const {
    std::vector<Place> places;
    for (std::size_t part = 0; part < results_.size(); ++part)
      for (std::size_t cell = 0; cell < results_[part].cells(); ++cell) {
        if (!same_question(labels({part, cell}), nominal)) continue;
        bool const is_nominal = labels({part, cell}) == nominal;
        places.insert(is_nominal ? places.begin() : places.end(), {part, cell});
      }
    return places;
  }

  std::vector<Place> having(std::vector<Place> places, std::string const& quantity) const {
    std::erase_if(places, [&](Place place) { return !contains(quantities(place), quantity); });
    return places;
  }

  Catalogue const& catalogue_;
  std::vector<Results> results_;
};

bool run_all(FactorialDesign const& design, Catalogue const& catalogue, fs::path const& folder,
             RunOptions const& options) {
  return std::all_of(design.parts.begin(), design.parts.end(), [&](DesignPart const& part) {
    return run_missing(part.study, catalogue, folder / part.name, options);
  });
}

}  // namespace

int explain(ExplainCommand const& command, Catalogue const& catalogue) {
  auto const& format = format_of(command.format);
  RunOptions const options = run_options(command.settings);
  auto const design = design_around(command.study, catalogue, command.settings.overrides, command.factors);
  auto const folder = folder_of(design, command);
  say_design(design, catalogue, folder, options);
  if (command.only_plan) return done;
  if (!run_all(design, catalogue, folder, options)) return interrupted;
  DesignResults const results(design, folder, catalogue);
  Explanations all;
  for (auto const& nominal : design.nominal)
    for (auto& explanation : results.explained(nominal, command.settings.levels)) {
      explanation.not_run = reasons_of(design);
      all.push_back(std::move(explanation));
    }
  fmt::print("{}", format.render(all));
  if (std::fflush(stdout) != 0) throw std::system_error(errno, std::generic_category(), "standard output");
  if (!command.no_figures) say(draw_causes(all, folder / "figures", "svg"), folder / "figures");
  return done;
}

}  // namespace brouwer
