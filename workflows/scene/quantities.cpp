#include "workflows/scene/quantities.hpp"
#include "sdpd/method/list.hpp"
#include "sdpd/observe/list.hpp"
#include <algorithm>
#include <functional>

namespace mesobridge::workflows {

namespace {

/// Those of whose features the condition, a member or a function of them, holds.
template <class Condition>
std::vector<std::string> methods_with(Condition condition) {
  std::vector<std::string> methods;
  for (auto const& method : sdpd::methods())
    if (std::invoke(condition, method.features))
      methods.emplace_back(method.name);
  return methods;
}

/// The fields of the particles that a list takes.
std::vector<NamedQuantity> fields_with(bool sdpd::Field::*taken) {
  std::vector<NamedQuantity> quantities;
  for (auto const& field : sdpd::fields)
    if (field.*taken)
      quantities.push_back({std::string(field.name), methods_with(field.feature)});
  return quantities;
}

} // namespace

std::vector<NamedQuantity> const& profile_quantities() {
  static auto const all = [] {
    auto const all = sdpd::method_names();
    std::vector<NamedQuantity> of{{"rho", all},
                                  {"velocity", all},
                                  {"T_kin", all},
                                  {"T_int", methods_with(&sdpd::Features::energies)},
                                  {"P_internal", methods_with(&sdpd::Features::densities)},
                                  {"P", all}};
    for (auto const& field : fields_with(&sdpd::Field::profiled))
      of.push_back(field);
    return of;
  }();
  return all;
}

std::vector<NamedQuantity> const& histogram_quantities() {
  static auto const all = fields_with(&sdpd::Field::written);
  return all;
}

std::vector<NamedQuantity> const& series_quantities() {
  static auto const all = [] {
    std::vector<NamedQuantity> asked;
    for (auto const& measured : sdpd::measurements())
      if (!measured.in_every_run())
        asked.push_back({std::string(measured.name), methods_with(measured.exists)});
    return asked;
  }();
  return all;
}

std::vector<std::string> names_of(std::vector<NamedQuantity> const& quantities) {
  std::vector<std::string> names;
  for (auto const& quantity : quantities)
    names.push_back(quantity.name);
  return names;
}

std::vector<std::string> chosen(std::vector<std::string> const& named,
                                std::vector<NamedQuantity> const& quantities, std::string const& method) {
  if (!named.empty())
    return named;
  std::vector<std::string> names;
  for (auto const& quantity : quantities)
    if (std::ranges::find(quantity.methods, method) != quantity.methods.end())
      names.push_back(quantity.name);
  return names;
}

} // namespace mesobridge::workflows
