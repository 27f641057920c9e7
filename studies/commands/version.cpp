#include <H5public.h>
#include <fmt/format.h>
#include <gmp.h>
#include <gsl/gsl_version.h>
#include <mpfr.h>

#include <Eigen/Core>
#include <boost/version.hpp>

#include "studies/commands/command_line.hpp"
#include "studies/reading/toml.hpp"

namespace brouwer {

std::string version_text() {
  std::string text = fmt::format("brouwer {}\n", BROUWER_VERSION);
  auto const add = [&](auto const& library, auto const& version) {
    text += fmt::format("  {:<8} {}\n", library, version);
  };
  add("compiler", __VERSION__);
  add("Eigen", fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION));
  add("Boost", fmt::format("{}.{}.{}", BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000, BOOST_VERSION % 100));
  add("GSL", gsl_version);
  add("MPFR", mpfr_get_version());
  add("GMP", gmp_version);
  add("HDF5", fmt::format("{}.{}.{}", H5_VERS_MAJOR, H5_VERS_MINOR, H5_VERS_RELEASE));
  add("toml++", fmt::format("{}.{}.{}", TOML_LIB_MAJOR, TOML_LIB_MINOR, TOML_LIB_PATCH));
  add("CLI11", CLI11_VERSION);
  add("fmt", fmt::format("{}.{}.{}", FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100));
  text.pop_back();
  return text;
}

}  // namespace brouwer
