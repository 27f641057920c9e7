#include <brouwer/store/provenance.hpp>

#include <Eigen/Core>
#include <algorithm>
#include <boost/version.hpp>
#include <ctime>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fstream>
#include <gnu/libc-version.h>
#include <gsl/gsl_version.h>
#include <mpfr.h>
#include <sys/utsname.h>
#include <zlib.h>

#include <brouwer/store/hdf5.hpp>

namespace brouwer {
namespace {

std::string hdf5_version() {
  hdf5::Session const session;
  unsigned major = 0, minor = 0, release = 0;
  H5get_libversion(&major, &minor, &release);
  return fmt::format("{}.{}.{}", major, minor, release);
}

std::string compiler() {
#ifdef __clang__
  return __VERSION__;
#else
  return "g++ " __VERSION__;
#endif
}

/// The first line of /proc/cpuinfo that begins with one of these keys (x86 and ARM name them differently).
std::string cpuinfo(std::initializer_list<char const*> keys) {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    for (auto const* key : keys)
      if (line.starts_with(key)) return line.substr(std::min(line.size(), line.find(':') + 2));
  return "unknown";
}

/// Of all that the CPU can do, what decides the bits of glibc's elementary functions.
std::string instruction_sets() {
  auto const flags = fmt::format(" {} ", cpuinfo({"flags", "Features"}));
  std::vector<std::string> present;
  for (auto const* set : {"sse2", "avx", "avx2", "fma", "fma4", "avx512f", "asimd", "sve"})
    if (flags.find(fmt::format(" {} ", set)) != std::string::npos) present.emplace_back(set);
  return fmt::format("{}", fmt::join(present, " "));
}

std::string kernel() {
  utsname name = {};
  ::uname(&name);
  return fmt::format("{} {} {}", name.sysname, name.release, name.machine);
}

}  // namespace

Provenance provenance(int threads) {
  return {{
      {"brouwer", BROUWER_VERSION},
      {"compiler", compiler()},
      {"flags", BROUWER_FLAGS},
      {"boost", fmt::format("{}.{}.{}", BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000, BOOST_VERSION % 100)},
      {"eigen", fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
      {"gsl", gsl_version},
      {"hdf5", hdf5_version()},
      {"mpfr", mpfr_get_version()},
      {"zlib", zlibVersion()},
      {"glibc", gnu_get_libc_version()},
      {"cpu", cpuinfo({"model name", "CPU part"})},
      {"instruction sets", instruction_sets()},
      {"kernel", kernel()},
      {"threads", std::to_string(threads)},
      {"date", fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)))},
  }};
}

std::string to_text(Provenance const& provenance) {
  std::string text;
  for (auto const& [key, value] : provenance.entries) text += fmt::format("{} = {}\n", key, value);
  return text;
}

}  // namespace brouwer
