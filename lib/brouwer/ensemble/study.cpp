#include <brouwer/ensemble/study.hpp>

#include <fmt/format.h>

#include <boost/uuid/name_generator_sha1.hpp>
#include <boost/uuid/uuid_io.hpp>

namespace brouwer {
namespace {

char const* name_of(Perturbation::Law law) {
  switch (law) {
    case Perturbation::Law::uniform:
      return "uniform";
    case Perturbation::Law::normal:
      return "normal";
    case Perturbation::Law::ulps:
      return "ulps";
  }
  return "?";
}

std::string text_of(Reference const& reference) {
  switch (reference.kind) {
    case Reference::Kind::none:
      return "none";
    case Reference::Kind::exact:
      return fmt::format("exact, {} members", reference.members);
    case Reference::Kind::same_method:
      return fmt::format("{}, {} members", reference.arithmetic, reference.members);
  }
  return "?";
}

/// Doubles in hexadecimal: equal texts mean equal bits.
std::string list(std::vector<double> const& values) {
  std::string text;
  for (double value : values) text += fmt::format("{}{:a}", text.empty() ? "" : ", ", value);
  return text;
}

std::string flags(std::vector<bool> const& levels) {
  std::string text;
  for (bool on : levels) text += fmt::format("{}{}", text.empty() ? "" : ", ", on);
  return text;
}

/// rounding, constants, contraction: where there is more than the standard.
template <class Line>
void operations(Study const& study, Line const& line) {
  Study const standard;
  if (study.rounding != standard.rounding) line("rounding", fmt::format("{}", fmt::join(study.rounding, ", ")));
  if (study.constants != standard.constants) line("constants", fmt::format("{}", fmt::join(study.constants, ", ")));
  if (study.contraction != standard.contraction) line("contraction", flags(study.contraction));
}

}  // namespace

std::string canonical_text(Study const& study) {
  std::string text;
  auto const line = [&text](std::string const& key, std::string const& value) {
    text += fmt::format("{} = {}\n", key, value);
  };
  line("format", "brouwer study 1");
  line("system", study.system);
  for (auto const& [field, values] : study.values) line("system." + field, list(values));
  line("methods", fmt::format("{}", fmt::join(study.methods, ", ")));
  line("arithmetic", fmt::format("{}", fmt::join(study.arithmetics, ", ")));
  line("special_functions", fmt::format("{}", fmt::join(study.special_functions, ", ")));
  std::vector<std::string> const first_level = {"per-step"};  // once the standard, whether or not a study said it
  if (!study.coefficients.empty() && study.coefficients != first_level)
    line("coefficients", fmt::format("{}", fmt::join(study.coefficients, ", ")));
  line("compensation", flags(study.compensation));
  operations(study, line);
  line("step", list(study.step));
  if (study.steps) line("steps", std::to_string(*study.steps));
  if (study.until) line("until", list({*study.until}));
  line("members", std::to_string(study.members));
  line("seed", std::to_string(study.seed));
  for (auto const& [field, p] : study.perturb) line("perturb." + field, fmt::format("{} {:a}", name_of(p.law), p.size));
  line("quantities", fmt::format("{}", fmt::join(study.quantities, ", ")));
  line("reference", text_of(study.reference));
  line("samples",
       fmt::format("{}, {}", study.samples.count, study.samples.spacing == Samples::Spacing::log ? "log" : "linear"));
  if (study.states) line("states", "true");
  return text;
}

std::string study_hash(Study const& study) {
  boost::uuids::name_generator_sha1 const generator(boost::uuids::ns::oid());
  return to_string(generator(canonical_text(study)));
}

}  // namespace brouwer
