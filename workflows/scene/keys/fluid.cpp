#include "workflows/scene/keys/line.hpp"
#include "workflows/scene/keys/tables.hpp"
#include <fmt/ranges.h>

namespace mesobridge::workflows {

namespace {

std::string methods_text() {
  std::vector<std::string> lines;
  for (auto const& method : sdpd::methods())
    lines.push_back(fmt::format("{}: {}", method.name, method.help));
  return fmt::format("{}", fmt::join(lines, "; "));
}

} // namespace

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
          "method", "name", [](Scene& s) { return &s.method.name; }, methods_text())
          .choices(sdpd::method_names()),
  };
}

std::vector<SceneKey> fluid_keys() {
  Table const fluid{"fluid", &Scene::fluid};
  return {
      fluid("eos", &Scene::Fluid::eos,
            "a name of `eos list` (argon, tin, lj ...), or the path of a fitted model, seen from the scene's "
            "folder")
          .required()
          .of<sdpd::Sdpd>(),
      fluid("rho", &Scene::Fluid::rho,
            "mean density, mass per volume. N particles of mass m fill the volume N m/rho: with units = "
            "\"lj\", "
            "dpd and dpde, rho is the number density times particles.mass")
          .required()
          .quantity(Dimension::density, positive),
      fluid("T", &Scene::Fluid::T, "temperature").required().quantity(Dimension::temperature, positive),
      fluid("m0", &Scene::Fluid::m0, "mass of one molecule; ideal-gas only")
          .quantity(Dimension::mass, positive)
          .of<sdpd::Sdpd>(),
      fluid("centre_of_mass", &Scene::Fluid::centre_of_mass,
            "free: the particles' equation of state is the bulk's less what their moving centres of mass "
            "carry, "
            "so that totals do not depend on K; bulk: it is the bulk's")
          .choices({"free", "bulk"})
          .of<sdpd::Sdpd>(),
  };
}

std::vector<SceneKey> transport_keys() {
  Table const transport{"transport", &Scene::transport};
  return {
      transport("eta", &Scene::Transport::eta, "shear viscosity")
          .required()
          .quantity(Dimension::viscosity, positive)
          .of<sdpd::Sdpd>(),
      transport(
          "eta_means", &Scene::Transport::eta_means,
          "what has this viscosity. pair: the friction of pairs, to which the fluid adds what its moving "
          "particles and their forces carry, and which the time step takes from; realised: steady waves of "
          "[fluid], "
          "16 mean distances between particles long. That of the pairs is then found by trial runs of this "
          "fluid, size, scheme and time step, of at least 1024 particles, and written into the next key; "
          "refused where the fluid has more with any friction")
          .choices({"pair", "realised"})
          .of<sdpd::Sdpd>(),
      transport(
          "eta_pairs", &Scene::Transport::eta_pairs,
          "the viscosity of the friction of pairs; with eta_means = realised. It is not looked for when it "
          "is there")
          .quantity(Dimension::viscosity, positive)
          .of<sdpd::Sdpd>(),
      transport("zeta", &Scene::Transport::zeta,
                "bulk viscosity, less than 5 eta / 3, with eta that of the friction of pairs")
          .quantity(Dimension::viscosity, not_negative)
          .of<sdpd::Sdpd>(),
      transport("kappa", &Scene::Transport::kappa,
                "thermal conductivity; 0: particles exchange heat by friction alone")
          .quantity(Dimension::conductivity, not_negative)
          .of<sdpd::Sdpd>(),
  };
}

} // namespace mesobridge::workflows
