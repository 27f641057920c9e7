#pragma once
#include <brouwer/integrators/explicit_runge_kutta.hpp>
#include <brouwer/integrators/implicit_runge_kutta.hpp>
#include <brouwer/integrators/kick_drift.hpp>
#include <string>
#include <variant>
#include <vector>

// Every method for any system, as data: what is listed here keeps the promises of the contract tests.
namespace brouwer::testing_support {

struct ImplicitInForm {
  ImplicitMethod const* method;
  CoefficientForm form;
};

struct FieldMethod {
  std::string name;
  int order;
  bool symmetric, symplectic;
  std::variant<KickDriftMethod const*, ExplicitTableau const*, ImplicitInForm> data;

  bool for_separable_only() const { return std::holds_alternative<KickDriftMethod const*>(data); }
  bool iterates() const { return std::holds_alternative<ImplicitInForm>(data); }
};

inline std::ostream& operator<<(std::ostream& out, FieldMethod const& m) { return out << m.name; }

inline std::vector<FieldMethod> field_methods() {
  std::vector<FieldMethod> all;
  for (auto const& m : kick_drift_methods()) all.push_back({m.name, m.order, m.symmetric(), true, &m});
  for (auto const& m : explicit_tableaux()) all.push_back({m.name, m.order, false, false, &m});
  for (auto const& m : implicit_methods())
    for (auto form : forms_of(m))
      all.push_back(
          {std::string(m.name) + "-" + name_of(form), m.order, m.is_gauss(), m.is_gauss(), ImplicitInForm{&m, form}});
  return all;
}

/// Those of any system, separable or not.
inline std::vector<FieldMethod> methods_of_any_field() {
  auto methods = field_methods();
  std::erase_if(methods, [](FieldMethod const& m) { return m.for_separable_only(); });
  return methods;
}

/// use(make), where make(setup) is the method's step for a system over a scalar.
template <class System, class Use>
void with_method(FieldMethod const& method, Use use) {
  std::visit(
      [&use]<class Data>(Data const& data) {
        if constexpr (std::same_as<Data, ImplicitInForm>)
          use([&](Setup<System> const& s) { return ImplicitRungeKutta<System>(s, *data.method, data.form); });
        else if constexpr (std::same_as<Data, ExplicitTableau const*>)
          use([&](Setup<System> const& s) { return ExplicitRungeKutta<System>(s, *data); });
        else if constexpr (SeparableSystem<System>)
          use([&](Setup<System> const& s) { return KickDrift<System>(s, *data); });
      },
      method.data);
}

/// … with its step.
template <class System, class Use>
void with_step(FieldMethod const& method, Setup<System> const& setup, Use use) {
  with_method<System>(method, [&](auto make) { use(make(setup)); });
}

/// For the names of parametrised tests.
inline std::string identifier(std::string name) {
  std::erase(name, '-');
  return name;
}

}  // namespace brouwer::testing_support
