#include "tests/benchmarks/performance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <set>

#include "tests/benchmarks/registered.hpp"
#include "tests/benchmarks/results.hpp"
#include "tests/benchmarks/text_table.hpp"

namespace brouwer::benchmarks {
namespace {

/// Another program's time for the same step, measured once on a processor of the kind that docs/performance.md names.
struct Baseline {
  char const* name;
  double nanoseconds;
};
/// DMV10 of E. Hairer, G. Vilmart, coefficients per step, without potential; gfortran -O2
constexpr Baseline fortran{"published Fortran", 74.9};
/// E. Celledoni, A. Zanna, ACM Trans. Math. Softw. 37 (2010) 24, with the attitude, and its momentum alone
constexpr Baseline algorithm_903{"Algorithm 903", 1159};
constexpr Baseline algorithm_903_momentum{"Algorithm 903, momentum", 485};
/// the DMV10 step of the Fortran in boost::multiprecision::float128
constexpr Baseline boost_float128{"Boost float128, quoted", 6870};

/// A line of the table of goals: a kernel against a baseline, or against something that was measured beside it.
struct Goal {
  Kernel kernel;
  int threads = 1;
  Baseline baseline{};
  std::optional<Kernel> beside = std::nullopt;
  double ratio = 0;
};

constexpr double h = 0.01;
#if defined(__clang__)
constexpr char const* compiler = "";  // its version has its name
#else
constexpr char const* compiler = "g++";
#endif
constexpr int two = 2;

class Performance {
 public:
  explicit Performance(std::shared_ptr<Catalogue const> catalogue) : catalogue_(std::move(catalogue)) {}

  MethodEntry const& body(std::string const& method) const { return catalogue_->method("rigid_body", method); }
  InstructionSet widest() const { return widest_instruction_set(); }
  std::vector<InstructionSet> sets() const {
    std::vector<InstructionSet> all;
    for (int i = 0; i <= static_cast<int>(widest()); ++i) all.push_back(static_cast<InstructionSet>(i));
    return all;
  }

  /// PERFORMANCE's goals, and beside them what they are made of.
  std::vector<Goal> goals() const {
    auto const dmv = [&](char const* coefficients, char const* arithmetic, InstructionSet set) {
      return kernel(*catalogue_, body("dmv-10"), coefficients, arithmetic, set, h, true);
    };
    auto const elliptic = [&](char const* form, bool attitude) {
      return kernel(*catalogue_, body(form), no_level, "double", widest(), h, attitude);
    };
    auto const none = InstructionSet::none;
    auto const per_step = dmv("per-step", "double", widest());
    auto const momentum = elliptic("elliptic-branch-free", false), both = elliptic("elliptic-branch-free", true);
    auto const reference = dmv("per-step", "double-double", widest());
    auto const float128 = dmv("per-step", "float128", none);
    std::vector<Goal> all = {
        {.kernel = dmv("per-step", "double", none), .baseline = fortran, .ratio = 1},
        {.kernel = per_step, .baseline = fortran, .ratio = 20},
        {.kernel = dmv("per-trajectory", "double", widest()), .baseline = fortran, .ratio = 32},
        {.kernel = momentum, .baseline = algorithm_903_momentum, .ratio = 450},
        {.kernel = elliptic("elliptic-increment", false), .baseline = algorithm_903_momentum, .ratio = 450},
        {.kernel = both, .baseline = algorithm_903, .ratio = 200},
        {.kernel = elliptic("elliptic-increment", true), .baseline = algorithm_903, .ratio = 200},
        {.kernel = reference, .baseline = boost_float128, .ratio = 90},
        {.kernel = reference, .baseline = {"float128, this run", 0}, .beside = float128, .ratio = 90},
        {.kernel = dmv("per-trajectory", "double-double", widest()), .baseline = boost_float128, .ratio = 90},
        {.kernel = float128, .baseline = boost_float128},
    };
    for (auto const& k : {per_step, momentum, reference})
      all.push_back({.kernel = k, .threads = two, .baseline = {"one thread", 0}, .beside = k, .ratio = 1.9});
    for (auto const set : sets())
      if (set != none && set != widest())
        all.push_back({.kernel = dmv("per-step", "double", set),
                       .baseline = fortran,
                       .ratio = set == InstructionSet::avx2 ? 7.0 : 0});
    return all;
  }

