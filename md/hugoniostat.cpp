#include "md/hugoniostat.hpp"
#include "md/seeds.hpp"
#include "md/units.hpp"

namespace mesobridge::md {

bool sample_hugoniostat(MpiWorld const& world, ShockTarget const& target, MetalSettings const& settings,
                        std::function<bool(HugoniostatSample const&)> const& consume, Log log) {
  constexpr double thermostat_steps = 100, barostat_steps = 500; // their relaxation times
  check(target.initial, settings);
  check(target.nearby, settings);
  auto const scales = scales_of(world, target.nearby.rho, settings, log);
  CrystalBlock const block(settings.lattice, settings.least_atoms);
  double const mass = block.atoms() * settings.potential.mass;
  // The centre of mass rests here, but moves in the canonical ensemble that e0 comes from.
  auto const centre_of_mass = [&](double T) { return 1.5 * k_B * T / mass; };
  double const dt = scales.time_step(target.nearby.T, settings) / metal_units::time;

  LammpsSession lammps(world, Ranks::own, settings.log_file, Log::append);
  block.create(lammps, settings.potential, target.nearby.rho);
  lammps.command("timestep {}", dt);
  lammps.command("thermo {}", settings.steps());
  lammps.command("velocity all create {} {} dist gaussian", 2 * target.nearby.T,
                 lammps_seed(settings.seed, 3));
  lammps.command("fix shock all nphug temp {0} {0} {1} iso {2} {2} {3}", target.nearby.T,
                 thermostat_steps * dt, target.P / metal_units::pressure, barostat_steps * dt);
  lammps.command(
      "fix_modify shock e0 {} p0 {} v0 {}",
      (target.e0 - centre_of_mass(target.initial.T) + scales.zero_of_e) * mass / metal_units::energy,
      target.P0 / metal_units::pressure,
      mass / target.initial.rho / (metal_units::length * metal_units::length * metal_units::length));
  lammps.command("run {} post no", settings.equilibration_steps);
  for (std::int64_t done = 0; done < settings.sampling_steps; done += settings.sample_every) {
    lammps.command("run {} pre no post no", settings.sample_every);
    double const T = lammps.thermo("temp");
    double const volume = lammps.thermo("vol") * std::pow(metal_units::length, 3);
    HugoniostatSample const sample{.T = T,
                                   .rho = mass / volume,
                                   .e = lammps.thermo("etotal") * metal_units::energy / mass -
                                        scales.zero_of_e + centre_of_mass(T),
                                   .P = lammps.thermo("press") * metal_units::pressure};
    if (!consume(sample))
      return false;
  }
  return true;
}

} // namespace mesobridge::md
