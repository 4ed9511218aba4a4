#include "workflows/sdpd/settings.hpp"
#include "fitting/model_file.hpp"
#include "workflows/text_file.hpp"
#include <numbers>
#include <omp.h>

namespace mesobridge::workflows {

fitting::AnyEos eos_of(Scene const& scene) {
  if (scene.fluid.eos == "ideal-gas" && scene.fluid.m0)
    return fitting::IdealGas(*scene.fluid.m0);
  return fitting::load_eos(scene.fluid.eos, [](std::string const& file) { return read_text_file(file); }).eos;
}

std::array<std::uint32_t, 3> lattice_of(std::int64_t N) {
  std::array<std::int64_t, 3> best{1, 1, N};
  for (std::int64_t a = 1; a * a * a <= N; ++a)
    if (N % a == 0)
      for (std::int64_t b = a; b * b <= N / a; ++b)
        if ((N / a) % b == 0 && N / a / b - a < best[2] - best[0])
          best = {a, b, N / a / b};
  auto const side = std::llround(std::cbrt(static_cast<double>(N)));
  require(best[2] <= 3 * best[0], "particles.N", N,
          fmt::format("the initial lattice needs three similar factors, such as those of {} or {}",
                      side * side * side, side * side * (side + 1)));
  return {static_cast<std::uint32_t>(best[0]), static_cast<std::uint32_t>(best[1]),
          static_cast<std::uint32_t>(best[2])};
}

sdpd::PairScheme pair_scheme_of(std::string const& name) {
  return name == "ems"   ? sdpd::PairScheme::ems
         : name == "ams" ? sdpd::PairScheme::ams
         : name == "ser" ? sdpd::PairScheme::ser
                         : sdpd::PairScheme::ssa;
}

sdpd::Scheme scheme_of(Scene const& scene) {
  auto const& [name, dt, splitting, fluctuate_every, energy, noise] = scene.scheme;
  return {.pairs = pair_scheme_of(name),
          .verlet_steps = static_cast<std::uint32_t>(fluctuate_every),
          .splitting = splitting == "strang" ? sdpd::Splitting::strang : sdpd::Splitting::lie_trotter,
          .keep_energy = energy == "kept"};
}

sdpd::DensityCorrection density_correction_of(Scene const& scene) {
  auto const& particles = scene.particles;
  if (particles.density_scale && particles.density_self)
    return {.scale = *particles.density_scale, .self = *particles.density_self};
  if (particles.density == "glass")
    return sdpd::glass_correction(particles.kernel, neighbours_of(particles.h_factor));
  return {};
}

double neighbours_of(double h_factor) {
  return 4 * std::numbers::pi / 3 * std::pow(h_factor, 3);
}

sdpd::SimulationSettings settings_of(Scene const& scene, int threads) {
  sdpd::SimulationSettings settings{
      .eos = eos_of(scene),
      .rho = scene.fluid.rho,
      .T = scene.fluid.T,
      .K = scene.particles.K,
      .centre_of_mass =
          scene.fluid.centre_of_mass == "free" ? sdpd::CentreOfMass::free : sdpd::CentreOfMass::bulk,
      .lattice = lattice_of(scene.particles.N),
      .disorder = scene.particles.disorder,
      .kernel = scene.particles.kernel,
      .density_correction = density_correction_of(scene),
      .h_factor = scene.particles.h_factor,
      .eta = scene.transport.eta,
      .zeta = scene.transport.zeta,
      .kappa = scene.transport.kappa,
      .noise = scene.scheme.noise == "on",
      .dt = scene.scheme.dt.value,
      .scheme = scheme_of(scene),
      .seed = static_cast<std::uint64_t>(scene.run.seed),
      .threads = threads,
  };
  if (!scene.scheme.dt.reduced)
    settings.dt /= settings.units().time();
  return settings;
}

int available_threads() {
  return omp_get_num_procs();
}

OutputUnits::OutputUnits(sdpd::ReducedUnits const& reduced, UnitSystem system)
    : time(reduced.time()), energy(reduced.energy()), specific_energy(reduced.specific_energy()),
      temperature(reduced.temperature), pressure(reduced.pressure()), density(reduced.density),
      momentum(reduced.mass() * reduced.velocity()) {
  if (system == UnitSystem::lj)
    return;
  time_key = "_s", energy_key = "_J", specific_energy_key = "_J_kg", temperature_key = "_K",
  pressure_key = "_Pa";
  density_key = "_kg_m3", momentum_key = "_kg_m_s";
}

} // namespace mesobridge::workflows
