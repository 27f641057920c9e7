#include "analysis/probe_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/distributions.hpp"
#include "analysis/escape.hpp"
#include "analysis/factors.hpp"
#include "analysis/numbers.hpp"

namespace brouwer {
namespace {

double standard_error(Interval const& interval, Levels const& levels) {
  return (interval.high - interval.low) / 2 / normal_upper_quantile((1 - levels.confidence) / 2);
}

Agreement agreement(double predicted, Interval const& its, double observed, Interval const& seen,
                    Levels const& levels) {
  double const error = std::hypot(standard_error(its, levels), standard_error(seen, levels));
  double const z = (predicted - observed) / error;
  return {z, predicted / observed, !(std::abs(z) > normal_upper_quantile(levels.test / 2))};
}

bool is_biased(LocalLaw const& law, Levels const& levels) { return law.bias.p < levels.test; }

std::string bias_of(LocalLaw const& law) { return measured(law.bias.per_step, law.bias.interval); }

/// Why σ may differ, as far as the probe itself or the run shows it.
std::string reason_of_diffusion(ProbedRow const& row) {
  auto const& local = row.local;
  if (row.observed->verdict == Verdict::bounded) return "the observed error is bounded and does not walk";
  LocalLaw const& law = local.both ? *local.both : local.rounding;
  if (law.still_growing)
    return fmt::format(
        "local errors are correlated over more than a window of {} steps, and the prediction speaks of "
        "that time only",
        local.length);
  return "";
}

std::string reason_of_cover(ProbedRow const& row) {
  double const share = static_cast<double>(row.local.covered) / static_cast<double>(row.observed->cell.steps);
  return share < 1 ? fmt::format("the windows lie in the first {:.2g} % of the run only", 100 * share)
                   : "the cause is not among what a probe sees";
}

std::string difference_in_words(char const* what, Agreement const& a, std::string const& reason) {
  return fmt::format("{} differs by {} standard errors (predicted/observed {}): {}", what, number(std::abs(a.z), 2),
                     number(a.ratio, 3), reason);
}

std::string line(char const* what, std::string const& predicted, std::string const& observed) {
  std::string text = fmt::format("  {} predicted {}", left_aligned(what, 16), left_aligned(predicted, 28));
  if (!observed.empty()) text += " observed " + observed;
  return text.substr(0, text.find_last_not_of(' ') + 1) + '\n';
}

std::string one_step_line(LocalEstimates const& local) {
  auto const& law = local.rounding;
  std::string text = fmt::format("  {} rounding: bias {} (t = {}), RMS {}", left_aligned("one step", 16), bias_of(law),
                                 number(law.bias.t, 2), number(law.size, 2));
  if (!law.autocorrelation.empty()) text += fmt::format(", ρ₁ {}", number(law.autocorrelation.front(), 2));
  if (local.both)
    text += fmt::format("; the method: bias {}, RMS {}", bias_of(*local.truncation), number(local.truncation->size, 2));
  return text + '\n';
}

std::string slopes(Persistence const& p) {
  if (std::isnan(p.per_step)) return "–";
  return fmt::format("{} ({} to {})", number(p.per_step, 2), number(p.interval.low, 2), number(p.interval.high, 2));
}

std::string prediction_lines(ProbedRow const& row) {
  auto const& p = *row.prediction;
  auto const* seen = row.observed ? &*row.observed : nullptr;
  auto const of = [&](auto text) { return seen ? text(*seen) : std::string(); };
  return line("drift β", measured(p.drift.per_step, p.drift.interval),
              of([](Estimates const& e) { return measured(e.drift.per_step, e.drift.interval); })) +
         line("diffusion σ", measured(p.diffusion.per_sqrt_step, p.diffusion.interval),
              of([](Estimates const& e) { return measured(e.diffusion.per_sqrt_step, e.diffusion.interval); })) +
         line("slopes τ", slopes(p.persistence), of([](Estimates const& e) {
                return fmt::format("{} (F {})", number(e.persistence.per_step, 2), number(e.persistence.F, 2));
              })) +
         line("RMS at the end", number(p.rms_final, 2), of([](Estimates const& e) { return number(e.rms_final, 2); }));
}

std::string block(ProbedRow const& row) {
  auto const& local = row.local;
  std::string text = one_line(local.quantity) + '\n' + one_step_line(local);
  if (row.prediction) text += prediction_lines(row);
  for (auto const& sentence : {cause_in_words(local), comparison_in_words(row)})
    if (!sentence.empty()) text += fmt::format("  {}\n", sentence);
  if (local.failed > 0)
    text += fmt::format("  {} of {} members failed and are left out.\n", local.failed, local.failed + local.members);
  return text;
}

/// "key": value, of one object.
class Object {
 public:
  Object& add(char const* key, std::string const& json) {
    pairs_.push_back(json_string(key) + ": " + json);
    return *this;
  }
  Object& text(char const* key, std::string const& value) { return add(key, json_string(value)); }
  Object& whole(char const* key, std::int64_t value) { return add(key, fmt::format("{}", value)); }
  Object& real(char const* key, double value) { return add(key, real_of(value)); }
  Object& interval(char const* key, Interval const& value) {
    return add(key, fmt::format("[{}, {}]", real_of(value.low), real_of(value.high)));
  }
  Object& list(char const* key, std::vector<double> const& values) {
    std::vector<std::string> texts;
    for (double const value : values) texts.push_back(real_of(value));
    return add(key, fmt::format("[{}]", fmt::join(texts, ", ")));
  }
  std::string json() const { return fmt::format("{{{}}}", fmt::join(pairs_, ", ")); }

