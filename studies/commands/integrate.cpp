#include <fmt/format.h>
#include <mpfr.h>

#include <algorithm>

#include <brouwer/ensemble/start.hpp>
#include <brouwer/error.hpp>

#include "studies/commands/commands.hpp"
#include "studies/read.hpp"

namespace brouwer {
namespace {

/// Decimal digits that identify every number with this many bits: 1 + ⌈bits·log₁₀2⌉; 17 for double.
int digits_for(int bits) { return 2 + bits * 30103 / 100000; }

template <class... Arguments>
std::string printed(char const* format, Arguments... arguments) {
  char* text = nullptr;
  if (mpfr_asprintf(&text, format, arguments...) < 0) throw std::bad_alloc();
  std::string const copy = text;
  mpfr_free_str(text);
  return copy;
}

std::string decimal(Widest const& x, int digits) { return printed("%.*Re", digits - 1, x.backend().data()); }

/// Exact, as C's %a: the significand of Widest holds every arithmetic's numbers. MPFR leaves the leading digit open
/// (0x6.6p-4 or 0x1.98p-2); that of a number in [1, 2) is 1.
std::string hexadecimal(Widest const& x) {
  if (!mpfr_regular_p(x.backend().data())) return fmt::format("{:a}", static_cast<double>(x));  // 0, nan, inf
  mpfr_exp_t const exponent = mpfr_get_exp(x.backend().data()) - 1;
  Widest const significand = ldexp(x, static_cast<int>(-exponent));
  std::string const text = printed("%Ra", significand.backend().data());
  return fmt::format("{}p{:+}", text.substr(0, text.find('p')), exponent);
}

/// Names of the first integrals, component by component, as Trajectories::first_integrals orders them.
std::vector<std::string> integral_names(SystemDescription const& system) {
  std::vector<std::string> names;
  for (auto const& quantity : system.quantities)
    if (quantity.kind == Quantity::Kind::integral)
      names.insert(names.end(), quantity.components.begin(), quantity.components.end());
  return names;
}

/// Writes one trajectory as csv, a line every so many steps.
class Tracer {
 public:
  Tracer(IntegrateCommand const& command, Catalogue const& catalogue, CellLabels const& cell)
      : hexadecimal_(command.hexadecimal),
        digits_(digits_for(catalogue.arithmetic(cell.arithmetic).bits)),
        step_(rounded_to(cell.arithmetic, cell.step)),
        integral_names_(integral_names(catalogue.system(cell.system))),
        state_(catalogue.system(cell.system).state_components.size()),
        integrals_(integral_names_.size()) {}

  void header(SystemDescription const& system) const {
    fmt::print("t,{},{}\n", fmt::join(system.state_components, ","), fmt::join(integral_names_, ","));
  }

  void line(Trajectories const& trajectory, std::int64_t steps) {
    trajectory.state(0, state_);
    if (auto const failure = trajectory.failure(0))
      throw RunError(fmt::format("there is no state after step {}: {}", failure->step, in_words(failure->reason)));
    trajectory.first_integrals(0, integrals_);
    std::string text = written(Widest(step_) * steps);
    for (auto const* values : {&state_, &integrals_})
      for (auto const& value : *values) text.append(",").append(written(value));
    fmt::print("{}\n", text);
  }

 private:
  std::string written(Widest const& x) const { return hexadecimal_ ? hexadecimal(x) : decimal(x, digits_); }

  bool hexadecimal_;
  int digits_;
  double step_;
  std::vector<std::string> integral_names_;
  std::vector<Widest> state_, integrals_;
};

CellLabels first_cell(Plan const& plan, std::string const& study) {
  if (!plan.cells.empty()) return plan.cells.front();
  std::string const reason = plan.skipped.empty() ? "it is empty" : plan.skipped.front().reason;
  throw InputError(fmt::format("{}: there is nothing to integrate: {}", study, reason));
}

Start start_of(IntegrateCommand const& command, Study const& study, SystemDescription const& system) {
  if (!command.member) return nominal_start(study, system);
  if (*command.member >= study.members)
    throw InputError(fmt::format("--member {}: the study has members 0 to {}", *command.member, study.members - 1));
  return member_start(study, system, *command.member);
}

}  // namespace

int integrate(IntegrateCommand const& command, Catalogue const& catalogue) {
  auto overrides = command.overrides;
  overrides.push_back(
      {"observe.samples.count", "1", "integrate"});  // samples are of ensembles: any number of steps will do
  StudyFile const file = read_study(command.study, catalogue, overrides);
  SystemDescription const& system = catalogue.system(file.study.system);
  CellLabels const cell = first_cell(file.plan, command.study);
  auto const trajectory =
      begin_trajectory(catalogue, cell, rounded_to(cell.arithmetic, start_of(command, file.study, system)), true,
                       {file.study.seed, command.member.value_or(0)});
  Tracer tracer(command, catalogue, cell);
  tracer.header(system);
  tracer.line(*trajectory, 0);
  for (std::int64_t at = 0; at < cell.steps;) {
    std::int64_t const next = at + std::min(command.every, cell.steps - at);
    trajectory->advance(next - at);
    at = next;
    tracer.line(*trajectory, at);
  }
  return done;
}

}  // namespace brouwer
