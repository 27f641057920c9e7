#include "tests/benchmarks/kernels.hpp"

#include <brouwer/ensemble/arithmetics.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <functional>

namespace brouwer::benchmarks {
namespace {

bool in_packs(std::string const& arithmetic) {
  bool found = false;
  for_arithmetic(arithmetic,
                 [&]<class T>(NamedArithmetic<T>) { found = (lanes<typename PackOf<T, native_bytes>::type>) > 1; });
  return found;
}

/// Enough for a call to cost nothing, few enough to be repeated often.
std::int64_t steps_of_a_call(Catalogue const& catalogue, std::string const& arithmetic) {
  constexpr int bits_of_hardware = 107;
  return catalogue.arithmetic(arithmetic).bits <= bits_of_hardware ? 200 : 2;
}

}  // namespace

std::string name_of(Kernel const& kernel) {
  auto const& cell = kernel.cell;
  std::string name = cell.system + "/" + cell.method;
  for (auto const& option : {cell.special_functions, cell.coefficients})
    if (option != no_level) name += "/" + option;
  return fmt::format("{}/{}/{}/h:{}/{}{}", name, cell.arithmetic, name_of(kernel.set), cell.step,
                     kernel.whole_state ? "whole" : "part", cell.compensation ? "/compensated" : "");
}

Kernel kernel(Catalogue const& catalogue, MethodEntry const& entry, std::string const& option,
              std::string const& arithmetic, InstructionSet set, double h, bool whole_state, bool compensation) {
  CellLabels const cell{entry.system,
                        entry.name,
                        arithmetic,
                        entry.uses_special_functions ? option : no_level,
                        entry.coefficients.empty() ? no_level : option,
                        compensation,
                        h,
                        steps_of_a_call(catalogue, arithmetic)};
  return {cell, whole_state, set};
}

std::vector<std::string> options_of(MethodEntry const& method) {
  if (method.uses_special_functions) return special_function_variants();
  if (!method.coefficients.empty()) return method.coefficients;
  return {no_level};
}

bool runs_in(MethodEntry const& method, std::string const& arithmetic, InstructionSet set) {
  if (set == InstructionSet::none) return true;
  for (auto const& maker : method.makers)
    if (maker.set == set) return in_packs(arithmetic);
  return false;
}

std::vector<Kernel> all_kernels(Catalogue const& catalogue) {
  std::vector<Kernel> kernels;
  auto const add = [&](MethodEntry const& method, std::string const& option, std::string const& arithmetic,
                       InstructionSet set) {
    auto const& system = catalogue.system(method.system);
    bool const parts = system.always_integrated < system.state_components.size();
    for (double h : {system.usual_step, 10 * system.usual_step})
      for (bool whole_state : parts ? std::vector{false, true} : std::vector{true})
        for (bool compensation : {false, true})
          if (!compensation || (method.compensable && arithmetic != "double-double"))
            kernels.push_back(kernel(catalogue, method, option, arithmetic, set, h, whole_state, compensation));
  };
  for (auto const& method : catalogue.methods)
    for (auto const& option : options_of(method))
      for (auto const& arithmetic : catalogue.arithmetics)
        for (auto const set :
             {InstructionSet::none, InstructionSet::sse2, InstructionSet::avx2, InstructionSet::avx512}) {
          bool const others_functions = method.uses_special_functions && option != "own";
          if (others_functions && (set != InstructionSet::none || !variant_exists(option, arithmetic.name))) continue;
          if (runs_in(method, arithmetic.name, set)) add(method, option, arithmetic.name, set);
        }
  return kernels;
}

std::vector<Start> starts_of_members(Catalogue const& catalogue, std::string const& system_name) {
  auto const& system = catalogue.system(system_name);
  Study study;
  study.system = system_name;
  for (auto const& field : system.fields) study.values[field.name] = field.standard;
  auto const start = std::find_if_not(system.fields.begin(), system.fields.end(), std::mem_fn(&Field::parameter));
  study.perturb[start->name] = {Perturbation::Law::uniform, 1e-3};
  std::vector<Start> starts;
  for (int member = 0; member < members; ++member) starts.push_back(member_start(study, system, member));
  return starts;
}

}  // namespace brouwer::benchmarks
