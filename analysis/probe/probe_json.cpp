#include <fmt/format.h>

#include "analysis/factors.hpp"
#include "analysis/json_object.hpp"
#include "analysis/probe/probe_table.hpp"

namespace brouwer {
namespace {

std::string json_of(Drift const& d) {
  return JsonObject().real("per_step", d.per_step).interval("ci", d.interval).real("t", d.t).real("p", d.p).json();
}
std::string json_of(Diffusion const& d) {
  return JsonObject().real("per_sqrt_step", d.per_sqrt_step).interval("ci", d.interval).json();
}
std::string json_of(Persistence const& p) {
  return JsonObject().real("per_step", p.per_step).interval("ci", p.interval).real("F", p.F).real("p", p.p).json();
}
std::string json_of(LocalLaw const& law) {
  return JsonObject()
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
  return JsonObject()
      .add("drift", json_of(p.drift))
      .add("diffusion", json_of(p.diffusion))
      .add("persistence", json_of(p.persistence))
      .real("rms_final", p.rms_final)
      .json();
}
std::string json_of(Estimates const& e) {
  return JsonObject()
      .whole("members", e.members)
      .add("drift", json_of(e.drift))
      .add("diffusion", json_of(e.diffusion))
      .add("persistence", json_of(e.persistence))
      .real("rms_final", e.rms_final)
      .text("verdict", to_string(e.verdict))
      .json();
}
std::string json_of(Agreement const& a) {
  return JsonObject().real("z", a.z).real("ratio", a.ratio).flag("agrees", a.agrees).json();
}

/// How the operations of a step are carried out: apart, because "rounding" is what the probe has found of it.
JsonObject operations(CellLabels const& cell) {
  return JsonObject()
      .text("rounding", cell.rounding)
      .text("constants", cell.constants)
      .flag("contraction", cell.contraction);
}

JsonObject labels(CellLabels const& cell) {
  JsonObject object;
  object.text("cell", describe(cell)).text("method", cell.method).text("arithmetic", cell.arithmetic);
  object.text("special_functions", cell.special_functions).text("coefficients", cell.coefficients);
  object.flag("compensation", cell.compensation).add("operations", operations(cell).json());
  return object.real("step", cell.step).whole("steps", cell.steps);
}

std::string json_of(ProbedRow const& row) {
  auto const& local = row.local;
  JsonObject object = labels(local.cell);
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
