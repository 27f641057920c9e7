#include "studies/reading/study_sections.hpp"

#include <fmt/format.h>

#include <cmath>

#include "studies/reading/limits.hpp"

namespace brouwer {
namespace {

/// A cell must have at least as many steps as samples, and a number of steps that can be counted.
void check_lengths(Section& root, Study const& study) {
  Section integrate = root.section("integrate");
  for (double const h : study.step) {
    double const steps = study.steps ? static_cast<double>(*study.steps) : std::round(study.until.value_or(0) / h);
    char const* key = study.steps ? "steps" : "until";
    if (steps > static_cast<double>(most_steps))
      integrate.complain(
          key, fmt::format(" needs {:.3g} steps of h = {}, expected at most {:.0e}", steps, h, double(most_steps)));
    else if (steps < static_cast<double>(study.samples.count))
      integrate.complain(
          key, fmt::format(" gives {} steps of h = {}, fewer than the {} samples of observe.samples.count", steps, h,
                           study.samples.count));
  }
}

}  // namespace

void read_study_sections(Section& root, Catalogue const& catalogue, Study& study) {
  study.question = root.value("question", text()).value_or("");
  study.source = root.value("source", text()).value_or("");
  SystemDescription const* system = read_system(root, catalogue, study);
  for (auto const* known : {"integrate", "ensemble", "observe", "tests", "expect"}) root.find(known);
  root.refuse_unknown_keys();
  if (!system) return;
  read_integrate(root, catalogue, study);
  read_ensemble(root, *system, study);
  read_observe(root, catalogue, *system, study);
  if (study.steps || study.until) check_lengths(root, study);
}

}  // namespace brouwer
