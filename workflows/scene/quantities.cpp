#include "workflows/scene/quantities.hpp"
#include <algorithm>

namespace mesobridge::workflows {

std::vector<NamedQuantity> const& profile_quantities() {
  static std::vector<NamedQuantity> const all{
      {"rho", {"sdpd", "dpde", "dpd"}},   {"velocity", {"sdpd", "dpde", "dpd"}},
      {"T_kin", {"sdpd", "dpde", "dpd"}}, {"T_int", {"sdpd", "dpde"}},
      {"P_internal", {"sdpd"}},           {"P", {"sdpd", "dpde", "dpd"}}};
  return all;
}

std::vector<NamedQuantity> const& histogram_quantities() {
  static std::vector<NamedQuantity> const all{
      {"eps", {"sdpd", "dpde"}}, {"T", {"sdpd", "dpde"}}, {"rho", {"sdpd"}}, {"P", {"sdpd"}}};
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
