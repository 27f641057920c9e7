#include "analysis/multiplicity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <brouwer/error.hpp>
#include <brouwer/spelling.hpp>
#include <cmath>

namespace brouwer {
namespace {

struct Named {
  Correction correction;
  char const* name;
};
constexpr std::array<Named, 3> corrections = {
    {{Correction::none, "none"}, {Correction::holm, "holm"}, {Correction::fdr, "fdr"}}};

/// Indices of the tests, the smallest p first.
std::vector<std::size_t> ordered(std::vector<double> const& p) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < p.size(); ++i)
    if (!std::isnan(p[i])) order.push_back(i);
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return p[a] < p[b]; });
  return order;
}

/// Down from the smallest p: each stands among those that are left.
std::vector<double> holm(std::vector<double> p) {
  auto const order = ordered(p);
  double bound = 0;
  for (std::size_t j = 0; j < order.size(); ++j) {
    bound = std::max(bound, static_cast<double>(order.size() - j) * p[order[j]]);
    p[order[j]] = std::min(bound, 1.0);
  }
  return p;
}

/// Up from the largest p: a test may call on all that are larger.
std::vector<double> benjamini_hochberg(std::vector<double> p) {
  auto const order = ordered(p);
  double bound = 1;
  for (std::size_t j = order.size(); j-- > 0;) {
    bound = std::min(bound, static_cast<double>(order.size()) * p[order[j]] / static_cast<double>(j + 1));
    p[order[j]] = bound;
  }
  return p;
}

}  // namespace

std::string to_string(Correction correction) {
  return std::find_if(corrections.begin(), corrections.end(),
                      [&](Named const& n) { return n.correction == correction; })
      ->name;
}

std::vector<std::string> correction_names() {
  std::vector<std::string> names;
  for (auto const& named : corrections) names.emplace_back(named.name);
  return names;
}

Correction correction_of(std::string const& name) {
  for (auto const& named : corrections)
    if (name == named.name) return named.correction;
  throw InputError(fmt::format("there is no correction '{}'{}", name, suggestion(name, correction_names())));
}

std::vector<double> adjusted(std::vector<double> const& p, Correction correction) {
  switch (correction) {
    case Correction::holm:
      return holm(p);
    case Correction::fdr:
      return benjamini_hochberg(p);
    case Correction::none:
      break;
  }
  return p;
}

}  // namespace brouwer
