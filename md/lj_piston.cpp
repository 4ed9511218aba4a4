#include "md/lj_piston.hpp"
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
  PistonRun(MpiWorld const& world, LjPistonSettings const& settings, LjPistonConsumers const& consumers)
      : world_(world), settings_(settings), consumers_(consumers),
        lammps_(world, Ranks::all, settings.log_file) {}

  bool run(std::int64_t steps) {
    set_up();
    if (!melt() || !equilibrate())
      return false;
    put_walls();
    declare_slices();
    return drive(steps);
  }

 private:
  void set_up() {
    auto const& s = settings_;
    lammps_.command("units lj");
    lammps_.command("atom_style atomic");
    lammps_.command("lattice fcc {}", s.ahead.rho);
    lammps_.command("region box block 0 {0} 0 {0} 0 {1}", s.cells_across, s.cells_along);
    lammps_.command("create_box 1 box");
    lammps_.command("create_atoms 1 box");
    lammps_.command("mass 1 1.0");
    lammps_.command("pair_style {} {}", lammps_.has_style("pair", "lj/cut/opt") ? "lj/cut/opt" : "lj/cut",
                    s.cutoff);
    lammps_.command("pair_modify shift no tail no");
    lammps_.command("pair_coeff 1 1 1.0 1.0");
    lammps_.command("neighbor 0.4 bin");
    lammps_.command("neigh_modify every 2 delay 0 check yes");
    lammps_.command("compute_modify thermo_temp extra/dof 0");
    lammps_.command("thermo 100000");
  }

  bool thermalise(double T, std::int64_t steps, std::uint64_t purpose) {
    double const scale = 1 / std::sqrt(T);
    lammps_.command("timestep {}", thermal_step * scale);
    lammps_.command("fix bath all langevin {0} {0} {1} {2} gjf vhalf", T, friction_time * scale,
                    lammps_seed(settings_.seed, purpose));
    lammps_.command("fix move all nve");
    lammps_.command("run 0 post no");
    constexpr std::int64_t piece = 50;
    for (std::int64_t done = 0; done < steps; done += piece) {
      lammps_.command("run {} pre no post no", std::min(piece, steps - done));
      if (!told(std::min(piece, steps - done)))
        return false;
    }
    return true;
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
    lammps_.command("change_box all boundary p p sf"); // a piston asks for a face that follows the atoms
    lammps_.command("reset_timestep 0");
    lammps_.command("timestep {}", s.dt);
    lammps_.command("fix piston all wall/piston zlo pos 0.0 vel {} units box", s.v_P);
    lammps_.command("fix wall all wall/reflect zhi {} units box", s.length());
  }

  void declare_slices() {
    double const width = settings_.length() / settings_.slices();
    lammps_.command("compute slices all chunk/atom bin/1d z 0.0 {} units box bound z 0.0 {}", width,
                    settings_.length() - width / 2);
    lammps_.command("compute virial all stress/atom NULL virial");
    lammps_.command("variable one atom 1.0");
    lammps_.command("variable vz atom vz");
    lammps_.command("variable across atom vx*vx+vy*vy");
    lammps_.command("variable along atom vz*vz");
    for (auto const& [name, summed] : sums_)
      lammps_.command("compute {} all reduce/chunk slices sum {}", name, summed);
    std::string columns; // what is printed is tallied in the step
    for (auto const& [name, summed] : sums_)
      columns += fmt::format(" c_{}[1]", name);
    lammps_.command("thermo_style custom step temp{}", columns);
    lammps_.command("thermo {}", settings_.sample_every);
  }

  bool drive(std::int64_t steps) {
    lammps_.command("run 0 post no");
    for (std::int64_t done = settings_.sample_every; done <= steps; done += settings_.sample_every) {
      // The piston counts its time from the start of what LAMMPS is told to be one run.
      lammps_.command("run {} pre no post no start 0 stop {}", settings_.sample_every, steps);
      auto const slices = slices_at(done);
      if (!asked([&] { return !consumers_.slices || consumers_.slices(slices); }) ||
          !told(settings_.sample_every))
        return false;
    }
    return true;
  }

  std::vector<double> sum(std::string const& name) {
    std::vector<double> values;
    for (int s = 0; s < settings_.slices(); ++s)
      values.push_back(lammps_.compute(name, s));
    return values;
  }

  PistonSlices slices_at(std::int64_t step) {
    double const time = static_cast<double>(step) * settings_.dt;
    PistonSlices now{.step = step, .time = time, .piston = settings_.v_P * time};
    auto const number = sum("number"), vz = sum("vz"), across = sum("across"), along = sum("along"),
               virial = sum("zz");
    double const edge = settings_.cells_across * lattice_constant(settings_.ahead),
                 volume = edge * edge * settings_.length() / settings_.slices();
    for (std::size_t s = 0; s < number.size(); ++s) {
      double const n = number[s], v = n > 0 ? vz[s] / n : 0,
                   motion = n > 1 ? (along[s] - n * v * v) * n / (n - 1) : 0;
      now.velocity.push_back(v);
      now.T.push_back(n > 0 ? across[s] / (2 * n) : 0);
      now.P.push_back(n > 1 ? (motion - virial[s]) / volume : 0);
      if (!std::isfinite(now.P.back()))
        throw PhysicsError(fmt::format("the Lennard-Jones fluid before the piston became unstable at step {} "
                                       "with the time step {}",
                                       step, settings_.dt));
    }
    now.number = number;
    return now;
  }

  bool told(std::int64_t steps) {
    steps_done_ += steps;
    return asked([&] { return !consumers_.steps || consumers_.steps(steps_done_); });
  }

  /// The consumers of rank 0 are asked and all ranks obey.
  template <class Question>
  bool asked(Question const& question) {
    bool const answer = !world_.is_root() || question();
    return world_.root_says(answer);
  }

  MpiWorld const& world_;
  LjPistonSettings const& settings_;
  LjPistonConsumers const& consumers_;
  LammpsSession lammps_;
  /// Sums over the atoms of each slice, and what LAMMPS makes them of.
  std::vector<std::pair<std::string, std::string>> const sums_{{"number", "v_one"},
                                                               {"vz", "v_vz"},
                                                               {"across", "v_across"},
                                                               {"along", "v_along"},
                                                               {"zz", "c_virial[3]"}};
  std::int64_t steps_done_ = 0;
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
  constexpr double end_zone = 8; // in spacings
  return std::int64_t((length() - end_zone * spacing()) / (v_S * dt));
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
                      LjPistonConsumers const& consumers) {
  check(settings);
  return PistonRun(world, settings, consumers).run(steps);
}

} // namespace mesobridge::md
