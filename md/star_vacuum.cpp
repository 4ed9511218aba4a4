#include "md/star_vacuum.hpp"
#include "md/seeds.hpp"
#include "md/star_checkpoint.hpp"
#include "md/star_system.hpp"
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace mesobridge::md {
namespace {

/// Steps between two looks at whether the user wants to stop.
constexpr std::int64_t piece = 250;
/// Cells are this much wider than straight arms need: bonds stretch.
constexpr double room = 1.4;
/// Bins of the neighbour search [sigma]: the box is nearly empty, and narrow bins would be most of the work.
constexpr double bin_size = 3;

/// A number of the unit normal distribution, a pure function of its arguments (Box and Muller).
double normal(std::uint64_t seed, std::uint64_t step, std::uint64_t number) {
  std::uint64_t const key = mix(mix(seed, step), number);
  double const u = (double(mix(key, 0) >> 11) + 1) * 0x1p-53, w = double(mix(key, 1) >> 11) * 0x1p-53;
  return std::sqrt(-2 * std::log(u)) * std::cos(2 * std::numbers::pi * w);
}

/// A molecule's new velocities at temperature T, without total momentum. All masses are 1.
std::vector<Vec3> drawn(std::uint64_t seed, std::int64_t step, std::int64_t molecule, int atoms, double T) {
  std::vector<Vec3> v(std::size_t(atoms), Vec3{});
  Vec3 mean;
  for (std::size_t i = 0; i < v.size(); ++i) {
    auto const first = 3 * (std::uint64_t(molecule) * v.size() + i);
    v[i] = std::sqrt(T) * Vec3{normal(seed, std::uint64_t(step), first),
                               normal(seed, std::uint64_t(step), first + 1),
                               normal(seed, std::uint64_t(step), first + 2)};
    mean += v[i] / atoms;
  }
  for (Vec3& velocity : v)
    velocity -= mean;
  return v;
}

enum class Phase {
  thermalise, ///< to the set temperature, or to one near that of the set energy
  settle,     ///< without the thermostat, once the energies are set
  sample
};

/// A part of the run between two checkpoints.
struct Stretch {
  Phase phase = Phase::sample;
  std::int64_t first_step = 0, steps = 0;
  std::int64_t since = 0; ///< the steps of its phase that lie before it
};

/// The whole run. Every stretch starts from a checkpoint file, of the unbroken run too, so that a resumed run
/// equals it bit for bit.
std::vector<Stretch> stretches_of(StarVacuumSettings const& settings) {
  std::vector<Stretch> stretches;
  std::int64_t step = 0;
  auto const add = [&](Phase phase, std::int64_t steps) {
    for (std::int64_t since = 0; since < steps;) {
      std::int64_t const next = std::min(steps - since, settings.checkpoint_every);
      stretches.push_back({.phase = phase, .first_step = step, .steps = next, .since = since});
      since += next, step += next;
    }
  };
  add(Phase::thermalise, settings.equilibration_steps);
  if (settings.ensemble == VacuumEnsemble::microcanonical)
    add(Phase::settle, settings.equilibration_steps);
  add(Phase::sample, settings.sampling_steps);
  return stretches;
}

/// One stretch of the run in a session of its own.
class VacuumStretch {
 public:
  VacuumStretch(MpiWorld const& world, StarVacuumSettings const& settings, StarConsumers const& consumers,
                Stretch const& stretch, std::int64_t all_steps)
      : world_(world), settings_(settings), consumers_(consumers), stretch_(stretch), all_steps_(all_steps),
        atoms_(settings.star.atoms()), lammps_(world, Ranks::all, settings.log_file(),
                                               stretch.first_step == 0 ? Log::replace : Log::append) {}

  bool run() {
    start();
    if (stretch_.phase == Phase::settle && stretch_.since == 0)
      set_energies();
    bool on = true;
    explained(fmt::format("the run of isolated {} stars", settings_.star.name()), settings_.dt,
              shorter_step_of_stars, [&] { on = advance(); });
    if (on)
      write_checkpoint(world_, lammps_, settings_.restart_file(), consumers_.checkpoint);
    return on;
  }

 private:
  void start() {
    prepare_for_stars(lammps_, settings_.star);
    if (stretch_.first_step == 0) {
      StarLattice const lattice{.star = settings_.star,
                                .molecules = settings_.molecules,
                                .spacing = room * touching_free_spacing(settings_.star),
                                .seed = settings_.seed};
      create_stars(world_, lammps_, lattice, settings_.directory / (settings_.stem() + ".data"));
    } else {
      lammps_.command_with_file("read_restart", settings_.restart_file());
    }
    set_star_forces(lammps_, settings_.star);
    lammps_.command("neigh_modify binsize {}", bin_size);
    lammps_.command("timestep {}", settings_.dt);
    lammps_.command("thermo {}", settings_.sample_every);
    lammps_.command("fix move all nve");
    lammps_.command("run 0 post no");
  }

  bool thermostat() const {
    return stretch_.phase == Phase::thermalise ||
           (stretch_.phase == Phase::sample && settings_.ensemble == VacuumEnsemble::canonical);
  }

  /// The temperature at which a molecule is brought to equilibrium: for a set energy that of a harmonic one.
  double temperature(std::int64_t molecule) const {
    double const level = settings_.level(molecule);
    return settings_.ensemble == VacuumEnsemble::canonical ? level : level / (3 * atoms_ - 3);
  }

  void redraw(std::int64_t step) {
    std::int64_t molecule = -1;
    std::vector<Vec3> v;
    lammps_.set_velocities([&](std::int64_t id, Vec3 const&) {
      if (std::int64_t const owner = (id - 1) / atoms_; owner != molecule) {
        molecule = owner;
        v = drawn(settings_.seed, step, molecule, atoms_, temperature(molecule));
      }
      return v[std::size_t((id - 1) % atoms_)];
    });
  }

  void set_energies() {
    auto const frame = collect_molecules(world_, lammps_, settings_.molecules, atoms_);
    std::vector<double> factors;
    for (int m = 0; m < frame.molecules; ++m) {
      double kinetic = 0, potential = 0;
      for (std::size_t i = std::size_t(m) * std::size_t(atoms_); i < std::size_t(m + 1) * std::size_t(atoms_);
           ++i) {
        kinetic += norm2(frame.v[i]) / 2;
        potential += frame.potential[i];
      }
      double const energy = settings_.level(frame.first_molecule + m);
      if (!(energy > potential))
        throw PhysicsError(fmt::format("the energy {} set for a {} star is below its potential energy {:.4g} "
                                       "when it was brought to T = {:.3g}: set a higher one",
                                       energy, settings_.star.name(), potential,
                                       temperature(frame.first_molecule + m)));
      factors.push_back(std::sqrt((energy - potential) / kinetic));
    }
    auto const all = world_.root_gives(world_.gather_at_root(factors));
    lammps_.set_velocities(
        [&](std::int64_t id, Vec3 const& v) { return all[std::size_t((id - 1) / atoms_)] * v; });
  }

  bool advance() {
    bool on = true;
    std::int64_t const end = stretch_.since + stretch_.steps; // both count the steps of the phase
    for (std::int64_t done = stretch_.since; done < end && on;) {
      std::int64_t next = std::min(piece, end - done);
      next = std::min(next, settings_.sample_every - done % settings_.sample_every);
      if (thermostat()) {
        if (done % settings_.redraw_every == 0)
          redraw(lammps_.step());
        next = std::min(next, settings_.redraw_every - done % settings_.redraw_every);
      }
      lammps_.command("run {} pre no post no", next);
      done += next;
      if (stretch_.phase == Phase::sample && done % settings_.sample_every == 0)
        deliver();
      on = asked(stretch_.first_step + done - stretch_.since);
    }
    return on;
  }

  void deliver() {
    auto const frame = collect_molecules(world_, lammps_, settings_.molecules, atoms_);
    if (!std::isfinite(frame.energy))
      throw PhysicsError(
          fmt::format("the run of isolated {} stars became unstable by step {} at the time step "
                      "{}. Take a shorter --dt",
                      settings_.star.name(), frame.step, settings_.dt));
    if (consumers_.frames)
      consumers_.frames(frame);
  }

  bool asked(std::int64_t done) {
    auto const answer = [&] { return !consumers_.steps || consumers_.steps(done, all_steps_); };
    return world_.size() == 1 ? answer() : world_.root_says(!world_.is_root() || answer());
  }

  MpiWorld const& world_;
  StarVacuumSettings const& settings_;
  StarConsumers const& consumers_;
  Stretch stretch_;
  std::int64_t all_steps_;
  int atoms_;
  LammpsSession lammps_;
};

} // namespace

bool sample_star_vacuum(MpiWorld const& world, StarVacuumSettings const& settings, bool resume,
                        StarConsumers const& consumers) {
  check(settings);
  auto const stretches = stretches_of(settings);
  Checkpoint const checkpoint{
      .restart_file = settings.restart_file(),
      .log_file = settings.log_file(),
      .prepare = [&](LammpsSession& lammps) { prepare_for_stars(lammps, settings.star); }};
  std::int64_t const done =
      step_to_begin_at(world, checkpoint, stretches, resume, "it was made with other settings");
  for (auto const& stretch : stretches)
    if (stretch.first_step >= done &&
        !VacuumStretch(world, settings, consumers, stretch, steps_of(stretches)).run())
      return false;
  return true;
}

} // namespace mesobridge::md
