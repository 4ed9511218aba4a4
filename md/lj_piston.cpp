#include "md/lj_piston.hpp"
#include "md/canonical_run.hpp"
#include "md/lj_atoms.hpp"
#include "md/seeds.hpp"
#include <algorithm>
#include <cmath>

namespace mesobridge::md {
namespace {

constexpr double thermal_step = 0.01, friction_time = 0.5; // times sqrt(T*), as in LjFluidSettings

double lattice_constant(LjState state) {
  return std::cbrt(4 / state.rho);
}

/// One run, in the order of its steps.
class PistonRun {
 public:
  PistonRun(MpiWorld const& world, LjPistonSettings const& settings, PistonConsumers const& consumers)
      : settings_(settings), lammps_(world, Ranks::all, settings.log_file),
        drive_(world, lammps_, box_of(settings), {}, consumers) {}

  bool run(std::int64_t steps) {
    set_up();
    if (!melt() || !equilibrate())
      return false;
    put_walls();
    return drive_.drive(steps, "the Lennard-Jones fluid before the piston");
  }

 private:
  void set_up() {
    auto const& s = settings_;
    create_lj_atoms(lammps_,
                    {.rho = s.ahead.rho, .cells_across = s.cells_across, .cells_along = s.cells_along},
                    s.cutoff, false);
    lammps_.command("thermo 100000");
  }

  bool thermalise(double T, std::int64_t steps, std::uint64_t purpose) {
    double const scale = 1 / std::sqrt(T);
    set_bath(lammps_, T, thermal_step * scale, friction_time * scale, lammps_seed(settings_.seed, purpose));
    return drive_.settle(steps);
  }

  bool melt() {
    double const T = std::max(2 * settings_.ahead.T, 10.0);
    lammps_.command("velocity all create {} {} dist gaussian", T, lammps_seed(settings_.seed, 0));
    return thermalise(T, settings_.melt_steps, 1);
  }

  bool equilibrate() {
    double const T = settings_.ahead.T;
    lammps_.command("velocity all scale {}", T);
    if (!thermalise(T, settings_.equilibration_steps, 2))
      return false;
    double const order = lattice_order(lammps_.frame(), lattice_constant(settings_.ahead));
    if (order > 0.3)
      throw PhysicsError(
          fmt::format("the Lennard-Jones crystal before the piston did not melt (lattice order "
                      "{:.2f}): choose a fluid state ahead, rho* = {}, T* = {}",
                      order, settings_.ahead.rho, T));
    return true;
  }

  /// Ends the bath and the periodicity along z. The velocities are made anew, since those of the bath's
  /// discretisation are of half a step before.
  void put_walls() {
    auto const& s = settings_;
    lammps_.command("unfix bath");
    lammps_.command("velocity all create {} {} dist gaussian mom yes", s.ahead.T, lammps_seed(s.seed, 3));
    drive_.put_walls();
  }

  static PistonBox box_of(LjPistonSettings const& s) {
    double const edge = s.cells_across * lattice_constant(s.ahead);
    return {.length = s.length(),
            .area = edge * edge,
            .v_P = s.v_P,
            .dt = s.dt,
            .slices = s.slices(),
            .sample_every = s.sample_every};
  }

  LjPistonSettings const& settings_;
  LammpsSession lammps_;
  PistonDrive drive_;
};

} // namespace

double LjPistonSettings::length() const {
  return cells_along * lattice_constant(ahead);
}

double LjPistonSettings::spacing() const {
  return std::cbrt(1 / ahead.rho);
}

int LjPistonSettings::slices() const {
  return int(std::lround(length() / spacing()));
}

std::int64_t LjPistonSettings::steps(double v_S) const {
  return steps_to_far_end(length(), spacing(), v_S, dt);
}

std::string LjPistonSettings::description() const {
  return fmt::format(
      "Lennard-Jones fluid at rho* = {}, T* = {} before a piston at v* = {}, {} atoms in a box "
      "{} x {} x {} cells, cut at {} sigma (not shifted, no tail), time step {}, seed {}",
      ahead.rho, ahead.T, v_P, atoms(), cells_across, cells_across, cells_along, cutoff, dt, seed);
}

LjPistonSettings lj_piston_settings(Preset preset) {
  LjPistonSettings settings;
  if (preset == Preset::standard)
    settings.cells_across = 5, settings.cells_along = 133;
  else if (preset == Preset::paper)
    settings.cells_across = 10, settings.cells_along = 266, settings.equilibration_steps = 10000;
  return settings;
}

void check(LjPistonSettings const& settings) {
  auto const& [rho, T] = settings.ahead;
  require(rho > 0 && rho <= 1.5, "density rho*", rho, "must be in (0, 1.5]");
  require(T >= 0.5 && T <= 1000, "temperature T*", T, "must be in [0.5, 1000]");
  require(settings.v_P > 0 && settings.v_P <= 100, "velocity of the piston v*", settings.v_P,
          "must be in (0, 100]");
  require(settings.cells_across >= 2 && settings.cells_across <= 1000, "cells across", settings.cells_across,
          "must be in [2, 1000]");
  require(settings.cells_along >= 20 && settings.cells_along <= 100000, "cells along", settings.cells_along,
          "must be in [20, 100000]");
  require(settings.cutoff >= 2.5 && settings.cutoff <= 10, "cut-off", settings.cutoff,
          "must be in [2.5, 10] sigma");
  require(settings.dt > 0 && settings.dt <= 0.02, "time step", settings.dt, "must be in (0, 0.02]");
  require(settings.sample_every > 0, "steps between samples", settings.sample_every, "must be > 0");
  require(settings.melt_steps > 0, "melt steps", settings.melt_steps, "must be > 0");
  require(settings.equilibration_steps > 0, "equilibration steps", settings.equilibration_steps,
          "must be > 0");
}

bool sample_lj_piston(MpiWorld const& world, LjPistonSettings const& settings, std::int64_t steps,
                      PistonConsumers const& consumers) {
  check(settings);
  return PistonRun(world, settings, consumers).run(steps);
}

} // namespace mesobridge::md
