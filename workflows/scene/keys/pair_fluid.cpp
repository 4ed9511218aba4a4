#include "workflows/scene/keys/line.hpp"
#include "workflows/scene/keys/tables.hpp"

namespace mesobridge::workflows {

namespace {

std::vector<SceneKey> friction_keys() {
  Table const friction{"friction", &Scene::friction};
  Table const internal_energy{"internal_energy", &Scene::internal_energy};
  Table const conduction{"conduction", &Scene::conduction};
  return {
      friction("gamma_par", &Scene::Friction::gamma_par,
               "friction along the line of centres at contact: gamma (1 - r/cutoff)^exponent, at the set "
               "temperature")
          .quantity(Dimension::friction, not_negative)
          .of<sdpd::Dpde, sdpd::Dpd>(),
      friction("gamma_perp", &Scene::Friction::gamma_perp, "the same across the line of centres")
          .quantity(Dimension::friction, not_negative)
          .of<sdpd::Dpde, sdpd::Dpd>(),
      friction("cutoff", &Scene::Friction::cutoff, "where the friction ends; the reduced unit of length")
          .quantity(Dimension::length, positive)
          .of<sdpd::Dpde, sdpd::Dpd>(),
      friction("exponent", &Scene::Friction::exponent, "of the weight; if not given, 2, which is customary")
          .in({.min = 0, .open = true, .max = 20})
          .of<sdpd::Dpde, sdpd::Dpd>(),
      friction(
          "file", &Scene::Friction::file,
          "CSV with columns r,gamma_par and perhaps gamma_perp (SI: r_m,gamma_par_kg_s,gamma_perp_kg_s), in "
          "place of the above")
          .of<sdpd::Dpde, sdpd::Dpd>(),
      internal_energy("heat_capacity", &Scene::InternalEnergy::heat_capacity,
                      "of a particle, in k_B, constant")
          .in(positive)
          .of<sdpd::Dpde>(),
      internal_energy("model", &Scene::InternalEnergy::model,
                      "or the path of a model file with a table of C(T) or S(eps)")
          .of<sdpd::Dpde>(),
      conduction(
          "kappa", &Scene::Conduction::kappa,
          "heat that particles exchange beside their friction, at contact: kappa (1 - r/cutoff)^exponent "
          "(1/T_i "
          "- 1/T_j) per time, with its noise; 0: none. If not given, that of particles.model, or none")
          .quantity(Dimension::conduction, not_negative)
          .of<sdpd::Dpde>(),
      conduction("cutoff", &Scene::Conduction::cutoff, "where it ends; if not given, where the friction does")
          .quantity(Dimension::length, positive)
          .of<sdpd::Dpde>(),
      conduction("exponent", &Scene::Conduction::exponent,
                 "of the weight; if not given, 2, which is customary")
          .in({.min = 0, .open = true, .max = 20})
          .of<sdpd::Dpde>(),
      conduction("file", &Scene::Conduction::file,
                 "CSV with columns r,kappa (SI: r_m,kappa_W_K), in place of the above")
          .of<sdpd::Dpde>(),
  };
}

} // namespace

std::vector<SceneKey> pair_fluid_keys() {
  auto all = potential_keys();
  auto const others = friction_keys();
  all.insert(all.end(), others.begin(), others.end());
  return all;
}

} // namespace mesobridge::workflows
