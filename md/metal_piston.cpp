#include "md/metal_piston.hpp"
#include "md/canonical_run.hpp"
#include "md/seeds.hpp"
#include "md/units.hpp"
#include <algorithm>
#include <cmath>

namespace mesobridge::md {
namespace {

constexpr double friction_steps = 40; // relaxation time of the thermostat, as in MetalSettings
constexpr double metal_velocity = metal_units::length / metal_units::time;

/// LAMMPS's own factors: masses in g/mol, velocities in Angstrom/ps, energies in eV, pressures in bar.
PistonUnits units_of(MetalPotential const& potential) {
  return {.mass = potential.mass / atomic_mass,
          .energy_of_mv2 = atomic_mass * metal_velocity * metal_velocity / metal_units::energy,
          .pressure_of_energy =
              metal_units::energy / std::pow(metal_units::length, 3) / metal_units::pressure,
          .boltzmann = k_B / metal_units::energy};
}

PistonBox box_of(MetalPistonSettings const& s) {
  Vec3 const edges = s.block().edges(s.ahead.rho / s.potential.mass) / metal_units::length;
  return {.length = edges.z,
          .area = edges.x * edges.y,
          .v_P = s.v_P / metal_velocity,
          .dt = s.dt / metal_units::time,
          .slices = s.slices(),
          .sample_every = s.sample_every};
}

} // namespace

double MetalPistonSettings::length() const {
  return block().edges(ahead.rho / potential.mass).z;
}

double MetalPistonSettings::spacing() const {
  return std::cbrt(potential.mass / ahead.rho);
}

std::int64_t MetalPistonSettings::steps(double v_S) const {
  return steps_to_far_end(length(), spacing(), v_S, dt);
}

std::string MetalPistonSettings::description() const {
  return fmt::format("{} by {} ({}), an {} crystal at {:.6g} kg/m^3, {} K before a piston at {} m/s along "
                     "<100>, {} atoms in a box of {} x {} x {} cells, time step {:.3g} fs, seed {}",
                     potential.element, potential.file.filename().string(), potential.style, name_of(lattice),
                     ahead.rho, ahead.T, v_P, atoms(), cells_across, cells_across, cells_along, dt * 1e15,
                     seed);
}

MetalPistonSettings metal_piston_settings(Preset preset, MetalPotential const& potential, Lattice lattice,
                                          MetalState ahead, double v_P,
                                          std::filesystem::path const& log_file) {
  MetalPistonSettings settings{.potential = potential, .lattice = lattice, .ahead = ahead, .v_P = v_P};
  settings.log_file = log_file;
  if (preset == Preset::standard)
    settings.cells_across = 8, settings.cells_along = 160;
  else if (preset == Preset::paper)
    settings.cells_across = 12, settings.cells_along = 300, settings.equilibration_steps = 4000;
  MetalSettings const at_rest{.potential = potential, .lattice = lattice, .log_file = log_file};
  auto const scales = scales_of(MpiWorld(), ahead.rho, at_rest, Log::replace);
  double const speed = std::max(scales.sound_speed, v_P);
  settings.dt = 0.5 * at_rest.reduced_time_step * scales.neighbour_distance / speed;
  return settings;
}

void check(MetalPistonSettings const& s) {
  double const stated = stated_density(s.potential);
  require(s.lattice != Lattice::hcp, "lattice", name_of(s.lattice),
          "must be fcc or bcc, whose cubic axis the piston moves along");
  require(s.ahead.rho >= stated / 2 && s.ahead.rho <= 2 * stated, "density [kg/m^3]", s.ahead.rho,
          fmt::format("must be in [{:.6g}, {:.6g}], about that of the potential's crystal", stated / 2,
                      2 * stated));
  require(s.ahead.T > 0 && s.ahead.T <= 1e4, "temperature [K]", s.ahead.T, "must be in (0, 10000]");
  require(s.v_P > 0 && s.v_P <= 2e4, "velocity of the piston [m/s]", s.v_P, "must be in (0, 20000]");
  require(s.cells_across >= 2 && s.cells_across <= 1000, "cells across", s.cells_across,
          "must be in [2, 1000]");
  require(s.cells_along >= 20 && s.cells_along <= 100000, "cells along", s.cells_along,
          "must be in [20, 100000]");
  require(s.dt > 0 && s.dt <= 1e-14, "time step [s]", s.dt, "must be in (0, 1e-14]");
  require(s.sample_every > 0, "steps between samples", s.sample_every, "must be > 0");
  require(s.equilibration_steps > 0, "equilibration steps", s.equilibration_steps, "must be > 0");
}

bool sample_metal_piston(MpiWorld const& world, MetalPistonSettings const& settings, std::int64_t steps,
                         PistonConsumers const& consumers) {
  check(settings);
  LammpsSession lammps(world, Ranks::all, settings.log_file);
  settings.block().create(lammps, settings.potential, settings.ahead.rho);
  lammps.command("compute_modify thermo_temp extra/dof 0");
  lammps.command("thermo 100000");
  auto const box = box_of(settings);
  double const T = settings.ahead.T;
  // Atoms on their lattice sites: half of this energy becomes potential energy.
  lammps.command("velocity all create {} {} dist gaussian", 2 * T, lammps_seed(settings.seed, 0));
  set_bath(lammps, T, box.dt, friction_steps * box.dt, lammps_seed(settings.seed, 2));
  PistonDrive drive(world, lammps, box, units_of(settings.potential), consumers);
  if (!drive.settle(settings.equilibration_steps))
    return false;
  lammps.command("unfix bath"); // whose velocities are those of half a step before
  lammps.command("velocity all create {} {} dist gaussian mom yes", T, lammps_seed(settings.seed, 3));
  drive.put_walls();
  return drive.drive(steps, fmt::format("{} before the piston", settings.potential.element));
}

} // namespace mesobridge::md
