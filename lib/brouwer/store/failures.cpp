#include <brouwer/store/failures.hpp>

#include <algorithm>

namespace brouwer {
namespace {

/// One more member that failed for this reason; reasons in the order in which they are first met.
void count(std::vector<Failures>& failures, Fate const& fate) {
  auto same = std::find_if(failures.begin(), failures.end(), [&](auto const& f) { return f.reason == fate.reason; });
  if (same == failures.end()) same = failures.insert(same, {fate.reason, 0, fate.failed_at});
  ++same->members;
  if (fate.failed_at >= 0 && (same->first_step < 0 || fate.failed_at < same->first_step))
    same->first_step = fate.failed_at;
}

}  // namespace

std::vector<Fate> fates_of(UnitRecord const& header, std::int64_t members) {
  std::vector<Fate> fates(static_cast<std::size_t>(members));
  auto const recorded = std::min(fates.size(), header.failed_at.size());
  for (std::size_t i = 0; i < recorded; ++i) fates[i] = {header.failed_at[i], header.failure[i]};
  return fates;
}

std::vector<Failures> drop_failed(ErrorMatrix& errors, std::span<Fate const> fates, std::vector<std::string>& names) {
  std::vector<Failures> failures;
  Eigen::Index kept = 0;
  for (Eigen::Index member = 0; member < errors.rows(); ++member) {
    auto const& fate = fates[static_cast<std::size_t>(member)];
    if (fate.failed_at >= 0 || !errors.row(member).allFinite()) {
      count(failures, fate);
      continue;
    }
    if (kept < member) {
      errors.row(kept) = errors.row(member);
      names[static_cast<std::size_t>(kept)] = std::move(names[static_cast<std::size_t>(member)]);
    }
    ++kept;
  }
  if (kept < errors.rows()) errors.conservativeResize(kept, Eigen::NoChange);
  names.resize(static_cast<std::size_t>(kept));
  std::stable_sort(failures.begin(), failures.end(),
                   [](auto const& a, auto const& b) { return a.members > b.members; });
  return failures;
}

}  // namespace brouwer
