#include "workflows/scene/quantities.hpp"
#include "sdpd/observe/list.hpp"

namespace mesobridge::workflows {

namespace {

/// The fields of the particles that a list takes.
std::vector<NamedQuantity> fields_with(bool sdpd::Field::*taken) {
  std::vector<NamedQuantity> quantities;
  for (auto const& field : sdpd::fields)
    if (field.*taken)
      quantities.push_back({std::string(field.name),
                            [member = field.feature](sdpd::Features const& has) { return has.*member; }});
  return quantities;
}

} // namespace

std::vector<NamedQuantity> const& profile_quantities() {
  static auto const all = [] {
    std::vector<NamedQuantity> of{{"rho", sdpd::in_every_method},       {"velocity", sdpd::in_every_method},
                                  {"T_kin", sdpd::in_every_method},     {"T_int", sdpd::with_energies},
                                  {"P_internal", sdpd::with_densities}, {"P", sdpd::in_every_method}};
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

std::vector<NamedQuantity> const& film_quantities() {
  static auto const all = [] {
    auto of = histogram_quantities();
    for (auto const* velocity : {"velocity_x", "velocity_y", "velocity_z"})
      of.push_back({velocity, sdpd::in_every_method});
    return of;
  }();
  return all;
}

std::vector<NamedQuantity> const& series_quantities() {
  static auto const all = [] {
    std::vector<NamedQuantity> asked;
    for (auto const& measured : sdpd::measurements())
      if (!measured.in_every_run())
        asked.push_back({std::string(measured.name), measured.exists});
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
                                std::vector<NamedQuantity> const& quantities, sdpd::Features const& has) {
  if (!named.empty())
    return named;
  std::vector<std::string> names;
  for (auto const& quantity : quantities)
    if (quantity.exists(has))
      names.push_back(quantity.name);
  return names;
}

} // namespace mesobridge::workflows