  /// Methods of every system are all shown for one, and for the others one of each kind; implicit ones in one form of their
  /// coefficients.
  bool is_shown(MethodEntry const& method, std::string const& option) const {
    constexpr char const* of_all = "henon_heiles";
    bool const general = std::any_of(catalogue_->methods.begin(), catalogue_->methods.end(),
                                     [&](auto const& m) { return m.system == of_all && m.name == method.name; });
    if (!general) return true;
    if (method.coefficients.size() > 1 && option != "symplectic") return false;
    bool const typical = method.name == "stoermer-verlet" || method.name == "kutta-4" || method.name == "gauss-8";
    return typical || method.system == of_all;
  }

  /// Every method in double and the widest packs that it has.
  std::vector<Kernel> methods() const {
    std::vector<Kernel> all;
    for (auto const& method : catalogue_->methods)
      for (auto const& option : options_of(method)) {
        if (method.uses_special_functions && option != "own") continue;
        if (!is_shown(method, option)) continue;
        auto const set = runs_in(method, "double", widest()) ? widest() : InstructionSet::none;
        auto const& system = catalogue_->system(method.system);
        auto const add = [&](double step, bool whole_state, bool compensation) {
          all.push_back(kernel(*catalogue_, method, option, "double", set, step, whole_state, compensation));
        };
        if (system.always_integrated < system.state_components.size()) add(system.usual_step, false, false);
        add(system.usual_step, true, false);
        if (method.compensable) add(system.usual_step, true, true);
        add(10 * system.usual_step, true, false);
      }
    return all;
  }

  /// Other arithmetics, in one method of each kind.
  std::vector<Kernel> arithmetics() const {
    std::vector<Kernel> all;
    for (auto const& [method, option] : {std::pair{"dmv-10", "per-step"}, {"elliptic-increment", no_level}})
      for (auto const* arithmetic : {"float", "long-double", "double-double"}) {
        auto const set = runs_in(body(method), arithmetic, widest()) ? widest() : InstructionSet::none;
        all.push_back(kernel(*catalogue_, body(method), option, arithmetic, set, h, true));
      }
    return all;
  }

  void register_all() const {
    std::set<std::pair<std::string, int>> known;
    auto const add = [&](Kernel const& k, int threads) {
      if (known.insert({name_of(k), threads}).second) register_kernel(catalogue_, k, threads);
    };
    auto const add_with_scalar = [&](Kernel const& k) {
      add(k, 1);
      add(in_numbers(k), 1);
    };
    for (auto const set : sets())
      for (auto const mix : all_mixes)
        for (int threads : {1, two}) register_peak(mix, set, "double", threads);
    for (auto const& goal : goals()) {
      add_with_scalar(goal.kernel);
      if (goal.threads > 1) add(goal.kernel, goal.threads);
    }
    for (auto const& k : methods()) add_with_scalar(k);
    for (auto const& k : arithmetics()) add_with_scalar(k);
  }

  void print(Results const& results) const {
    print_peaks(results);
    print_goals(results);
    auto all = methods();
    for (auto const& k : arithmetics()) all.push_back(k);
    print_kernels(results, all);
  }

 private:
  /// The same, one member after the other.
  static Kernel in_numbers(Kernel kernel) {
    kernel.set = InstructionSet::none;
    return kernel;
  }

  static std::string number(std::optional<double> value) {
    if (!value) return "–";
    return *value < 1000 ? fmt::format("{:.3g}", *value) : fmt::format("{:.0f}", *value);
  }
  static std::string share(std::optional<Summary> const& value) {
    return value ? fmt::format("{:.0f} %", 100 * value->median) : "–";
  }

  static std::optional<double> time(Results const& results, Kernel const& k, int threads = 1) {
    auto const found = results.of(name_of(k), counter_time, threads);
    return found ? std::optional(found->median) : std::nullopt;
  }

