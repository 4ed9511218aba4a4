#include "md/lj_fluid.hpp"
#include "md/canonical_run.hpp"
#include "md/lj_atoms.hpp"
#include "md/seeds.hpp"
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace mesobridge::md {
namespace {

/// Cells along each edge of the lattice that holds the atoms.
int cells_per_edge(int atoms) {
  return int(std::lround(std::cbrt(atoms / 4.0)));
}

double box_edge(LjState state, int atoms) {
  return std::cbrt(atoms / state.rho);
}

/// One run of one state: the steps of the protocol, in their order.
class LjRun {
 public:
  LjRun(MpiWorld const& world, Ranks ranks, LjState state, LjFluidSettings const& settings,
        LjFluidConsumers const& consumers, Log log)
      : world_(world), ranks_(ranks), state_(state), settings_(settings), consumers_(consumers),
        lammps_(world, ranks, settings.log_file, log) {}

  bool run() {
    set_up();
    return melt() && equilibrate() && sample();
  }

 private:
  void set_up() {
    int const cells = cells_per_edge(settings_.atoms);
    create_lj_atoms(lammps_, {.rho = state_.rho, .cells_across = cells, .cells_along = cells},
                    settings_.cutoff, settings_.tail);
    lammps_.command("thermo {}", settings_.steps());
  }

  void set_temperature(double T, std::uint64_t purpose) {
    double const scale = 1 / std::sqrt(T);
    set_bath(lammps_, T, settings_.reduced_time_step * scale, settings_.friction_time * scale,
             lammps_seed(settings_.seed, purpose));
    lammps_.command("run 0 post no");
  }

  bool melt() {
    double const T_melt = std::max(2 * state_.T, 10.0);
    lammps_.command("velocity all create {} {} dist gaussian", T_melt, lammps_seed(settings_.seed, 0));
    set_temperature(T_melt, 1);
    return advance(settings_.melt_steps);
  }

  bool equilibrate() {
    lammps_.command("velocity all scale {}", state_.T);
    set_temperature(state_.T, 2);
    if (!advance(settings_.equilibration_steps))
      return false;
    double const order = lattice_order(lammps_.frame(), std::cbrt(4 / state_.rho));
    if (order > 0.3)
      throw PhysicsError(
          fmt::format("the Lennard-Jones crystal at rho* = {}, T* = {} did not melt (lattice order {:.2f}, "
                      "a fluid has about {:.2f}): melt it longer or choose a fluid state",
                      state_.rho, state_.T, order, 1 / std::sqrt(settings_.atoms)));
    return true;
  }

  bool sample() {
    for (std::int64_t done = settings_.sample_every; done <= settings_.sampling_steps;
         done += settings_.sample_every) {
      if (!advance(settings_.sample_every))
        return false;
      ThermoSample const sample{done, lammps_.thermo("temp"), lammps_.thermo("etotal"),
                                lammps_.thermo("press")};
      if (!std::isfinite(sample.U) || !std::isfinite(sample.P))
        throw PhysicsError(
            fmt::format("the Lennard-Jones run at rho* = {}, T* = {} became unstable at step {} with the "
                        "time step {}",
                        state_.rho, state_.T, done, settings_.time_step(state_)));
      if (consumers_.thermo && !asked([&] { return consumers_.thermo(sample); }))
        return false;
      if (consumers_.frames && done % consumers_.frame_every == 0) {
        Frame const frame = lammps_.frame();
        if (!asked([&] { return consumers_.frames(frame); }))
          return false;
      }
    }
    return true;
  }

  bool advance(std::int64_t steps) {
    return run_in_pieces(
        steps, [&](std::int64_t n) { lammps_.command("run {} pre no post no", n); },
        [&](std::int64_t n) {
          steps_done_ += n;
          return !consumers_.steps || asked([&] { return consumers_.steps(steps_done_); });
        });
  }

  /// The consumers of rank 0 are asked and all ranks of the run obey.
  template <class Question>
  bool asked(Question const& question) {
    if (ranks_ == Ranks::own)
      return question();
    bool const answer = !world_.is_root() || question();
    return world_.root_says(answer);
  }

  MpiWorld const& world_;
  Ranks ranks_;
  LjState state_;
  LjFluidSettings const& settings_;
  LjFluidConsumers const& consumers_;
  LammpsSession lammps_;
  std::int64_t steps_done_ = 0;
};

} // namespace

double LjFluidSettings::time_step(LjState state) const {
  return reduced_time_step / std::sqrt(state.T);
}

std::string LjFluidSettings::description() const {
  return fmt::format(
      "Lennard-Jones fluid, NVT (Langevin, GJF), {} atoms, cut at {} sigma (not shifted), tail corrections "
      "{}, "
      "time step {}/sqrt(T*), {} + {} + {} steps (melt, equilibrate, sample), a sample every {} steps",
      atoms, cutoff, tail ? "on" : "off", reduced_time_step, melt_steps, equilibration_steps, sampling_steps,
      sample_every);
}

LjFluidSettings lj_fluid_settings(Preset preset) {
  LjFluidSettings settings;
  if (preset == Preset::standard)
    settings.atoms = 864, settings.cutoff = 4.0, settings.equilibration_steps = 3000,
    settings.sampling_steps = 40000;
  else if (preset == Preset::paper)
    settings.atoms = 4000, settings.cutoff = 4.0, settings.melt_steps = 2000,
    settings.equilibration_steps = 10000, settings.sampling_steps = 200000;
  return settings;
}

void check(LjState state, LjFluidSettings const& settings) {
  require(state.rho > 0 && state.rho <= 1.5, "density rho*", state.rho, "must be in (0, 1.5]");
  require(state.T >= 0.5 && state.T <= 1000, "temperature T*", state.T, "must be in [0.5, 1000]");
  int const cells = cells_per_edge(settings.atoms);
  require(cells >= 2 && 4 * cells * cells * cells == settings.atoms, "atoms", settings.atoms,
          "must be 4 n^3 (a cubic lattice): 32, 108, 256, 500, 864, 1372, 2048, 2916, 4000 ...");
  double const half_edge = box_edge(state, settings.atoms) / 2;
  require(settings.cutoff >= 2.5, "cut-off", settings.cutoff, "must be at least 2.5 sigma");
  require(settings.cutoff <= half_edge, "cut-off", settings.cutoff,
          fmt::format("must be at most half the box edge, {:.3f}, at rho* = {} with {} atoms", half_edge,
                      state.rho, settings.atoms));
  require(settings.reduced_time_step > 0 && settings.reduced_time_step <= 0.02, "time step times sqrt(T*)",
          settings.reduced_time_step, "must be in (0, 0.02]");
  require(settings.friction_time >= 10 * settings.reduced_time_step, "friction time times sqrt(T*)",
          settings.friction_time, "must be at least ten time steps");
  require(settings.melt_steps > 0, "melt steps", settings.melt_steps, "must be > 0");
  check_steps(settings.equilibration_steps, settings.sampling_steps, settings.sample_every);
}

double lattice_order(Frame const& frame, double lattice_constant) {
  return lattice_order(frame, Vec3{1, 1, 1} * (lattice_constant / 2));
}

double lattice_order(Frame const& frame, Vec3 plane_distances) {
  auto const along = [&](double Vec3::*axis) {
    double const distance = plane_distances.*axis;
    std::complex<double> sum;
    for (Vec3 const& q : frame.positions)
      sum += distance > 0 ? std::polar(1.0, 2 * std::numbers::pi / distance * (q.*axis)) : 0.0;
    return std::abs(sum) / double(frame.positions.size());
  };
  return std::max({along(&Vec3::x), along(&Vec3::y), along(&Vec3::z)});
}

bool sample_lj_fluid(MpiWorld const& world, Ranks ranks, LjState state, LjFluidSettings const& settings,
                     LjFluidConsumers const& consumers, Log log) {
  check(state, settings);
  require(consumers.frame_every > 0 && consumers.frame_every % settings.sample_every == 0,
          "steps between frames", consumers.frame_every, "must be a multiple of the steps between samples");
  return LjRun(world, ranks, state, settings, consumers, log).run();
}

} // namespace mesobridge::md
