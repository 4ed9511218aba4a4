#include "md/star_vacuum.hpp"
#include "md/seeds.hpp"
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

class VacuumRun {
 public:
  VacuumRun(MpiWorld const& world, StarVacuumSettings const& settings, StarVacuumConsumers const& consumers)
      : world_(world), settings_(settings), consumers_(consumers), atoms_(settings.star.atoms()),
        lammps_(world, Ranks::all, settings.directory / "lammps-vacuum.log") {}

  bool run() {
    set_up();
    bool const canonical = settings_.ensemble == VacuumEnsemble::canonical;
    if (!advance(settings_.equilibration_steps, true, false))
      return false;
    if (!canonical) {
      set_energies();
      if (!advance(settings_.equilibration_steps, false, false))
        return false;
    }
    return advance(settings_.sampling_steps, canonical, true);
  }

 private:
  void set_up() {
    prepare_for_stars(lammps_, settings_.star);
    StarLattice const lattice{.star = settings_.star,
                              .molecules = settings_.molecules,
                              .spacing = room * touching_free_spacing(settings_.star),
                              .seed = settings_.seed};
    create_stars(world_, lammps_, lattice, settings_.directory / "star-vacuum.data");
    set_star_forces(lammps_, settings_.star);
    lammps_.command("neigh_modify binsize {}", bin_size);
    lammps_.command("timestep {}", settings_.dt);
    lammps_.command("thermo {}", settings_.sample_every);
    lammps_.command("fix move all nve");
    all_steps_ = settings_.equilibration_steps + settings_.sampling_steps;
    if (settings_.ensemble == VacuumEnsemble::microcanonical)
      all_steps_ += settings_.equilibration_steps;
    lammps_.command("run 0 post no");
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

  bool advance(std::int64_t steps, bool thermostat, bool sampling) {
    bool on = true;
    explained(fmt::format("the run of isolated {} stars", settings_.star.name()), settings_.dt, [&] {
      for (std::int64_t done = 0; done < steps && on;) {
        if (thermostat && done % settings_.redraw_every == 0)
          redraw(steps_done_);
        std::int64_t next = std::min(piece, steps - done);
        next = std::min(next, settings_.sample_every - done % settings_.sample_every);
        if (thermostat)
          next = std::min(next, settings_.redraw_every - done % settings_.redraw_every);
        lammps_.command("run {} pre no post no", next);
        done += next, steps_done_ += next;
        if (sampling && done % settings_.sample_every == 0)
          deliver();
        on = asked();
      }
    });
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

  bool asked() {
    auto const answer = [&] { return !consumers_.steps || consumers_.steps(steps_done_, all_steps_); };
    return world_.size() == 1 ? answer() : world_.root_says(!world_.is_root() || answer());
  }

  MpiWorld const& world_;
  StarVacuumSettings const& settings_;
  StarVacuumConsumers const& consumers_;
  int atoms_;
  LammpsSession lammps_;
  std::int64_t steps_done_ = 0, all_steps_ = 0;
};

} // namespace

std::string StarVacuumSettings::fingerprint() const {
  return fmt::format(
      "{} star (k = {}, l = {}, {}{}) in vacuum, {} at {:g}, {} molecules, time step {}, "
      "velocities drawn every {} steps, {} + {} steps, a sample every {} steps, seed {}",
      star.name(), star.k, star.arm_length, star.centre_length, star.repulsion ? ", WCA" : ", no repulsion",
      ensemble == VacuumEnsemble::canonical ? "canonical" : "microcanonical", fmt::join(levels, ", "),
      molecules, dt, redraw_every, equilibration_steps, sampling_steps, sample_every, seed);
}

void check(StarVacuumSettings const& settings) {
  check(settings.star);
  require(settings.star.atoms() >= 3, "atoms of a star", settings.star.atoms(), "must be at least 3");
  require(!settings.levels.empty(), "temperatures or energies", settings.levels.size(),
          "at least one is needed");
  for (double level : settings.levels)
    require(level > 0 && std::isfinite(level), "temperature or energy", level, "must be > 0");
  require(settings.molecules >= int(settings.levels.size()) && settings.molecules <= 1000000, "molecules",
          settings.molecules, "must be at least one a temperature or energy, at most 1000000");
  require(settings.dt > 0 && settings.dt <= 0.02, "time step", settings.dt,
          "must be in (0, 0.02]; the thesis takes 0.001");
  require(settings.redraw_every > 0, "steps between draws of the velocities", settings.redraw_every,
          "must be > 0");
  require(settings.equilibration_steps > 0, "equilibration steps", settings.equilibration_steps,
          "must be > 0");
  require(settings.sample_every > 0, "steps between samples", settings.sample_every, "must be > 0");
  require(settings.sampling_steps >= settings.sample_every, "sampling steps", settings.sampling_steps,
          "must be at least the steps between samples");
}

bool sample_star_vacuum(MpiWorld const& world, StarVacuumSettings const& settings,
                        StarVacuumConsumers const& consumers) {
  check(settings);
  return VacuumRun(world, settings, consumers).run();
}

} // namespace mesobridge::md
