#include "workflows/scene/keys/line.hpp"
#include "workflows/scene/keys/tables.hpp"

namespace mesobridge::workflows {

std::vector<SceneKey> title_and_method_keys() {
  return {
      Line(
          "", "title", [](Scene& s) { return &s.title; }, "a name for people")
          .required(),
      Line(
          "", "units", [](Scene& s) { return &s.units; },
          "SI: quantities are texts with a unit; lj: plain numbers in Lennard-Jones units")
          .choices({"SI", "lj"}),
      Line(
          "method", "name", [](Scene& s) { return &s.method.name; },
          "sdpd: particles of fluid with an equation of state; dpde: soft particles with internal energies; "
          "dpd: "
          "soft particles at a set temperature")
          .choices({"sdpd", "dpde", "dpd"}),
  };
}

std::vector<SceneKey> fluid_keys() {
  return {
      Line(
          "fluid", "eos", [](Scene& s) { return &s.fluid.eos; },
          "a name of `eos list` (argon, tin, lj ...), or the path of a fitted model, seen from the scene's "
          "folder")
          .required()
          .of(sdpd_only),
      Line(
          "fluid", "rho", [](Scene& s) { return &s.fluid.rho; },
          "mean density, mass per volume. N particles of mass m fill the volume N m/rho: with units = "
          "\"lj\", "
          "dpd and dpde, rho is the number density times particles.mass")
          .required()
          .quantity(Dimension::density, positive),
      Line(
          "fluid", "T", [](Scene& s) { return &s.fluid.T; }, "temperature")
          .required()
          .quantity(Dimension::temperature, positive),
      Line(
          "fluid", "m0", [](Scene& s) { return &s.fluid.m0; }, "mass of one molecule; ideal-gas only")
          .quantity(Dimension::mass, positive)
          .of(sdpd_only),
      Line(
          "fluid", "centre_of_mass", [](Scene& s) { return &s.fluid.centre_of_mass; },
          "free: the particles' equation of state is the bulk's less what their moving centres of mass "
          "carry, "
          "so that totals do not depend on K; bulk: it is the bulk's")
          .choices({"free", "bulk"})
          .of(sdpd_only),
  };
}

std::vector<SceneKey> transport_keys() {
  return {
      Line(
          "transport", "eta", [](Scene& s) { return &s.transport.eta; }, "shear viscosity")
          .required()
          .quantity(Dimension::viscosity, positive)
          .of(sdpd_only),
      Line(
          "transport", "zeta", [](Scene& s) { return &s.transport.zeta; },
          "bulk viscosity, less than 5 eta / 3")
          .quantity(Dimension::viscosity, not_negative)
          .of(sdpd_only),
      Line(
          "transport", "kappa", [](Scene& s) { return &s.transport.kappa; },
          "thermal conductivity; 0: particles exchange heat by friction alone")
          .quantity(Dimension::conductivity, not_negative)
          .of(sdpd_only),
  };
}

} // namespace mesobridge::workflows
