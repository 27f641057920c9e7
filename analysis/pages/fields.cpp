#include "analysis/pages/fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <variant>

#include "analysis/escape.hpp"
#include "analysis/expectations/decision.hpp"
#include "analysis/numbers.hpp"
#include "analysis/verdict/failures.hpp"

namespace brouwer {
namespace {

using Candidates = std::vector<Candidate>;
using Members = std::vector<std::string>;
using Numbers = std::vector<double>;
using Value = std::variant<std::string, bool, std::int64_t, double, Interval, Candidates, Members, Numbers>;

/// A key, with a dot where json nests, and its value.
struct Field {
  char const* key;
  Value (*of)(Estimates const&);
};

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();
constexpr Counted no_count = {undefined, {undefined, undefined}};
constexpr Interval no_interval = {undefined, undefined};
FullModel const no_model = {{},          0,           undefined,   undefined,   undefined, undefined, undefined,
                            no_interval, no_interval, no_interval, no_interval, undefined, undefined, undefined};
SharedCourse const no_course = {
    undefined, undefined, undefined, {undefined, no_interval, undefined, undefined, undefined}};
Transient const no_transient = {undefined, undefined, {undefined, no_interval, undefined, undefined, undefined}};

double with_them(Estimates const& e, double value) { return e.far_off.members.empty() ? undefined : value; }

/// "walk + slopes + noise"
std::string in_words(LawTerms const& terms) {
  std::vector<std::string> words;
  if (terms.walk) words.push_back("walk");
  if (terms.slopes) words.push_back("slopes");
  if (terms.noise) words.push_back("noise");
  return fmt::format("{}", fmt::join(words, " + "));
}

/// Of every lag, or of every scale, one number.
template <class Item, class Member>
Numbers each(std::vector<Item> IncrementTests::*list, Member member, Estimates const& e) {
  Numbers numbers;
  if (e.increments)
    for (auto const& item : *e.increments.*list) numbers.push_back(static_cast<double>(std::invoke(member, item)));
  return numbers;
}

constexpr auto lags = &IncrementTests::autocorrelations;
constexpr auto scales = &IncrementTests::variance_ratios;
constexpr auto low = [](auto const& test) { return test.interval.low; };
constexpr auto high = [](auto const& test) { return test.interval.high; };
constexpr auto sigma_low = [](VarianceRatio const& scale) { return scale.sigma_interval.low; };
constexpr auto sigma_high = [](VarianceRatio const& scale) { return scale.sigma_interval.high; };

/// One number of the tests; NaN where there are none.
template <class Of>
double of_increments(Estimates const& e, Of of) {
  return e.increments ? std::invoke(of, *e.increments) : undefined;
}

template <class Member>
double of_shape(Estimates const& e, Member member) {
  return e.increments ? std::invoke(member, e.increments->normality) : undefined;
}

using E = Estimates;
using I = IncrementTests;
Field const fields[] = {
    {"system", [](E const& e) -> Value { return e.cell.system; }},
    {"method", [](E const& e) -> Value { return e.cell.method; }},
    {"arithmetic", [](E const& e) -> Value { return e.cell.arithmetic; }},
    {"special_functions", [](E const& e) -> Value { return e.cell.special_functions; }},
    {"coefficients", [](E const& e) -> Value { return e.cell.coefficients; }},
    {"compensation", [](E const& e) -> Value { return e.cell.compensation; }},
    {"step", [](E const& e) -> Value { return e.cell.step; }},
    {"steps", [](E const& e) -> Value { return e.cell.steps; }},
    {"rounding", [](E const& e) -> Value { return e.cell.rounding; }},
    {"constants", [](E const& e) -> Value { return e.cell.constants; }},
    {"contraction", [](E const& e) -> Value { return e.cell.contraction; }},
    {"quantity", [](E const& e) -> Value { return e.quantity; }},
    {"family", [](E const& e) -> Value { return e.family; }},
    {"unit", [](E const& e) -> Value { return e.unit; }},
    {"members", [](E const& e) -> Value { return e.members; }},
    {"failed", [](E const& e) -> Value { return e.failed; }},
    {"failures", [](E const& e) -> Value { return reasons(e); }},
    {"samples", [](E const& e) -> Value { return e.samples; }},
    {"rms_final", [](E const& e) -> Value { return e.rms_final; }},
    {"drift.per_step", [](E const& e) -> Value { return e.drift.per_step; }},
    {"drift.ci", [](E const& e) -> Value { return e.drift.interval; }},
    {"drift.t", [](E const& e) -> Value { return e.drift.t; }},
    {"drift.p", [](E const& e) -> Value { return e.drift.own_p(); }},
    {"drift.share", [](E const& e) -> Value { return e.drift.share; }},
    {"drift.p_adjusted", [](E const& e) -> Value { return e.drift.p_alone ? e.drift.p : undefined; }},
    {"persistence.per_step", [](E const& e) -> Value { return e.persistence.per_step; }},
    {"persistence.F", [](E const& e) -> Value { return e.persistence.F; }},
    {"persistence.p", [](E const& e) -> Value { return e.persistence.p; }},
    {"persistence.p_low", [](E const& e) -> Value { return e.persistence.p_low; }},
    {"persistence.ci", [](E const& e) -> Value { return e.persistence.interval; }},
    {"diffusion.per_sqrt_step", [](E const& e) -> Value { return e.diffusion.per_sqrt_step; }},
    {"diffusion.ci", [](E const& e) -> Value { return e.diffusion.interval; }},
    {"noise.size", [](E const& e) -> Value { return e.noise.size; }},
    {"noise.ci", [](E const& e) -> Value { return e.noise.interval; }},
    {"tails.kurtosis", [](E const& e) -> Value { return e.tails.kurtosis; }},
    {"tails.dispersion", [](E const& e) -> Value { return e.tails.dispersion; }},
    {"tails.normal", [](E const& e) -> Value { return e.tails.normal; }},
    {"model.chosen", [](E const& e) -> Value { return e.model ? in_words(e.model->law().terms) : ""; }},
    {"model.candidates", [](E const& e) -> Value { return e.model.value_or(FullModel{}).candidates; }},
    {"model.p_noise", [](E const& e) -> Value { return e.model.value_or(no_model).p_noise; }},
    {"model.p_walk", [](E const& e) -> Value { return e.model.value_or(no_model).p_walk; }},
    {"model.p_slopes", [](E const& e) -> Value { return e.model.value_or(no_model).p_slopes; }},
    {"model.p_course", [](E const& e) -> Value { return e.model.value_or(no_model).p_course; }},
    {"model.p_end", [](E const& e) -> Value { return e.model.value_or(no_model).p_end; }},
    {"model.drift_ci", [](E const& e) -> Value { return e.model.value_or(no_model).drift; }},
    {"model.slopes_ci", [](E const& e) -> Value { return e.model.value_or(no_model).slopes; }},
    {"model.diffusion_ci", [](E const& e) -> Value { return e.model.value_or(no_model).diffusion; }},
    {"model.noise_ci", [](E const& e) -> Value { return e.model.value_or(no_model).noise; }},
    {"transient.until", [](E const& e) -> Value { return e.transient.value_or(no_transient).until; }},
    {"transient.p", [](E const& e) -> Value { return e.transient.value_or(no_transient).p; }},
    {"transient.drift_after", [](E const& e) -> Value { return e.transient.value_or(no_transient).after.per_step; }},
    {"transient.drift_after_ci", [](E const& e) -> Value { return e.transient.value_or(no_transient).after.interval; }},
    {"transient.drift_after_p", [](E const& e) -> Value { return e.transient.value_or(no_transient).after.p; }},
    {"course.size", [](E const& e) -> Value { return e.course.value_or(no_course).size; }},
    {"course.reach", [](E const& e) -> Value { return e.course.value_or(no_course).reach; }},
    {"course.degrees", [](E const& e) -> Value { return e.course.value_or(no_course).degrees; }},
    {"course.whole_drift", [](E const& e) -> Value { return e.course.value_or(no_course).whole.per_step; }},
    {"course.whole_drift_ci", [](E const& e) -> Value { return e.course.value_or(no_course).whole.interval; }},
    {"course.whole_drift_p", [](E const& e) -> Value { return e.course.value_or(no_course).whole.p; }},
    {"far_off.members", [](E const& e) -> Value { return e.far_off.members; }},
    {"far_off.set_aside", [](E const& e) -> Value { return e.far_off.set_aside; }},
    {"far_off.drift_with_them", [](E const& e) -> Value { return with_them(e, e.far_off.drift.per_step); }},
    {"far_off.diffusion_with_them",
     [](E const& e) -> Value { return with_them(e, e.far_off.diffusion.per_sqrt_step); }},
    {"growth.exponent", [](E const& e) -> Value { return e.growth.exponent; }},
    {"growth.ci", [](E const& e) -> Value { return e.growth.interval; }},
    {"increments.count", [](E const& e) -> Value { return e.increments.value_or(I{}).count; }},
    {"increments.lag", [](E const& e) -> Value { return each(lags, &Autocorrelation::lag, e); }},
    {"increments.correlation", [](E const& e) -> Value { return each(lags, &Autocorrelation::rho, e); }},
    {"increments.correlation_low", [](E const& e) -> Value { return each(lags, low, e); }},
    {"increments.correlation_high", [](E const& e) -> Value { return each(lags, high, e); }},
    {"increments.correlation_p", [](E const& e) -> Value { return each(lags, &Autocorrelation::p, e); }},
    {"increments.scale", [](E const& e) -> Value { return each(scales, &VarianceRatio::scale, e); }},
    {"increments.variance_ratio", [](E const& e) -> Value { return each(scales, &VarianceRatio::ratio, e); }},
    {"increments.variance_ratio_low", [](E const& e) -> Value { return each(scales, low, e); }},
    {"increments.variance_ratio_high", [](E const& e) -> Value { return each(scales, high, e); }},
    {"increments.variance_ratio_p", [](E const& e) -> Value { return each(scales, &VarianceRatio::p, e); }},
    {"increments.sigma", [](E const& e) -> Value { return each(scales, &VarianceRatio::sigma, e); }},
    {"increments.sigma_low", [](E const& e) -> Value { return each(scales, sigma_low, e); }},
    {"increments.sigma_high", [](E const& e) -> Value { return each(scales, sigma_high, e); }},
    {"increments.all_ratios_p", [](E const& e) -> Value { return of_increments(e, &I::variance_ratio_p); }},
    {"increments.skewness", [](E const& e) -> Value { return of_shape(e, &Normality::skewness); }},
    {"increments.excess_kurtosis", [](E const& e) -> Value { return of_shape(e, &Normality::excess_kurtosis); }},
    {"increments.anderson_darling", [](E const& e) -> Value { return of_shape(e, &Normality::anderson_darling); }},
    {"increments.normal_p", [](E const& e) -> Value { return of_shape(e, &Normality::p); }},
    {"increments.histogram_z", [](E const& e) -> Value { return e.increments.value_or(I{}).histogram_z; }},
    {"increments.histogram_density", [](E const& e) -> Value { return e.increments.value_or(I{}).histogram_density; }},
    {"smallest_visible_drift", [](E const& e) -> Value { return e.smallest_visible_drift; }},
    {"smallest_provable_drift", [](E const& e) -> Value { return smallest_provable_drift(e); }},
    {"power.drift", [](E const& e) -> Value { return power_curve(e).drifts; }},
    {"power.chance", [](E const& e) -> Value { return power_curve(e).chances; }},
    {"count.mean", [](E const& e) -> Value { return e.count.value_or(no_count).mean; }},
    {"count.range", [](E const& e) -> Value { return e.count.value_or(no_count).range; }},
    {"levels.confidence", [](E const& e) -> Value { return e.levels.confidence; }},
    {"levels.test", [](E const& e) -> Value { return e.levels.test; }},
    {"levels.power", [](E const& e) -> Value { return e.levels.power; }},
    {"levels.correction",
     [](E const& e) -> Value { return to_string(e.levels.correction.value_or(Correction::none)); }},
    {"verdict", [](E const& e) -> Value { return to_string(e.verdict); }},
    {"sentence", [](E const& e) -> Value { return e.sentence; }},
};

struct AsJson {
  std::string operator()(std::string const& text) const { return json_string(text); }
  std::string operator()(bool yes) const { return yes ? "true" : "false"; }
  std::string operator()(std::int64_t n) const { return fmt::format("{}", n); }
  std::string operator()(double x) const { return json_number(x); }
  std::string operator()(Interval i) const { return fmt::format("[{}, {}]", (*this)(i.low), (*this)(i.high)); }
  std::string operator()(Members const& members) const {
    std::vector<std::string> names;
    for (auto const& member : members) names.push_back(json_string(member));
    return fmt::format("[{}]", fmt::join(names, ", "));
  }
  std::string operator()(Candidates const& candidates) const {
    std::vector<std::string> laws;
    for (auto const& c : candidates)
      laws.push_back(fmt::format(R"({{"law": "{}", "log_likelihood": {}, "drift": {}, "slopes": {}, "diffusion": {}, )"
                                 R"("noise": {}}})",
                                 in_words(c.terms), (*this)(c.log_likelihood), (*this)(c.drift), (*this)(c.slopes),
                                 (*this)(c.diffusion), (*this)(c.noise)));
    return fmt::format("[{}]", fmt::join(laws, ", "));
  }
  std::string operator()(Numbers const& numbers) const {
    std::vector<std::string> texts;
    for (double const x : numbers) texts.push_back((*this)(x));
    return fmt::format("[{}]", fmt::join(texts, ", "));
  }
};

/// Numbers that are not defined are empty cells, infinite ones are inf; a list stands in one cell, with blanks.
struct AsCsv {
  std::string operator()(std::string const& text) const { return csv_field(text); }
  std::string operator()(bool yes) const { return yes ? "true" : "false"; }
  std::string operator()(std::int64_t n) const { return fmt::format("{}", n); }
  std::string operator()(double x) const { return std::isnan(x) ? "" : round_trip(x); }
  std::string operator()(Interval i) const { return (*this)(i.low) + ',' + (*this)(i.high); }
  std::string operator()(Members const& members) const { return csv_field(fmt::format("{}", fmt::join(members, " "))); }
  /// Their log-likelihoods; the rest is in json.
  std::string operator()(Candidates const& candidates) const {
    std::vector<std::string> laws;
    for (auto const& c : candidates) laws.push_back(in_words(c.terms) + ": " + round_trip(c.log_likelihood));
    return csv_field(fmt::format("{}", fmt::join(laws, "; ")));
  }
  std::string operator()(Numbers const& numbers) const {
    std::vector<std::string> texts;
    for (double const x : numbers) texts.push_back(round_trip(x));
    return fmt::format("{}", fmt::join(texts, " "));
  }
};

/// "drift.per_step" → {"drift", "per_step"}; "steps" → {"", "steps"}.
std::pair<std::string, std::string> split(std::string const& key) {
  auto const dot = key.find('.');
  return dot == std::string::npos ? std::pair{std::string(), key} : std::pair{key.substr(0, dot), key.substr(dot + 1)};
}

/// What stands under one key of the row: a value, or an object where several fields share the part before the dot.
struct Entry {
  std::string group;
  std::vector<std::string> pairs;

