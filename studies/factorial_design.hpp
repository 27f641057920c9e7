#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "studies/read.hpp"

namespace brouwer {

/// A part of a design, which is a study of its own and has a folder of its own.
struct DesignPart {
  std::string name;  ///< of its folder: "operations", "rounding", "coefficients", "higher-precision" …
  StudyFile study;
};

/// The cells by which a drift is explained: the nominal ones, and those in which the arithmetic is otherwise.
struct FactorialDesign {
  std::vector<DesignPart> parts;
  std::vector<CellLabels> nominal;    ///< one for each method and step of the study
  std::vector<std::string> left_out;  ///< parts of which no cell exists, and what is not observed in them: reasons
};

/// "constants, rounding, compensation, contraction, coefficients, special_functions, precision"
std::vector<std::string> const& design_factors();

/// A design around a study. Of every factor of the arithmetic the nominal level is the first that the study has; of the sum,
/// the first that the method has: methods without an increment are in parts of their own ("operations-plain" …) where the
/// others are compensated.
///
///     operations          2³: constants rounded, exact × rounding nominal, stochastic × plain, compensated sums
///     rounding            the other roundings: nearest, up, down, toward-zero
///     contraction, coefficients, special-functions     the other levels of that factor alone
///     lower-, higher-precision   the next arithmetic: float, double, double-double, mpfr-256, mpfr-512
///
/// In other arithmetics operations are the standard ones, and functions our own where there are no others. Where a reference
/// has too few bits for higher precision, quantities that need it are not observed there.
/// @param factors  those that are changed; all where empty
/// @throws InputError as read_study does; for a factor that does not exist, with the nearest; where only counts are observed
FactorialDesign design_around(std::filesystem::path const& file, Catalogue const& catalogue,
                              std::vector<Override> const& overrides, std::vector<std::string> const& factors);

/// Do both differ in nothing but the arithmetic: the same start and the same steps of one method?
bool same_question(CellLabels const& a, CellLabels const& b);

}  // namespace brouwer
