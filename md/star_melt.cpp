#include "md/star_melt.hpp"
#include "md/canonical_run.hpp"
#include "md/held_molecules.hpp"
#include "md/seeds.hpp"
#include "md/star_checkpoint.hpp"
#include "md/star_system.hpp"
#include "md/star_width.hpp"
#include <algorithm>
#include <cmath>
#include <optional>

namespace mesobridge::md {
namespace {

/// How far the energy may go astray, in k_B T a bead. At the thesis's time step it moves by 1e-5.
constexpr double energy_tolerance = 0.01;
/// Steps between two looks at whether the user wants to stop.
constexpr std::int64_t piece = 100;

double lattice_spacing(StarMeltSettings const& settings) {
  // A melt thinner than the closest lattice starts at its own density.
  StarLattice const lattice{.star = settings.star, .molecules = settings.molecules, .spacing = 1};
  double const beads = double(settings.molecules) * settings.star.atoms();
  return std::max(touching_free_spacing(settings.star), std::cbrt(beads / settings.rho) / lattice.cells());
}

StarLattice lattice_of(StarMeltSettings const& settings) {
  return {.star = settings.star,
          .molecules = settings.molecules,
          .spacing = lattice_spacing(settings),
          .seed = settings.seed};
}

double beads_of(StarMeltSettings const& settings) {
  return double(settings.molecules) * settings.star.atoms();
}

/// One stretch of the run in a session of its own.
class Stretch {
 public:
  Stretch(MpiWorld const& world, StarMeltSettings const& settings, StarConsumers const& consumers,
          MeltStretch const& stretch, std::int64_t all_steps, std::optional<double>& first_energy)
      : world_(world), settings_(settings), consumers_(consumers), stretch_(stretch), all_steps_(all_steps),
        first_energy_(first_energy), lammps_(world, Ranks::all, settings.log_file(),
                                             stretch.first_step == 0 ? Log::replace : Log::append) {}

  bool run() {
    start();
    set_motion();
    bool on = true;
    explained(fmt::format("the {} melt at rho = {}", settings_.star.name(), settings_.rho), settings_.dt,
              [&] { on = advance(); });
    return on && (keep(), true);
  }

 private:
  void start() {
    prepare_for_stars(lammps_, settings_.star);
    if (stretch_.first_step == 0)
      create_stars(world_, lammps_, lattice_of(settings_), settings_.directory / "star-melt.data");
    else
      lammps_.command_with_file("read_restart", settings_.restart_file());
    set_star_forces(lammps_, settings_.star);
    lammps_.command("timestep {}", settings_.dt);
    lammps_.command("thermo {}", samples() ? settings_.sample_every : 10 * piece);
    if (stretch_.first_step == 0)
      lammps_.command("velocity all create {} {} dist gaussian", settings_.T, lammps_seed(settings_.seed, 1));
  }

  void set_motion() {
    lammps_.command("fix move all nve");
    if (stretch_.phase == MeltPhase::hold)
      hold();
    else if (stretch_.phase == MeltPhase::sample)
      lammps_.command("velocity all zero linear"); // exact zeros again after each reading
    else
      lammps_.command("fix bath all langevin {0} {0} {1} {2} zero yes", settings_.T, 1 / settings_.friction,
                      lammps_seed(settings_.seed, 1000 + std::uint64_t(stretch_.first_step)));
    if (stretch_.phase == MeltPhase::squeeze) {
      double const edge = std::cbrt(beads_of(settings_) / stretch_.rho);
      double const now = lammps_.thermo("lx"), middle = lammps_.thermo("xlo") + now / 2;
      double const low = middle - edge / 2, high = middle + edge / 2;
      lammps_.command("fix squeeze all deform 1 x final {0} {1} y final {0} {1} z final {0} {1} remap x "
                      "units box",
                      low, high);
    }
  }

  bool samples() const { return stretch_.phase == MeltPhase::sample || stretch_.phase == MeltPhase::hold; }

  void hold() {
    held_.emplace(world_, lammps_, settings_.molecules,
                  std::vector<double>(std::size_t(settings_.star.atoms()), 1.0));
    held_->stop();
    if (stretch_.begins)
      held_->set_temperature(settings_.T), first_energy_.reset();
    held_->hold();
  }

  bool advance() {
    std::int64_t const begin = stretch_.first_step, end = begin + stretch_.steps;
    std::int64_t const step = samples() ? settings_.sample_every : piece;
    for (std::int64_t done = begin; done < end;) {
      std::int64_t const next = std::min(step, end - done);
      lammps_.command("run {} pre {} post no start {} stop {}", next, done == begin ? "yes" : "no", begin,
                      end);
      done += next;
      if (samples())
        deliver();
      if (!asked(done))
        return false;
    }
    return true;
  }

  void deliver() {
    auto frame = collect_molecules(world_, lammps_, settings_.molecules, settings_.star.atoms());
    if (held_)
      held_->put_back(frame);
    if (!first_energy_)
      first_energy_ = frame.energy;
    double const astray = std::abs(frame.energy - *first_energy_) / (beads_of(settings_) * settings_.T);
    if (!(astray <= energy_tolerance)) // a NaN too
      throw PhysicsError(fmt::format("the {} melt at rho = {} does not keep its energy: by step {} it went "
                                     "astray by {:.3g} k_B T a bead at the time step {}. Take a shorter --dt",
                                     settings_.star.name(), settings_.rho, frame.step, astray, settings_.dt));
    if (consumers_.frames)
      consumers_.frames(frame);
  }

