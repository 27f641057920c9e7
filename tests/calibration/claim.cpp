#include "tests/calibration/claim.hpp"

#include <algorithm>

namespace brouwer::calibration {
namespace {

using Answer = std::optional<bool>;
using Names = std::vector<std::string>;

constexpr auto coverage = Nominal::Side::coverage;
constexpr auto false_alarm = Nominal::Side::false_alarm;
constexpr auto power = Nominal::Side::power;

Answer covers(Interval interval, std::optional<double> truth) {
  if (!truth) return {};
  return interval.low <= *truth && *truth <= interval.high;
}

/// Members are independent and their errors normal: the laws of β and t are exact whatever else grows or does not.
Names const normal_slopes = {"walk", "drift",   "visible drift", "slopes",  "noise",
                             "all",  "bounded", "strong drift",  "AR +0.3", "AR −0.3"};
Names const no_drift = {"walk", "slopes", "noise",   "bounded", "AR +0.3",   "AR −0.3",    "t(5)",
                        "t(3)", "skewed", "unequal", "wild",    "transient", "oscillation"};
Names const brownian = {"walk", "drift", "visible drift", "strong drift"};
Names const brownian_or_slopes = {"walk", "drift", "visible drift", "strong drift", "slopes"};
Names const no_slopes = {"walk", "drift", "visible drift", "strong drift", "noise", "AR +0.3",   "AR −0.3",
                         "t(5)", "t(3)",  "skewed",        "unequal",      "wild",  "transient", "oscillation"};

std::vector<Claim> const all = {
    {"95 % interval of β",
     {0.95, 0, coverage},
     [](Trial const& t) { return covers(t.estimates.drift.interval, t.truth.drift); },
     {},
     normal_slopes},
    {"95 % interval of σ",
     {0.95, 0, coverage},
     [](Trial const& t) { return covers(t.estimates.diffusion.interval, t.truth.diffusion); },
     {},
     brownian_or_slopes},
    {"95 % interval of q",
     {0.95, 0.025, coverage},
     [](Trial const& t) { return covers(t.estimates.growth.interval, t.truth.time_exponent); },
     {},
     {"walk", "bounded", "sweep"},
     4},
    {"95 % interval of p in a sweep",
     {0.95, 0.025, coverage},
     [](Trial const& t) { return t.sweep ? covers(t.sweep->step_interval, t.truth.step_exponent) : Answer(); },
     {},
     {"sweep"},
     4},
    {"95 % interval of q in a sweep",
     {0.95, 0.025, coverage},
     [](Trial const& t) { return t.sweep ? covers(t.sweep->time_interval, t.truth.time_exponent) : Answer(); },
     {},
     {"sweep"},
     4},
    {"drift where there is none, p < 0.05",
     {0.05, 0, false_alarm},
     [](Trial const& t) { return Answer(t.estimates.drift.p < 0.05); },
     no_drift,
     normal_slopes},
    {"drift where there is none, p < 0.001",
     {0.001, 0, false_alarm},
     [](Trial const& t) { return Answer(t.estimates.drift.p < 0.001); },
     no_drift,
     normal_slopes,
     2,
     true},
    {"slopes where there are none, p of F < 0.05",
     {0.05, 0, false_alarm},
     [](Trial const& t) { return Answer(t.estimates.persistence.p < 0.05); },
     no_slopes,
     brownian},
    {"slopes where there are none, p of F < 0.001",
     {0.001, 0, false_alarm},
     [](Trial const& t) { return Answer(t.estimates.persistence.p < 0.001); },
     no_slopes,
     brownian,
     2,
     true},
    {"F too small for a walk, p < 0.05",
     {0.05, 0, false_alarm},
     [](Trial const& t) { return Answer(t.estimates.persistence.p_low < 0.05); },
     no_slopes,
     brownian},
    {"verdict 'drift' of a walk",
     {0.001, 0, false_alarm},
     [](Trial const& t) { return Answer(t.estimates.verdict == Verdict::drift); },
     no_drift,
     {"walk", "slopes", "noise"},
     2,
     true},
    {"the smallest visible drift is seen, p < 0.001",
     {0.9, 0.003, power},
     [](Trial const& t) { return Answer(t.estimates.drift.p < 0.001); },
     {"visible drift"},
     {"visible drift"}},
};

bool contains(Names const& names, Model const& model) {
  return std::find(names.begin(), names.end(), model.name) != names.end();
}

}  // namespace

std::span<Claim const> claims() { return all; }

bool is_asked(Claim const& claim, Model const& model) {
  return claim.asked_of.empty() || contains(claim.asked_of, model);
}

bool is_promised(Claim const& claim, Model const& model, Design const& design) {
  return contains(claim.promised_for, model) && design.members >= claim.fewest_members;
}

}  // namespace brouwer::calibration
