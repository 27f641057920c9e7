#include <fmt/format.h>

#include "analysis/escape.hpp"
#include "analysis/factors.hpp"
#include "analysis/numbers.hpp"
#include "analysis/probe_table.hpp"

namespace brouwer {
namespace {

/// "key": value, of one object.
class Object {
 public:
  Object& add(char const* key, std::string const& json) {
    pairs_.push_back(json_string(key) + ": " + json);
    return *this;
  }
  Object& text(char const* key, std::string const& value) { return add(key, json_string(value)); }
  Object& flag(char const* key, bool value) { return add(key, value ? "true" : "false"); }
  Object& whole(char const* key, std::int64_t value) { return add(key, fmt::format("{}", value)); }
  Object& real(char const* key, double value) { return add(key, json_number(value)); }
  Object& interval(char const* key, Interval const& value) {
    return add(key, fmt::format("[{}, {}]", json_number(value.low), json_number(value.high)));
  }
  Object& list(char const* key, std::vector<double> const& values) {
    std::vector<std::string> texts;
    for (double const value : values) texts.push_back(json_number(value));
    return add(key, fmt::format("[{}]", fmt::join(texts, ", ")));
  }
  std::string json() const { return fmt::format("{{{}}}", fmt::join(pairs_, ", ")); }

 private:
  std::vector<std::string> pairs_;
};

std::string json_of(Drift const& d) {
  return Object().real("per_step", d.per_step).interval("ci", d.interval).real("t", d.t).real("p", d.p).json();
}
std::string json_of(Diffusion const& d) {
  return Object().real("per_sqrt_step", d.per_sqrt_step).interval("ci", d.interval).json();
}
std::string json_of(Persistence const& p) {
  return Object().real("per_step", p.per_step).interval("ci", p.interval).real("F", p.F).real("p", p.p).json();
}
std::string json_of(LocalLaw const& law) {
  return Object()
      .add("bias", json_of(law.bias))
      .real("size", law.size)
      .add("diffusion", json_of(law.diffusion))
      .add("persistence", json_of(law.persistence))
      .list("autocorrelation", law.autocorrelation)
      .list("sigma_by_scale", law.scales)
      .flag("still_changing", law.still_changing)
      .json();
}
std::string json_of(Prediction const& p) {
  return Object()
      .add("drift", json_of(p.drift))
      .add("diffusion", json_of(p.diffusion))
      .add("persistence", json_of(p.persistence))
      .real("rms_final", p.rms_final)
      .json();
}
std::string json_of(Estimates const& e) {
  return Object()
      .whole("members", e.members)
      .add("drift", json_of(e.drift))
      .add("diffusion", json_of(e.diffusion))
      .add("persistence", json_of(e.persistence))
      .real("rms_final", e.rms_final)
      .text("verdict", to_string(e.verdict))
      .json();
}
std::string json_of(Agreement const& a) {
  return Object().real("z", a.z).real("ratio", a.ratio).flag("agrees", a.agrees).json();
}

/// How the operations of a step are carried out: apart, because "rounding" is what the probe has found of it.
Object operations(CellLabels const& cell) {
  return Object()
      .text("rounding", cell.rounding)
      .text("constants", cell.constants)
      .flag("contraction", cell.contraction);
}

Object labels(CellLabels const& cell) {
  Object object;
  object.text("cell", describe(cell)).text("method", cell.method).text("arithmetic", cell.arithmetic);
  object.text("special_functions", cell.special_functions).text("coefficients", cell.coefficients);
  object.flag("compensation", cell.compensation).add("operations", operations(cell).json());
  return object.real("step", cell.step).whole("steps", cell.steps);
}

std::string json_of(ProbedRow const& row) {
  auto const& local = row.local;
  Object object = labels(local.cell);
  object.text("quantity", local.quantity).text("unit", local.unit);
  object.text("high_precision", local.high_precision).whole("members", local.members).whole("failed", local.failed);
  object.whole("windows", local.windows).whole("length", local.length).whole("judged", local.judged);
  object.whole("covered", local.covered).add("rounding", json_of(local.rounding));
  if (local.truncation) object.add("truncation", json_of(*local.truncation));
  if (row.prediction) object.add("predicted", json_of(*row.prediction));
  if (row.observed) object.add("observed", json_of(*row.observed));
  if (row.observed && row.prediction)
    object.add("drift_agreement", json_of(drift_agreement(row)))
        .add("diffusion_agreement", json_of(diffusion_agreement(row)));
  return object.text("cause", cause_in_words(local)).text("comparison", comparison_in_words(row)).json();
}

}  // namespace

std::string probe_json(std::vector<ProbedRow> const& rows) {
  std::vector<std::string> objects;
  for (auto const& row : rows) objects.push_back("  " + json_of(row));
  return fmt::format("[\n{}\n]\n", fmt::join(objects, ",\n"));
}

}  // namespace brouwer
