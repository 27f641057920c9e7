#include "analysis/probe/probe_table.hpp"

#include <fmt/format.h>

#include <cmath>

#include "analysis/escape.hpp"
#include "analysis/numbers.hpp"

namespace brouwer {
namespace {

std::string line(char const* what, std::string const& predicted, std::string const& observed) {
  std::string text = fmt::format("  {} predicted {}", left_aligned(what, 16), left_aligned(predicted, 28));
  if (!observed.empty()) text += " observed " + observed;
  return text.substr(0, text.find_last_not_of(' ') + 1) + '\n';
}

std::string one_step_line(LocalEstimates const& local) {
  auto const& law = local.rounding;
  std::string text = fmt::format("  {} rounding: bias {} (t = {}), RMS {}", left_aligned("one step", 16),
                                 bias_in_words(law), number(law.bias.t, 2), number(law.size, 2));
  if (!law.autocorrelation.empty()) text += fmt::format(", ρ₁ {}", number(law.autocorrelation.front(), 2));
  if (local.both)
    text += fmt::format("; the method: bias {}, RMS {}", bias_in_words(*local.truncation),
                        number(local.truncation->size, 2));
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

}  // namespace

std::string probe_text(std::vector<ProbedRow> const& rows) {
  std::string text;
  for (auto const& row : rows) text += block(row);
  return text;
}

}  // namespace brouwer