  bool asked(std::int64_t done) {
    if (world_.size() == 1)
      return !consumers_.steps || consumers_.steps(done, all_steps_);
    return world_.root_says(!world_.is_root() || !consumers_.steps || consumers_.steps(done, all_steps_));
  }

  void keep() { write_checkpoint(world_, lammps_, settings_.restart_file(), consumers_.checkpoint); }

  MpiWorld const& world_;
  StarMeltSettings const& settings_;
  StarConsumers const& consumers_;
  MeltStretch stretch_;
  std::int64_t all_steps_;
  std::optional<double>& first_energy_;
  LammpsSession lammps_;
  std::optional<HeldMolecules> held_;
};

} // namespace

std::string StarMeltSettings::fingerprint() const {
  return fmt::format(
      "{}, {} molecules, rho = {}, T = {}, Langevin friction {}, "
      "time step {}, squeezed by {} in {} steps, {} steps of equilibration, a sample every {} steps, a "
      "checkpoint every {}, seed {}",
      md::fingerprint(star), molecules, rho, T, friction, dt, squeeze, squeeze_steps, equilibration_steps,
      sample_every, checkpoint_every, seed);
}

void check(StarMeltSettings const& settings) {
  check(settings.star);
  require(settings.molecules >= 8 && settings.molecules <= 1000000, "molecules", settings.molecules,
          "must be 8 ... 1000000");
  require(settings.rho > 0 && settings.rho <= 0.7, "density rho [beads/sigma^3]", settings.rho,
          "must be in (0, 0.7]");
  require(settings.T >= 0.1 && settings.T <= 10, "temperature T", settings.T, "must be 0.1 ... 10");
  require(settings.friction > 0 && settings.friction <= 100, "friction of the thermostat", settings.friction,
          "must be in (0, 100]");
  require(settings.dt > 0 && settings.dt <= 0.02, "time step", settings.dt,
          "must be in (0, 0.02]; the thesis takes 0.001");
  require(settings.squeeze > 1 && settings.squeeze <= 2, "growth of the density at once", settings.squeeze,
          "must be in (1, 2]");
  require(settings.squeeze_steps >= 200, "steps of a squeeze", settings.squeeze_steps,
          "must be at least 200");
  check_steps(settings.equilibration_steps, settings.sampling_steps, settings.sample_every);
  require(settings.sampling_steps % settings.sample_every == 0, "sampling steps", settings.sampling_steps,
          "must be a multiple of the steps between samples");
  require(settings.checkpoint_every > 0 && settings.checkpoint_every % settings.sample_every == 0,
          "steps between checkpoints", settings.checkpoint_every,
          "must be a multiple of the steps between samples");
  double const edge = std::cbrt(beads_of(settings) / settings.rho);
  double const smallest = smallest_edge(settings.star, settings.T);
  require(
      edge > smallest, "molecules", settings.molecules,
      fmt::format("the box has the edge {:.4g}; for {} stars it must be over {:.4g}, so that half the box "
                  "holds one and none meets its own image: take more molecules",
                  edge, settings.star.name(), smallest));
}

std::vector<MeltStretch> plan(StarMeltSettings const& settings) {
  std::vector<MeltStretch> stretches;
  std::int64_t step = 0;
  auto const add = [&](MeltPhase phase, std::int64_t steps, double rho) {
    stretches.push_back({.phase = phase, .first_step = step, .steps = steps, .rho = rho});
    step += steps;
  };
  auto const in_pieces = [&](MeltPhase phase, std::int64_t steps) {
    for (std::int64_t left = steps; left > 0; left -= settings.checkpoint_every)
      add(phase, std::min(left, settings.checkpoint_every), settings.rho);
  };
  double const start = beads_of(settings) / std::pow(lattice_of(settings).edge(), 3);
  int const growths =
      std::max(0, int(std::ceil(std::log(settings.rho / start) / std::log(settings.squeeze) - 1e-9)));
  for (int k = 1; k <= growths; ++k) {
    double const rho =
        k == growths ? settings.rho : start * std::pow(settings.rho / start, double(k) / growths);
    add(MeltPhase::squeeze, settings.squeeze_steps / 2, rho);
    add(MeltPhase::rest, settings.squeeze_steps - settings.squeeze_steps / 2, rho);
  }
  in_pieces(MeltPhase::equilibrate, settings.equilibration_steps);
  in_pieces(MeltPhase::sample, settings.sampling_steps);
  return stretches;
}

std::int64_t frames_of(StarMeltSettings const& settings) {
  return settings.sampling_steps / settings.sample_every;
}

bool run_stretches(MpiWorld const& world, StarMeltSettings const& settings,
                   std::vector<MeltStretch> const& stretches, bool resume, std::string const& why,
                   StarConsumers const& consumers) {
  std::int64_t const done = step_to_begin_at(world, settings, stretches, resume, why);
  std::optional<double> first_energy;
  for (auto const& stretch : stretches)
    if (stretch.first_step >= done &&
        !Stretch(world, settings, consumers, stretch, steps_of(stretches), first_energy).run())
      return false;
  return true;
}

bool sample_star_melt(MpiWorld const& world, StarMeltSettings const& settings, bool resume,
                      StarConsumers const& consumers) {
  check(settings);
  return run_stretches(
      world, settings, plan(settings), resume,
      fmt::format("resume with a length that is a multiple of {} steps", settings.checkpoint_every),
      consumers);
}

} // namespace mesobridge::md
