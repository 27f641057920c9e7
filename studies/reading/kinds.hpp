#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "studies/reading/toml.hpp"

namespace brouwer {

/// A kind of value in a study file: what is expected there, in words, and how it is read.
/// `read` gives nothing where a node is not of the kind, and throws InputError where it can say better why.
template <class T>
struct Kind {
  std::string expected;
  std::function<std::optional<T>(toml::node const&)> read;
};

Kind<std::string> text();
Kind<bool> flag();

/// A whole number in [low, high]; 1e6 counts as one, 1.5 does not.
Kind<std::int64_t> whole(std::int64_t low, std::int64_t high);

/// A finite number; one > 0; one in (low, high].
Kind<double> number();
Kind<double> positive();
Kind<double> above_up_to(double low, double high);

/// Exactly `size` finite numbers; where size is 1, without brackets too.
Kind<std::vector<double>> numbers(std::size_t size);

/// One of the known words; another is complained about with the nearest ("there is no method 'x'; did you …").
Kind<std::string> one_of(std::string what, std::vector<std::string> known);

/// A value as it stands in a file, shortened, for messages.
std::string shown(toml::node const& node);

}  // namespace brouwer
