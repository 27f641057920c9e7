#include <brouwer/ensemble/start.hpp>

#include <Random123/philox.h>
#include <fmt/format.h>
#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include <brouwer/ensemble/arithmetics.hpp>
#include <brouwer/ensemble/operations.hpp>
#include <brouwer/error.hpp>

namespace brouwer {
namespace {

/// Which random number: Philox is a function of its counter, so that a draw depends on nothing but this.
struct Draw {
  std::uint64_t seed, member;
  std::uint64_t field;      ///< position of the field in the system's description
  std::uint64_t component;  ///< of the field
  std::uint64_t attempt;    ///< after how many refusals
};

/// U(0, 1), 53 bits, never 0 or 1. Philox 4×64-10: J. K. Salmon et al., SC11 (2011).
double uniform(Draw const& draw) {
  r123::Philox4x64 const philox;
  auto const bits = philox({{draw.component, draw.field, draw.attempt, 0}}, {{draw.seed, draw.member}});
  return (static_cast<double>(bits[0] >> 11) + 0.5) * 0x1p-53;
}

/// x moved by k representable numbers; the order of doubles is that of their bits, mirrored for negative ones.
double moved_by_ulps(double x, std::int64_t k) {
  auto const ordered = [](double v) {
    auto const bits = std::bit_cast<std::int64_t>(v);
    return bits < 0 ? std::numeric_limits<std::int64_t>::min() - bits : bits;
  };
  std::int64_t const place = ordered(x) + k;
  return std::bit_cast<double>(place < 0 ? std::numeric_limits<std::int64_t>::min() - place : place);
}

double perturbed(double x, Perturbation const& p, Draw const& draw) {
  double const u = uniform(draw);
  switch (p.law) {
    case Perturbation::Law::uniform:
      return x + p.size * (2 * u - 1);
    case Perturbation::Law::normal:
      return x + p.size * gsl_cdf_ugaussian_Pinv(u);
    case Perturbation::Law::ulps: {
      double const n = p.size;
      return moved_by_ulps(x, std::min(static_cast<std::int64_t>(u * (2 * n + 1)), static_cast<std::int64_t>(2 * n)) -
                                  static_cast<std::int64_t>(n));
    }
  }
  return x;
}

FieldValues draw_values(Study const& study, SystemDescription const& system, std::int64_t member,
                        std::uint64_t attempt) {
  FieldValues values = study.values;
  for (std::size_t f = 0; f < system.fields.size(); ++f) {
    auto const found = study.perturb.find(system.fields[f].name);
    if (found == study.perturb.end()) continue;
    auto& numbers = values.at(system.fields[f].name);
    for (std::size_t c = 0; c < numbers.size(); ++c)
      numbers[c] =
          perturbed(numbers[c], found->second, {study.seed, static_cast<std::uint64_t>(member), f, c, attempt});
  }
  if (system.project) system.project(values);
  return values;
}

Start start_of(SystemDescription const& system, FieldValues const& values) {
  Start start;
  for (auto const& field : system.fields) {
    auto const& numbers = values.at(field.name);
    auto& part = field.parameter ? start.parameters : start.state;
    part.insert(part.end(), numbers.begin(), numbers.end());
  }
  return start;
}

/// A method's makers for packs up to `widest`, from wide to narrow, then for numbers.
std::vector<TrajectoriesMaker const*> makers_up_to(MethodEntry const& method, InstructionSet widest) {
  std::vector<TrajectoriesMaker const*> makers;
  for (auto const& maker : method.makers)
    if (maker.set <= widest) makers.push_back(&maker);
  std::stable_sort(makers.begin(), makers.end(), [](auto const* a, auto const* b) { return a->set > b->set; });
  return makers;
}

}  // namespace

Start nominal_start(Study const& study, SystemDescription const& system) {
  FieldValues values = study.values;
  if (system.project) system.project(values);
  return start_of(system, values);
}

Start member_start(Study const& study, SystemDescription const& system, std::int64_t member) {
  constexpr std::uint64_t most_attempts = 1000;
  std::string reason;
  for (std::uint64_t attempt = 0; attempt < most_attempts; ++attempt) {
    auto const values = draw_values(study, system, member, attempt);
    auto const complaint = system.complaint(values);
    if (!complaint) return start_of(system, values);
    reason = *complaint;
  }
  throw InputError(fmt::format("the perturbation of member {} was refused {} times in a row ({}): make it smaller",
                               member, most_attempts, reason));
}

double rounded_to(std::string const& arithmetic, double value) {
  for_arithmetic(arithmetic, [&]<class T>(NamedArithmetic<T>) { value = static_cast<double>(static_cast<T>(value)); });
  return value;
}

Start rounded_to(std::string const& arithmetic, Start start) {
  for (auto* part : {&start.parameters, &start.state})
    for (double& value : *part) value = rounded_to(arithmetic, value);
  return start;
}

std::vector<Start> member_starts(Study const& study, SystemDescription const& system, std::string const& arithmetic,
                                 std::int64_t first, std::int64_t count) {
  std::vector<Start> starts;
  for (std::int64_t i = first; i < first + count; ++i)
    starts.push_back(rounded_to(arithmetic, member_start(study, system, i)));
  return starts;
}

std::unique_ptr<Trajectories> begin_trajectories(Catalogue const& catalogue, CellLabels const& cell,
                                                 std::vector<Start> const& starts, bool whole_state,
                                                 InstructionSet widest, RandomStreams const& streams) {
  TrajectoryRequest const request{
      cell.arithmetic, cell.special_functions, cell.coefficients, cell.compensation,   whole_state, cell.step,
      starts,          operation_rule(cell),   streams.seed,      streams.first_member};
  auto const& method = catalogue.method(cell.system, cell.method);
  for (auto const* maker : makers_up_to(method, starts.size() > 1 ? widest : InstructionSet::none))
    if (auto made = maker->begin(request)) return made;
  if (auto const reason = no_such_operations(cell); !reason.empty()) throw InputError(cell.method + ": " + reason);
  throw InputError(fmt::format("{} does not exist in {} with special functions '{}' and coefficients '{}'", cell.method,
                               cell.arithmetic, cell.special_functions, cell.coefficients));
}

std::unique_ptr<Trajectories> begin_trajectory(Catalogue const& catalogue, CellLabels const& cell, Start const& start,
                                               bool whole_state, RandomStreams const& streams) {
  return begin_trajectories(catalogue, cell, {start}, whole_state, InstructionSet::none, streams);
}

}  // namespace brouwer
