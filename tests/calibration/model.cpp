#include "tests/calibration/model.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "tests/calibration/philox.hpp"

namespace brouwer::calibration {
namespace {

/// The unit of errors: what a walk of 2e-16 per √step has spread to at the end.
constexpr double spread = 2e-14;

constexpr double wild_share = 0.01, wild_factor = 30;

double student_3(gsl_rng* rng) { return gsl_ran_tdist(rng, 3) * std::sqrt(1.0 / 3); }
double uniform(gsl_rng* rng) { return gsl_rng_uniform(rng); }
double skewed(gsl_rng* rng) { return gsl_ran_exponential(rng, 1) - 1; }

void make_some_wild(Ensemble& ensemble, Normal& normal) {
  for (auto row : ensemble.errors.rowwise())
    if (normal(uniform) < wild_share) row *= wild_factor;
}

/// Adds a function of the share of the run that is over, the same for all members.
template <class Function>
void add_shared(Ensemble& ensemble, Function const& of_time) {
  for (Eigen::Index j = 0; j < ensemble.errors.cols(); ++j)
    ensemble.errors.col(j).array() += spread * of_time(ensemble.times[static_cast<std::size_t>(j)] / duration);
}

void begin_with_a_transient(Ensemble& ensemble, Normal&) {
  add_shared(ensemble, [](double t) { return 0.5 * -std::expm1(-t / 0.01); });
}

void oscillate_together(Ensemble& ensemble, Normal&) {
  add_shared(ensemble, [](double t) { return std::sin(2 * std::numbers::pi * 37.3 * t); });
}

/// x(t) − x(0) of a wave of random phase, its number of periods in a run log-uniform between two bounds.
void add_wave(Ensemble& ensemble, Normal& normal, double fewest, double most) {
  double const periods = fewest * std::pow(most / fewest, normal(uniform));
  double const phase = 2 * std::numbers::pi * normal(uniform);
  add_shared(ensemble,
             [&](double t) { return std::sin(2 * std::numbers::pi * periods * t + phase) - std::sin(phase); });
}

void oscillate_slowly(Ensemble& ensemble, Normal& normal) { add_wave(ensemble, normal, 1, 10); }
void oscillate_fast(Ensemble& ensemble, Normal& normal) { add_wave(ensemble, normal, 10, 1000); }

std::vector<Model> const all = {
    {.name = "walk", .words = "σ = 1: Brownian motion", .law = {.diffusion = 1}, .time_exponent = 0.5},
    {.name = "drift", .words = "… and β = ½", .law = {.drift = 0.5, .diffusion = 1}},
    {.name = "visible drift",
     .words = "… and β = the smallest visible drift of so many members",
     .law = {.diffusion = 1},
     .visible_drift = true},
    {.name = "slopes", .words = "… and τ = 1", .law = {.persistence = 1, .diffusion = 1}},
    {.name = "noise", .words = "… and ν = 0.1", .law = {.diffusion = 1, .noise = 0.1}},
    {.name = "all", .words = "… and β = ½, τ = 1, ν = 0.1", .law = {0.5, 1, 1, 0.1}},
    {.name = "bounded", .words = "ν = 1, nothing else", .law = {.noise = 1}, .time_exponent = 0},
    {.name = "strong drift", .words = "… and β = 30", .law = {.drift = 30, .diffusion = 1}},
    {.name = "phase",
     .words = "the time integral of the walk",
     .law = {.diffusion = 1, .phase = true},
     .hostile = true},
    {.name = "t(5)",
     .words = "increments of Student's t(5)",
     .law = {.diffusion = 1, .shape = student_5},
     .time_exponent = 0.5,
     .hostile = true},
    {.name = "t(3)",
     .words = "increments of Student's t(3): no fourth moment",
     .law = {.diffusion = 1, .shape = student_3},
     .time_exponent = 0.5,
     .hostile = true},
    {.name = "skewed",
     .words = "increments exponential, centred: skewness 2",
     .law = {.diffusion = 1, .shape = skewed},
     .time_exponent = 0.5,
     .hostile = true},
    {.name = "AR +0.3",
     .words = "each increment correlated with the next by 0.3",
     .law = {.diffusion = 1, .correlation = 0.3},
     .hostile = true},
    {.name = "AR −0.3", .words = "… by −0.3", .law = {.diffusion = 1, .correlation = -0.3}, .hostile = true},
    {.name = "unequal",
     .words = "each member its own σᵢ, log-normal: a factor of 1.6 (one standard deviation)",
     .law = {.diffusion = 1, .inequality = 0.5},
     .time_exponent = 0.5,
     .hostile = true},
    {.name = "wild",
     .words = "1 % of the members with thirty times the error",
     .law = {.diffusion = 1},
     .time_exponent = 0.5,
     .hostile = true,
     .spoil = make_some_wild},
    {.name = "transient",
     .words = "all members gain ½ in the first hundredth of the run",
     .law = {.diffusion = 1},
     .hostile = true,
     .spoil = begin_with_a_transient},
    {.name = "oscillation",
     .words = "all members share sin(2π·37.3 t), as of a truncation error",
     .law = {.diffusion = 1},
     .hostile = true,
     .spoil = oscillate_together},
    {.name = "slow wave",
     .words = "… sin(2πft + φ) − sin φ, φ random, f log-uniform from 1 to 10",
     .law = {.diffusion = 1},
     .hostile = true,
     .spoil = oscillate_slowly},
    {.name = "fast wave",
     .words = "… f from 10 to 1000",
     .law = {.diffusion = 1},
     .hostile = true,
     .spoil = oscillate_fast},
    {.name = "drift + wave",
     .words = "… beside β = 30",
     .law = {.drift = 30, .diffusion = 1},
     .hostile = true,
     .spoil = oscillate_fast},
    {.name = "wave of all",
     .words = "fast wave and all: β = ½, τ = 1, ν = 0.1",
     .law = {0.5, 1, 1, 0.1},
     .hostile = true,
     .spoil = oscillate_fast},
    {.name = "t(3) + noise",
     .words = "increments of Student's t(3), and ν = 0.1",
     .law = {.diffusion = 1, .noise = 0.1, .shape = student_3},
     .hostile = true},
    {.name = "unequal + noise",
     .words = "each member its own σᵢ, and ν = 0.1",
     .law = {.diffusion = 1, .noise = 0.1, .inequality = 0.5},
     .hostile = true},
    {.name = "sweep",
     .words = "walks at h = 0.01, 0.03, 0.1 with σ ∝ h per √step, members sharing part of their path",
     .law = {.diffusion = 1},
     .time_exponent = 0.5,
     .steps = {0.01, 0.03, 0.1}},
};

/// FNV-1a, so that a model or a design keeps its numbers when others come and go.
std::uint32_t hash(std::string const& text) {
  std::uint32_t value = 2166136261U;
  for (char const c : text) value = (value ^ static_cast<unsigned char>(c)) * 16777619U;
  return value;
}

Normal source(Model const& model, Design const& design, std::uint32_t number) {
  std::uint64_t const experiment = hash(std::string(model.name) + "/" + design.name());
  return Normal(experiment << 32 | number, philox());
}

/// The law of a design in steps and absolute errors.
Law law_of(Model const& model, Design const& design) {
  Law law = model.law;
  if (model.visible_drift) {
    auto const members = static_cast<double>(design.members);
    law.drift = visible_noncentrality(members - 1, {}) / std::sqrt(members);
  }
  law.drift *= spread / duration;
  law.persistence *= spread / duration;
  law.diffusion *= spread / std::sqrt(duration);
  law.noise *= spread;
  return law;
}

Truth truth_of(Model const& model, Design const& design) {
  Law const law = law_of(model, design);
  Truth truth;
  truth.drift = law.drift;
  truth.time_exponent = model.time_exponent;
  if (!model.steps.empty()) truth.step_exponent = 0.5;
  if (law.phase || truth.step_exponent) return truth;
  truth.persistence = law.persistence;
  truth.noise = law.noise;
  double const rho = law.correlation;  // sums of correlated increments spread as a walk of this σ
  truth.diffusion = law.diffusion * std::sqrt((1 + rho) / (1 - rho));
  return truth;
}

std::vector<Ensemble> cells_of(Model const& model, Design const& design, std::uint32_t number) {
  auto normal = source(model, design, number);
  Law const law = law_of(model, design);
  if (!model.steps.empty()) return swept(law, 1, model.steps, design.members, design.times(), normal);
  std::vector<Ensemble> cells = {simulated(law, design.members, design.times(), normal)};
  if (model.spoil) model.spoil(cells[0], normal);
  return cells;
}

}  // namespace

std::span<Model const> models() { return all; }

Model const& model(std::string const& name) {
  auto const found = std::find_if(all.begin(), all.end(), [&](Model const& m) { return m.name == name; });
  if (found == all.end()) throw std::out_of_range("there is no model " + name);
  return *found;
}

Trial trial(Model const& model, Design const& design, std::uint32_t number) {
  auto const cells = cells_of(model, design, number);
  Trial trial{truth_of(model, design), estimate(cells[0], {}), {}};
  if (cells.size() > 1) trial.sweep = fit_sweep(cells, {});
  return trial;
}

Ensemble ensemble_of(Model const& model, Design const& design, std::uint32_t number) {
  return cells_of(model, design, number)[0];
}

}  // namespace brouwer::calibration
