#include "analysis/files/foreign_ensembles.hpp"

#include <fmt/format.h>

#include <brouwer/error.hpp>

namespace brouwer {

void require_an_ensemble(Ensemble const& ensemble, std::string const& where, std::string const& of) {
  if (ensemble.errors.rows() < 2)
    throw InputError(fmt::format("{}: {}{} only: the statistics compare members, at least 2 are needed", where,
                                 ensemble.errors.rows() == 1 ? "one member" : "no member", of));
  if (ensemble.errors.cols() < 2)
    throw InputError(fmt::format("{}: {}{}: a law of growth needs errors at 2 or more times above 0", where,
                                 ensemble.errors.cols() == 1 ? "one sample time only" : "no sample time", of));
}

}  // namespace brouwer