  void print_peaks(Results const& results) const {
    std::vector<std::string> header = {"operations a nanosecond"};
    for (auto const mix : all_mixes) header.push_back(name_of(mix));
    header.emplace_back("two threads: both");
    header.emplace_back("two threads: divide");
    TextTable table(header);
    for (auto const set : sets()) {
      std::vector<std::string> line = {set == InstructionSet::none ? "one double" : name_of(set)};
      auto const rate = [&](Mix mix, int threads) {
        auto const found = results.of(name_of(mix, set, "double"), counter_rate, threads);
        return found ? found->median : 0.0;
      };
      for (auto const mix : all_mixes) line.push_back(number(rate(mix, 1)));
      for (auto const mix : {Mix::multiply_and_add, Mix::divide})
        line.push_back(fmt::format("{:.2f} ×", rate(mix, two) / rate(mix, 1)));
      table.add(line);
    }
    fmt::print("\n{}", table.text());
  }

  /// What every line says of a kernel.
  std::vector<std::string> described(Results const& results, Kernel const& k, int threads) const {
    auto const name = name_of(k);
    auto const measured = results.of(name, counter_time, threads);
    auto const flops = results.of(name, counter_flops, threads);
    auto const nanoseconds = time(results, k), scalar = time(results, in_numbers(k));
    return {name + (threads > 1 ? fmt::format(", {} threads", threads) : ""),
            measured ? fmt::format("{} ± {:.1f} %", number(measured->median), 100 * measured->spread) : "–",
            flops ? fmt::format("{:.0f}", flops->median) : "–",
            share(results.of(name, counter_peak, threads)),
            share(results.of(name, counter_adders, threads)),
            share(results.of(name, counter_multipliers, threads)),
            share(results.of(name, counter_divider, threads)),
            threads == 1 && k.set != InstructionSet::none && nanoseconds && scalar
                ? fmt::format("{:.1f}", *scalar / *nanoseconds)
                : "–"};
  }

  static inline std::vector<std::string> const columns = {
      "kernel", "ns per member-step", "flops", "of peak", "+ −", "×", "÷ √", "× scalar"};

  void print_goals(Results const& results) const {
    auto header = columns;
    for (auto const* more : {"against", "its ns", "ratio", "goal", "reached"}) header.emplace_back(more);
    TextTable table(header);
    for (auto const& goal : goals()) {
      auto line = described(results, goal.kernel, goal.threads);
      auto const own = time(results, goal.kernel, goal.threads);
      double const other = goal.beside ? time(results, *goal.beside).value_or(0) : goal.baseline.nanoseconds;
      double const ratio = other / own.value_or(0);
      line.emplace_back(goal.baseline.name);
      line.push_back(number(other));
      line.push_back(number(ratio));
      line.push_back(goal.ratio > 0 ? number(goal.ratio) : "–");
      line.emplace_back(goal.ratio > 0 ? (ratio >= goal.ratio ? "yes" : "no") : "–");
      table.add(line);
    }
    fmt::print("\n{}", table.text());
  }

  void print_kernels(Results const& results, std::vector<Kernel> const& kernels) const {
    TextTable table(columns);
    for (auto const& k : kernels) table.add(described(results, k, 1));
    fmt::print("\n{}", table.text());
  }

  std::shared_ptr<Catalogue const> catalogue_;
};

class TableReporter final : public benchmark::BenchmarkReporter {
 public:
  explicit TableReporter(Performance performance) : performance_(std::move(performance)) {}
  bool ReportContext(Context const& context) override {
    auto const& load = context.cpu_info.load_avg;
    fmt::print("{} processors, load {}, {} {}\n", context.cpu_info.num_cpus,
               load.empty() ? "unknown" : fmt::format("{:.1f}", load.front()), compiler, __VERSION__);
    std::fflush(stdout);
    fmt::print(stderr, "measuring for about a minute …\n");
    return true;
  }
  void ReportRuns(std::vector<Run> const& runs) override {
    for (auto const& run : runs) results_.add(run);
  }
  void Finalize() override { performance_.print(results_); }

 private:
  Performance performance_;
  Results results_;
};

}  // namespace

std::unique_ptr<benchmark::BenchmarkReporter> register_performance(std::shared_ptr<Catalogue const> const& catalogue) {
  Performance const performance(catalogue);
  performance.register_all();
  return std::make_unique<TableReporter>(performance);
}

}  // namespace brouwer::benchmarks