  std::string text() const {
    std::string const inner = fmt::format("{}", fmt::join(pairs, ", "));
    return group.empty() ? inner : json_string(group) + ": {" + inner + "}";
  }
};

std::string json_row(Estimates const& row) {
  std::vector<Entry> entries;
  for (auto const& field : fields) {
    auto const [group, key] = split(field.key);
    if (group.empty() || entries.back().group != group) entries.push_back({group, {}});
    entries.back().pairs.push_back(json_string(key) + ": " + std::visit(AsJson{}, field.of(row)));
  }
  std::vector<std::string> lines;
  for (auto const& entry : entries) lines.push_back("    " + entry.text());
  return fmt::format("  {{\n{}\n  }}", fmt::join(lines, ",\n"));
}

std::string csv_heading(Field const& field) {
  std::string name = field.key;
  std::replace(name.begin(), name.end(), '.', '_');
  bool const interval = std::holds_alternative<Interval>(field.of(Estimates{}));
  return interval ? name + "_low," + name + "_high" : name;
}

template <class Text>
std::string csv_line(Text text) {
  std::vector<std::string> values;
  for (auto const& field : fields) values.push_back(text(field));
  return fmt::format("{}\n", fmt::join(values, ","));
}

}  // namespace

std::string fields_as_json(std::vector<Estimates> const& rows) {
  std::string text = "[";
  for (auto const& row : rows) text += (text.size() > 1 ? ",\n" : "\n") + json_row(row);
  return text + "\n]\n";
}

std::string fields_as_csv(std::vector<Estimates> const& rows) {
  std::string text = csv_line(csv_heading);
  for (auto const& row : rows) text += csv_line([&](Field const& field) { return std::visit(AsCsv{}, field.of(row)); });
  return text;
}

}  // namespace brouwer
