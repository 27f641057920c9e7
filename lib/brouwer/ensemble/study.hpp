#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace brouwer {

/// How a field of the start (momentum, attitude, inertia …) differs from member to member.
struct Perturbation {
  enum class Law {
    uniform,  ///< x + size·U(−1, 1), absolute
    normal,   ///< x + size·N(0, 1), absolute
    ulps,     ///< x moved by k units in the last place, k uniform on the integers −size … size
  };
  Law law = Law::uniform;
  double size = 0;
  bool operator==(Perturbation const&) const = default;
};

/// What the state is compared with, for the first `members` members.
struct Reference {
  enum class Kind {
    none,
    exact,        ///< the exact flow, evaluated directly at the sample time
    same_method,  ///< the same method from the same start in `arithmetic`: round-off alone
  };
  Kind kind = Kind::none;
  std::string arithmetic;    ///< for same_method: a name of the catalogue
  std::int64_t members = 0;  ///< how many members are compared, from member 0
};

/// At which step numbers a member is observed.
struct Samples {
  enum class Spacing { linear, log };
  std::int64_t count = 64;
  Spacing spacing = Spacing::log;
};

/// One question to an ensemble, as plain data. Vectors of factors are crossed (see plan.hpp).
/// All real numbers are doubles and every arithmetic starts from exactly these (rounded once, to
/// the working arithmetic, where that is narrower).
struct Study {
  std::string name;      ///< the file's stem
  std::string question;  ///< one sentence
  std::string source;    ///< who claimed it

  std::string system;                                 ///< a name of the catalogue
  std::map<std::string, std::vector<double>> values;  ///< the system's fields, parameters and start

  std::vector<std::string> methods;                  // factors …
  std::vector<std::string> arithmetics;              //
  std::vector<std::string> special_functions;        // own, gsl, boost
  std::vector<std::string> coefficients;             // per-step, standard …; empty: each method's first level
  std::vector<bool> compensation;                    //
  std::vector<std::string> rounding = {"nearest"};   // of every operation of a step: see operations.hpp
  std::vector<std::string> constants = {"rounded"};  //
  std::vector<bool> contraction = {false};           //
  std::vector<double> step;                          // … step sizes h, in the system's unit of time
  std::optional<std::int64_t> steps;                 ///< length in steps, or
  std::optional<double> until;                       ///< length in time; exactly one of the two is given

  std::int64_t members = 64;
  std::uint64_t seed = 0;
  std::map<std::string, Perturbation> perturb;  ///< by field

  std::vector<std::string> quantities;
  Reference reference;
  Samples samples;
  bool states = false;  ///< states at the samples are kept, too: for pictures of phase space
};

/// The study's content that decides its results, one `key = value` a line, in a fixed order.
/// Doubles are hexadecimal, so that equal texts mean equal bits. Name, question and source are left out; so are
/// `coefficients` and `states` where they are not given, and factors of operations that have the standard level alone, so that studies and results from before them keep their hash.
std::string canonical_text(Study const& study);

/// Name-based UUID (RFC 4122, SHA-1) of canonical_text: equal for studies with equal results.
std::string study_hash(Study const& study);

}  // namespace brouwer