 private:
  static std::string real_of(double x) { return std::isfinite(x) ? round_trip(x) : "null"; }
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
      .add("still_growing", law.still_growing ? "true" : "false")
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
  return Object().real("z", a.z).real("ratio", a.ratio).add("agrees", a.agrees ? "true" : "false").json();
}

std::string json_of(ProbedRow const& row) {
  auto const& local = row.local;
  Object object;
  object.text("cell", describe(local.cell)).text("method", local.cell.method).text("arithmetic", local.cell.arithmetic);
  object.add("compensation", local.cell.compensation ? "true" : "false").real("step", local.cell.step);
  object.whole("steps", local.cell.steps).text("quantity", local.quantity).text("unit", local.unit);
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

Agreement drift_agreement(ProbedRow const& row) {
  if (!row.prediction || !row.observed) return {};
  return agreement(row.prediction->drift.per_step, row.prediction->drift.interval, row.observed->drift.per_step,
                   row.observed->drift.interval, row.local.levels);
}

Agreement diffusion_agreement(ProbedRow const& row) {
  if (!row.prediction || !row.observed) return {};
  return agreement(row.prediction->diffusion.per_sqrt_step, row.prediction->diffusion.interval,
                   row.observed->diffusion.per_sqrt_step, row.observed->diffusion.interval, row.local.levels);
}

std::string cause_in_words(LocalEstimates const& local) {
  if (local.of_state) return "Errors of a state are changed by the steps that follow: nothing is predicted.";
  bool const rounds = is_biased(local.rounding, local.levels);
  bool const errs = local.both && is_biased(*local.truncation, local.levels);
  std::string const of_method =
      !local.both
          ? "the method conserves it"
          : (errs ? fmt::format("the method itself changes it by {} per step in the mean", bias_of(*local.truncation))
                  : "the method's own errors oscillate, no drift of them is seen");
  std::string const of_rounding =
      rounds ? fmt::format("Rounding is biased by {} per step", bias_of(local.rounding))
             : fmt::format("No bias of rounding is seen ({} per step)", bias_of(local.rounding));
  return local.truncation ? fmt::format("{}; {}.", of_rounding, of_method) : of_rounding + ".";
}

std::string comparison_in_words(ProbedRow const& row) {
  if (!row.prediction || !row.observed) return "";
  std::vector<std::string> parts;
  auto const drift = drift_agreement(row), diffusion = diffusion_agreement(row);
  auto const reason = reason_of_diffusion(row);
  if (!drift.agrees) parts.push_back(difference_in_words("β", drift, reason_of_cover(row)));
  if (!diffusion.agrees)
    parts.push_back(difference_in_words("σ", diffusion, reason.empty() ? reason_of_cover(row) : reason));
  if (!parts.empty()) return fmt::format("The run: {}.", fmt::join(parts, "; "));
  if (std::isnan(diffusion.z)) return "The run agrees within sampling error in β.";
  return "The run agrees within sampling error.";
}

std::string probe_text(std::vector<ProbedRow> const& rows) {
  std::string text;
  for (auto const& row : rows) text += block(row);
  return text;
}

std::string probe_json(std::vector<ProbedRow> const& rows) {
  std::vector<std::string> objects;
  for (auto const& row : rows) objects.push_back("  " + json_of(row));
  return fmt::format("[\n{}\n]\n", fmt::join(objects, ",\n"));
}

}  // namespace brouwer
