#include "sdpd/method/settings.hpp"
#include "workflows/scene/keys/line.hpp"
#include "workflows/scene/keys/tables.hpp"

namespace mesobridge::workflows {

std::vector<SceneKey> particle_keys() {
  Table const particles{"particles", &Scene::particles};
  return {
      particles("N", &Scene::Particles::N, "how many particles; must be given, or box.size")
          .in(at_least_one)
          .written_if([](Scene const& scene) { return scene.particles.N > 0; }),
      particles("K", &Scene::Particles::K, "size: molecules in one particle")
          .required()
          .in(sdpd::Sdpd::sizes)
          .of<sdpd::Sdpd>(),
      particles(
          "kernel", &Scene::Particles::kernel,
          "smoothing kernel. Wendland's do not let particles pair; the cubic and Lucy's do, from about 60 "
          "neighbours on, and pressure and density drift with the pairs")
          .choices(sdpd::kernel_names())
          .of<sdpd::Sdpd>(),
      particles("h_factor", &Scene::Particles::h_factor,
                "support of the kernel in mean spacings, h = h_factor (m/rho)^(1/3)")
          .in(sdpd::Sdpd::supports)
          .of<sdpd::Sdpd>(),
      particles("disorder", &Scene::Particles::disorder,
                "standard deviation of the initial displacements from a cubic lattice, in its spacings")
          .in(sdpd::SimulationSettings::disorders),
      particles(
          "start", &Scene::Particles::start,
          "lattice: with that disorder, of which particles above K = 10^4 keep much; melted: without a "
          "lattice, brought to a minimum of the free energy before they move, so that no heat is set free")
          .choices({"lattice", "melted"})
          .of<sdpd::Sdpd>(),
      particles(
          "density", &Scene::Particles::density,
          "constants c, eps of rho_i = c sum_j m_j W_ij - eps m_i W_ii(0): 1 and 0 (plain); those of a "
          "glass; "
          "given by the next two keys; or calibrated: found by a short run of this fluid and size, so that "
          "its "
          "mean density and pressure are those of the equation of state (calibrated-response: so that its "
          "mean "
          "density is, and follows a compression; for fluids almost without pressure), and written into the "
          "next "
          "two keys. It is not repeated when they are there. calibrated-shocked: the same in the state "
          "behind "
          "the "
          "piston's shock, by the relations of Rankine and Hugoniot. auto: calibrated, by the response where "
          "the "
          "pressure "
          "is too small; plain where there is no noise, nothing moves or the fluid is under tension")
          .choices(
              {"auto", "plain", "glass", "given", "calibrated", "calibrated-response", "calibrated-shocked"})
          .of<sdpd::Sdpd>(),
      particles("density_scale", &Scene::Particles::density_scale,
                "c; with density = given, calibrated or auto")
          .in({.min = 0, .open = true, .max = 10})
          .of<sdpd::Sdpd>(),
      particles("density_self", &Scene::Particles::density_self,
                "eps, between -c and c; with density = given, calibrated or auto")
          .in({.min = -10, .max = 10})
          .of<sdpd::Sdpd>(),
      particles(
          "calibration_steps", &Scene::Particles::calibration_steps,
          "steps of a calibration, of at most about 1000 particles, from 200 on; 0: a quarter of the run's, "
          "from 200 to 6000")
          .in({.min = 0, .max = 1e9})
          .of<sdpd::Sdpd>(),
      particles(
          "density_sum", &Scene::Particles::density_sum,
          "for regions whose particles have unlike masses. mass: rho_i = sum m_j W_ij, which is right where "
          "the mass per volume is smooth; number: rho_i = m_i sum W_ij, where the number per volume is; "
          "auto: number if all regions have the same distance between particles, else mass")
          .choices({"auto", "mass", "number"})
          .written_if([](Scene const& scene) { return !scene.regions.empty(); })
          .of<sdpd::Sdpd>(),
      particles("model", &Scene::Particles::model,
                "path of a model file, as `fit dpde` writes it, with the mass of a particle, its internal "
                "energy, the potential, the "
                "friction and the conduction of two; what the scene says of one of these takes its place")
          .of<sdpd::Dpde, sdpd::Dpd>(),
      particles("mass", &Scene::Particles::mass, "mass of one particle; if not given, that of the model")
          .quantity(Dimension::mass, positive)
          .of<sdpd::Dpde, sdpd::Dpd>(),
  };
}

} // namespace mesobridge::workflows
