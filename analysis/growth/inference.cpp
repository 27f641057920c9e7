#include "analysis/growth/inference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <brouwer/error.hpp>
#include <cmath>
#include <limits>

#include "analysis/distributions.hpp"
#include "analysis/growth/closed_form.hpp"
#include "analysis/growth/far_off.hpp"
#include "analysis/growth/growth.hpp"
#include "analysis/growth/growth_model.hpp"
#include "analysis/growth/shared_course.hpp"
#include "analysis/growth/tails.hpp"
#include "analysis/growth/transient.hpp"
#include "analysis/increments/increments.hpp"
#include "analysis/student_drift.hpp"
#include "analysis/units.hpp"
#include "analysis/verdict/failures.hpp"
#include "analysis/verdict/verdict.hpp"

namespace brouwer {
namespace {

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

/// Where the increments are not normal, what holds whatever they are (tails.hpp).
void use_tails(Estimates& e, TailInference const& found) {
  e.tails = found.tails;
  if (found.tails.normal) return;
  e.persistence.p = std::max(e.persistence.p, found.p_signs);
  double const dof = static_cast<double>(e.members - 1);
  double const factor = std::exp(found.log_error * student_upper_quantile((1 - e.levels.confidence) / 2, dof));
  e.diffusion.interval = {e.diffusion.per_sqrt_step / factor, e.diffusion.per_sqrt_step * factor};
}

/// The law with noise takes the place of the closed form, if the mean does not contradict it.
void use_model(Estimates& e) {
  e.persistence.interval = {undefined, undefined};
  if (!e.model) return;
  auto const& model = *e.model;
  if (!model.law().terms.noise || noise_in_force(e)) e.persistence.interval = model.slopes;
  if (!noise_in_force(e)) return;
  e.drift = {model.law().drift, model.drift, model.t, model.p, e.drift.share};
  e.persistence.per_step = model.law().slopes;
  e.diffusion = {model.law().diffusion, model.diffusion};
  e.noise = {model.law().noise, model.noise};
  e.smallest_visible_drift = model.standard_error * visible_noncentrality(e.drift_degrees(), e.levels);
}

std::vector<double> to_vector(Eigen::ArrayXd const& x) { return {x.begin(), x.end()}; }

/// Mean over the members with its standard error, and RMS, at every sample time.
void describe_course(Ensemble const& ensemble, double scale, Estimates& e) {
  auto const members = static_cast<double>(ensemble.errors.rows());
  Eigen::RowVectorXd const first = scale * ensemble.errors.row(0);
  Eigen::RowVectorXd off = Eigen::RowVectorXd::Zero(first.size()), squares = off, spread = off;
  for (auto const& row : ensemble.errors.rowwise()) {
    off += scale * row - first;
    squares.array() += (scale * row).array().square();
  }
  Eigen::RowVectorXd const mean = first + off / members;
  for (auto const& row : ensemble.errors.rowwise()) spread.array() += (scale * row - mean).array().square();
  e.mean = to_vector(mean.transpose() / scale);
  e.mean_error = to_vector((spread.array() / (members * (members - 1))).sqrt().transpose() / scale);
  e.rms = to_vector((squares.array() / members).sqrt().transpose() / scale);
  e.rms_final = e.rms.back();
}

Estimates described(Ensemble const& ensemble, Levels const& levels) {
  Estimates e;
  e.cell = ensemble.cell;
  e.quantity = ensemble.quantity;
  e.family = ensemble.family;
  e.unit = ensemble.unit;
  e.time_unit = ensemble.time_unit;
  e.members = ensemble.errors.rows();
  e.samples = ensemble.errors.cols();
  e.failed = ensemble.failed;
  e.failures = ensemble.failures;
  e.times = ensemble.times;
  e.levels = levels;
  return e;
}

/// Nothing that is estimated of a law of growth has a value.
void leave_law_undefined(Estimates& e) {
  Interval const none{undefined, undefined};
  e.smallest_visible_drift = undefined;
  e.drift = {undefined, none, undefined, undefined, undefined};
  e.persistence = {undefined, undefined, undefined, undefined, none};
  e.diffusion = {undefined, none};
  e.growth = {undefined, none};
}

/// A row that says so: the other cells of a study are not to suffer.
Estimates all_failed(Ensemble const& ensemble, Levels const& levels) {
  Estimates e = described(ensemble, levels);
  leave_law_undefined(e);
  e.rms = e.mean = e.mean_error = std::vector<double>(e.times.size(), undefined);
  e.rms_final = undefined;
  if (ensemble.count) e.count = {undefined, {undefined, undefined}};
  auto const why = and_why(e);
  e.sentence = fmt::format("Not resolved: all {} members failed{}; is the step too large for this method?", e.failed,
                           why.empty() ? " (an error that is not a finite number)" : why);
  return e;
}

/// Numbers of something: their mean and how far they reach.
Estimates counted(Ensemble const& ensemble, Levels const& levels) {
  Estimates e = described(ensemble, levels);
  leave_law_undefined(e);
  describe_course(ensemble, exact_scale(largest_magnitude(ensemble.errors)), e);
  e.count = {ensemble.errors.mean(), {ensemble.errors.minCoeff(), ensemble.errors.maxCoeff()}};
  return e;
}

/// The sample that ends the transient.
Eigen::Index last_of(Transient const& transient, Ensemble const& ensemble) {
  auto const& times = ensemble.times;
  return std::find(times.begin(), times.end(), transient.until) - times.begin();
}

bool mean_is_bent(Estimates const& e) { return e.model && (e.transient || e.model->p_course < e.levels.test); }

/// β of what follows the transient, if there is one, with an error that allows for what all members share.
void use_course(Estimates& e, CourseOfMean const& found, Units const& units) {
  Drift const whole = e.drift;
  e.course = {units.size(found.size), units.size(found.reach), found.degrees, whole};
  e.drift = units.rate(student_drift(found.slope, found.error, found.degrees, e.levels.confidence));
  e.drift.share = e.rms_final > 0 ? std::min(1.0, std::abs(e.drift.per_step) * e.times.back() / e.rms_final) : 0;
  if (e.transient) e.transient->after = e.drift;
  for (auto& law : e.model->candidates) law.drift = e.drift.per_step;
  e.model->drift = e.drift.interval;
  e.model->t = e.drift.t;
  e.model->p = e.drift.p;
  e.model->standard_error = units.rate(found.error);
  e.smallest_visible_drift = e.model->standard_error * visible_noncentrality(found.degrees, e.levels);
}

/// σ, τ and ν of how members differ from their mean, which no course of it touches; β of the mean. F goes on to warn of
/// what all share, unless that ends with the transient. Where members do not differ but by rounding, nothing is changed.
Estimates told_apart(Estimates const& e, Ensemble const& ensemble, Units const& units) {
  auto const apart = without_mean(ensemble);
  auto const s = closed_form(apart, units, static_cast<double>(e.members - 1));
  Estimates own = e;
  own.persistence = s.persistence(units);
  own.diffusion = s.diffusion(units, e.levels.confidence);
  own.noise = {};
  use_tails(own, tails_of(apart, units));
  own.model = growth_model(apart, units, e.levels, own.tails, own.persistence.p, MeanCourse::free);
  if (!own.model) return e;
  own.model->p_course = e.model->p_course;
  if (!e.transient) own.persistence = {own.persistence.per_step, e.persistence.F, e.persistence.p, e.persistence.p_low};
  use_course(own, course_of_mean(ensemble, units, e.transient ? last_of(*e.transient, ensemble) : -1), units);
  use_model(own);
  return own;
}

/// β, τ, σ and ν of an ensemble.
Estimates parameters_of(Ensemble const& ensemble, Levels const& levels) {
  auto const units = units_of(ensemble);
  auto const s = closed_form(ensemble, units, static_cast<double>(ensemble.errors.rows()));
  Estimates e = described(ensemble, levels);
  describe_course(ensemble, units.error, e);
  e.drift = s.drift(units, levels.confidence);
  e.drift.share = e.rms_final > 0 ? std::min(1.0, std::abs(e.mean.back()) / e.rms_final) : 0;
  e.persistence = s.persistence(units);
  e.diffusion = s.diffusion(units, levels.confidence);
  e.smallest_visible_drift = units.rate(s.standard_error() * visible_noncentrality(s.members - 1, levels));
  use_tails(e, tails_of(ensemble, units));
  e.transient = transient_of(ensemble, units, levels);
  e.model = growth_model(ensemble, units, levels, e.tails, e.persistence.p);
  use_model(e);
  return mean_is_bent(e) ? told_apart(e, ensemble, units) : e;
}

/// The law of growth of an ensemble, without a verdict.
Estimates law_of(Ensemble const& ensemble, Levels const& levels) {
  Estimates e = parameters_of(ensemble, levels);
  e.growth = growth_of(ensemble, levels.confidence);
  e.increments = increment_tests(ensemble, levels);
  return e;
}

/// The law of all but the members far off, if these are few; both drifts are told.
Estimates law_beside(std::vector<Eigen::Index> const& far_off, Ensemble const& ensemble, Levels const& levels) {
  bool const few = are_few(far_off.size(), ensemble.errors.rows());
  Estimates e = few ? law_of(without(ensemble, far_off), levels) : law_of(ensemble, levels);
  Estimates const all = few ? parameters_of(ensemble, levels) : e;
  e.far_off = {names_of(ensemble, far_off), few, all.drift, all.diffusion};
  return e;
}

Estimates judged(Estimates e) {
  auto judgement = judge(e);
  e.verdict = judgement.verdict;
  e.sentence = std::move(judgement.sentence);
  return e;
}

void require_shape(Ensemble const& ensemble) {
  if (ensemble.errors.rows() < 1)
    throw InputError(fmt::format("{}: no member has finite errors, so there is nothing to analyse", ensemble.quantity));
  if (ensemble.times.empty() || std::ssize(ensemble.times) != ensemble.errors.cols())
    throw InputError(fmt::format("{}: {} sample times for {} columns of errors", ensemble.quantity,
                                 ensemble.times.size(), ensemble.errors.cols()));
}

}  // namespace

double visible_noncentrality(double dof, Levels const& levels) {
  double const critical = student_upper_quantile(levels.test / 2, dof);
  double const z = normal_upper_quantile(1 - levels.power);
  return critical * (1 - 1 / (4 * dof)) + z * std::sqrt(1 + critical * critical / (2 * dof));
}

Estimates estimate(Ensemble const& ensemble, Levels const& levels) {
  if (ensemble.errors.rows() == 0 && ensemble.failed > 0) return all_failed(ensemble, levels);
  require_shape(ensemble);
  if (ensemble.count) return judged(counted(ensemble, levels));
  auto const far_off = far_off_members(ensemble, units_of(ensemble));
  if (far_off.empty()) return judged(law_of(ensemble, levels));
  return judged(law_beside(far_off, ensemble, levels));
}

}  // namespace brouwer
