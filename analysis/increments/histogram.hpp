#pragma once
#include <cstddef>
#include <vector>

namespace brouwer {

/// Density of standardised values in equal bins from −4 to 4: beside a normal law's exp(−z²/2)/√(2π). An odd number of
/// bins, so that one is centred on 0; what lies beyond ±4 counts in the outermost.
class Histogram {
 public:
  /// @param size  how many values there will be. Bins by Rice's rule, 2 n^⅓, for the part of the axis that holds nearly
  ///              all of a normal sample: 9 … 81
  explicit Histogram(std::size_t size);

  /// Counts a value; NaN is not counted.
  void add(double z);
  /// Counts what another of the same size has counted.
  void add(Histogram const& other);

  std::size_t bins() const { return counts_.size(); }
  double width() const { return 8.0 / static_cast<double>(bins()); }
  double centre(std::size_t bin) const { return -4 + width() * (static_cast<double>(bin) + 0.5); }
  /// Of the values counted so far; 0 in every bin where there are none.
  std::vector<double> density() const;

 private:
  std::vector<double> counts_;
  double total_ = 0;
};

}  // namespace brouwer
