#pragma once
#include <brouwer/store/results.hpp>
#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "analysis/files/csv_lines.hpp"

namespace brouwer {

/// Lets a map of strings be searched with a view, without a copy.
struct TextHash {
  using is_transparent = void;
  std::size_t operator()(std::string_view text) const { return std::hash<std::string_view>{}(text); }
};

/// Numbers members in order of appearance. What it has seen costs no allocation, and no search where members come in
/// the same order again or one after the other.
class MemberIndex {
 public:
  std::uint32_t operator()(std::string_view name) {
    for (std::uint32_t const guess : {last_, last_ + 1, 0u})
      if (guess < names_.size() && names_[guess] == name) return last_ = guess;
    auto const found = index_.find(name);
    if (found != index_.end()) return last_ = found->second;
    last_ = static_cast<std::uint32_t>(names_.size());
    names_.emplace_back(name);
    index_.emplace(name, last_);
    return last_;
  }
  std::vector<std::string> const& names() const { return names_; }

 private:
  std::unordered_map<std::string, std::uint32_t, TextHash, std::equal_to<>> index_;
  std::vector<std::string> names_;
  std::uint32_t last_ = 0;
};

/// Numbers times in order of appearance.
class TimeIndex {
 public:
  std::uint32_t operator()(double time) {
    auto const [entry, is_new] = index_.try_emplace(time, static_cast<std::uint32_t>(times_.size()));
    if (is_new) times_.push_back(time);
    return entry->second;
  }
  std::vector<double> const& times() const { return times_; }

 private:
  std::unordered_map<double, std::uint32_t> index_;
  std::vector<double> times_;
};

/// The errors of one ensemble, one at a time and in any order, until they make a matrix.
class LongTable {
 public:
  explicit LongTable(Ensemble labelled) : ensemble_(std::move(labelled)) {}

  void add(std::string_view member, double time, double error, std::int64_t line) {
    observations_.push_back({error, members_(member), times_(time), line});
  }

  /// The matrix in order of members and times, once every place is known to be filled exactly once. Ends the table.
  /// @throws InputError for a hole, a duplicate, a single member or time
  Ensemble finish(CsvLines const& lines);

 private:
  struct Observation {
    double error;
    std::uint32_t member, time;  // as numbered by the indices
    std::int64_t line;
  };

  void fill(CsvLines const& lines);
  [[noreturn]] void complain_of_a_hole(CsvLines const& lines) const;
  [[noreturn]] void complain_of_a_duplicate(CsvLines const& lines, Observation const& again) const;
  std::string of() const;  ///< " of 'energy'"

  Ensemble ensemble_;
  std::deque<Observation> observations_;  // grows without copying
  MemberIndex members_;
  TimeIndex times_;
};

}  // namespace brouwer
