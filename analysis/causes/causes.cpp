#include "analysis/causes/causes.hpp"

#include <algorithm>

#include "analysis/causes/cause_in_words.hpp"
#include "analysis/causes/evidence.hpp"
#include "analysis/causes/remainder.hpp"

namespace brouwer {
namespace {

struct CauseName {
  Cause cause;
  char const* name;
};
constexpr CauseName names[] = {
    {Cause::none_seen, "none seen"},
    {Cause::truncation, "truncation error"},
    {Cause::rounding_mode, "rounding mode"},
    {Cause::constants, "rounded constants"},
    {Cause::repeated_rounding, "repeated rounding"},
    {Cause::constants_or_rounding, "rounded constants under repeated rounding"},
    {Cause::constants_and_rounding, "rounded constants, and repeated rounding"},
    {Cause::needs_constants, "rounded constants, perhaps under repeated rounding"},
    {Cause::needs_rounding, "repeated rounding, perhaps of rounded constants"},
    {Cause::coefficients, "coefficients"},
    {Cause::functions, "functions"},
    {Cause::summation, "summation"},
    {Cause::contraction, "products"},
    {Cause::unnamed, "unnamed"},
    {Cause::round_off, "round-off"},
    {Cause::not_resolved, "not resolved"},
};

/// A line of the table in causes.hpp.
struct Rule {
  Cause cause;
  bool (*applies)(Evidence const&);
};

bool gone(Evidence const& e, Change change) { return e.remainder(change) == Remainder::gone; }
bool there(Evidence const& e, Change change) { return e.remainder(change) == Remainder::there; }
bool is_there_with_either(Evidence const& e) {
  return there(e, Change::constants) && there(e, Change::unbiased_rounding);
}

constexpr Rule rules[] = {
    {Cause::truncation, [](Evidence const& e) { return there(e, Change::higher_precision); }},
    {Cause::rounding_mode, [](Evidence const& e) { return gone(e, Change::nearest_for_directed); }},
    {Cause::constants_or_rounding,
     [](Evidence const& e) { return gone(e, Change::constants) && gone(e, Change::unbiased_rounding); }},
    {Cause::constants,
     [](Evidence const& e) { return gone(e, Change::constants) && there(e, Change::unbiased_rounding); }},
    {Cause::repeated_rounding,
     [](Evidence const& e) { return there(e, Change::constants) && gone(e, Change::unbiased_rounding); }},
    {Cause::needs_constants, [](Evidence const& e) { return gone(e, Change::constants); }},
    {Cause::needs_rounding, [](Evidence const& e) { return gone(e, Change::unbiased_rounding); }},
    {Cause::constants_and_rounding,
     [](Evidence const& e) { return is_there_with_either(e) && gone(e, Change::constants_and_rounding); }},
    {Cause::coefficients, [](Evidence const& e) { return gone(e, Change::coefficients); }},
    {Cause::functions, [](Evidence const& e) { return gone(e, Change::functions); }},
    {Cause::summation, [](Evidence const& e) { return gone(e, Change::sum); }},
    {Cause::contraction, [](Evidence const& e) { return gone(e, Change::products); }},
    {Cause::unnamed,
     [](Evidence const& e) {
       return is_there_with_either(e) && there(e, Change::constants_and_rounding) && gone(e, Change::higher_precision);
     }},
    {Cause::round_off, [](Evidence const& e) { return gone(e, Change::higher_precision); }},
    {Cause::not_resolved, [](Evidence const&) { return true; }},
};

bool drifts(Estimates const& e) {
  return (e.verdict == Verdict::drift || e.verdict == Verdict::faster_than_drift) && e.drift.p < e.levels.test;
}

Subject subject_of(Explanation const& e) {
  if (drifts(e.nominal)) return Subject::drift;
  if (e.nominal.verdict == Verdict::persistent_slopes) return Subject::slopes;
  bool const of_method = Evidence(e, Subject::size).remainder(Change::higher_precision) == Remainder::there;
  return of_method ? Subject::size : Subject::nothing;
}

}  // namespace

std::string to_string(Cause cause) {
  return std::find_if(std::begin(names), std::end(names), [&](auto const& n) { return n.cause == cause; })->name;
}

std::string to_string(Subject subject) {
  switch (subject) {
    case Subject::drift:
      return "drift";
    case Subject::slopes:
      return "slopes";
    case Subject::size:
      return "size";
    case Subject::nothing:
      return "nothing";
  }
  return "";
}

Share const& left_of(ComparedCell const& cell, Subject subject) {
  if (subject == Subject::slopes) return cell.slopes_left;
  return subject == Subject::size ? cell.size_left : cell.drift_left;
}

void name_cause(Explanation& e) {
  e.subject = subject_of(e);
  e.cause = Cause::none_seen;
  if (e.subject != Subject::nothing) {
    Evidence const evidence(e, e.subject);
    e.cause =
        std::find_if(std::begin(rules), std::end(rules), [&](Rule const& r) { return r.applies(evidence); })->cause;
  }
  e.sentence = cause_in_words(e);
}

}  // namespace brouwer
