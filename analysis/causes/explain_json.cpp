#include <fmt/format.h>

#include "analysis/causes/explain_table.hpp"
#include "analysis/causes/remainder.hpp"
#include "analysis/factors.hpp"
#include "analysis/json_object.hpp"

namespace brouwer {
namespace {

std::string json_of(Drift const& d) {
  return JsonObject().real("per_step", d.per_step).interval("ci", d.interval).real("t", d.t).real("p", d.p).json();
}

std::string json_of(Share const& share) {
  return JsonObject().real("value", share.value).interval("ci", share.interval).json();
}

/// Every factor of a cell.
JsonObject& add_cell(JsonObject& object, CellLabels const& cell) {
  object.text("cell", describe(cell)).text("system", cell.system).text("method", cell.method);
  object.text("arithmetic", cell.arithmetic).text("special_functions", cell.special_functions);
  object.text("coefficients", cell.coefficients)
      .flag("compensation", cell.compensation)
      .text("rounding", cell.rounding);
  object.text("constants", cell.constants).flag("contraction", cell.contraction).real("step", cell.step);
  return object.whole("steps", cell.steps);
}

std::string json_of(ComparedCell const& c) {
  JsonObject object;
  add_cell(object, c.cell).list("changed", c.changed).whole("bits", c.bits).whole("lost", c.lost);
  object.add("drift", json_of(c.drift)).real("p_of_equal_drift", c.p).add("drift_left", json_of(c.drift_left));
  object.add("slopes_left", json_of(c.slopes_left)).add("diffusion_left", json_of(c.diffusion_left));
  return object.add("size_left", json_of(c.size_left)).json();
}

std::string json_of(FactorialEffect const& f) {
  JsonObject object;
  object.list("factors", f.factors).add("drift", json_of(f.drift)).real("share_of_drift", f.drift.share);
  object.add("slopes", json_of(f.slopes)).real("p_slopes", f.p_slopes);
  return object.add("diffusion_factor", json_of(f.diffusion)).real("p_diffusion", f.p_diffusion).json();
}

template <class Item>
std::string json_of(std::vector<Item> const& items) {
  std::vector<std::string> texts;
  for (auto const& item : items) texts.push_back(json_of(item));
  return json_array(texts);
}

std::string json_of(Explanation const& e) {
  auto const& n = e.nominal;
  JsonObject object;
  add_cell(object, n.cell).text("quantity", n.quantity).text("unit", n.unit).text("verdict", to_string(n.verdict));
  object.whole("members", n.members)
      .whole("failed", n.failed)
      .whole("compared", e.members)
      .real("confidence", e.confidence)
      .add("drift", json_of(n.drift));
  object.real("diffusion", n.diffusion.per_sqrt_step).real("slopes", n.persistence.per_step).real("F", n.persistence.F);
  object.text("subject", to_string(e.subject)).text("cause", to_string(e.cause)).text("sentence", e.sentence);
  return object.add("cells", json_of(e.cells))
      .add("effects", json_of(e.effects))
      .list("left_out", e.left_out)
      .list("not_run", e.not_run)
      .json();
}

}  // namespace

std::string explain_json(std::vector<Explanation> const& explanations) {
  std::vector<std::string> objects;
  for (auto const& e : explanations) objects.push_back("  " + json_of(e));
  return fmt::format("[\n{}\n]\n", fmt::join(objects, ",\n"));
}

}  // namespace brouwer
