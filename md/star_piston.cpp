#include "md/star_piston.hpp"
#include "md/seeds.hpp"
#include "md/star_system.hpp"
#include "md/star_width.hpp"
#include <algorithm>
#include <cmath>

namespace mesobridge::md {
namespace {

constexpr double end_zone = 8; // in spacings, as in steps_to_far_end

double first_spacing(StarPistonSettings const& settings) {
  return std::max(touching_free_spacing(settings.star), settings.spacing());
}

/// A growth of the density at once: the lattice's spacing after it, and in how many steps.
struct Squeeze {
  double spacing;
  std::int64_t steps;
};

/// In so many steps that lists of neighbours keep up with the beads at the ends of a long box.
std::vector<Squeeze> squeezes(StarPistonSettings const& s) {
  constexpr double longest_way = 0.02; // of a bead in a step [sigma]
  double const first = first_spacing(s), ratio = std::pow(first / s.spacing(), 3);
  int const times = int(std::ceil(std::log(ratio) / std::log(s.squeeze) - 1e-9));
  std::vector<Squeeze> all;
  for (int k = 1; k <= times; ++k) {
    double const before = all.empty() ? first : all.back().spacing,
                 after = first * std::pow(ratio, -double(k) / times / 3);
    all.push_back(
        {after, std::max(s.squeeze_steps / 2, std::int64_t(s.along * (before - after) / 2 / longest_way))});
  }
  return all;
}

/// One run, in the order of its steps.
class StarPistonRun {
 public:
  StarPistonRun(MpiWorld const& world, StarPistonSettings const& settings, PistonConsumers const& consumers)
      : world_(world), settings_(settings), lammps_(world, Ranks::all, settings.log_file),
        drive_(world, lammps_, box_of(settings), {}, consumers) {}

  bool run(std::int64_t steps) {
    set_up();
    bool on = true;
    explained(what(), settings_.dt, shorter_step_of_stars, [&] {
      on = squeeze() && equilibrate();
      if (on)
        put_walls(), on = drive_.drive(steps, what());
    });
    return on;
  }

 private:
  std::string what() const {
    return fmt::format("the melt of {} stars before the piston", settings_.star.name());
  }

  void set_up() {
    auto const& s = settings_;
    prepare_for_stars(lammps_, s.star);
    lammps_.command("boundary p p f");
    create_stars(world_, lammps_,
                 {.star = s.star,
                  .molecules = int(s.molecules()),
                  .spacing = first_spacing(s),
                  .seed = s.seed,
                  .across = s.across},
                 s.log_file.parent_path() / "star-piston.data");
    set_star_forces(lammps_, s.star);
    lammps_.command("timestep {}", s.dt);
    lammps_.command("thermo 100000");
    lammps_.command("velocity all create {} {} dist gaussian", s.T, lammps_seed(s.seed, 1));
    lammps_.command("fix move all nve");
    lammps_.command("fix bath all langevin {0} {0} {1} {2} zero yes", s.T, 1 / s.friction,
                    lammps_seed(s.seed, 2));
    lammps_.command("variable lower equal zlo"); // EDGE would be where the box ends now
    lammps_.command("variable upper equal zhi");
    lammps_.command("fix ends all wall/reflect zlo v_lower zhi v_upper units box");
  }

  /// The box shrinks about its middle, and the beads with it; after each time it rests.
  bool squeeze() {
    double const middle = settings_.along * first_spacing(settings_) / 2;
    for (auto const& one : squeezes(settings_)) {
      double const half = settings_.along * one.spacing / 2;
      lammps_.command(
          "fix squeeze all deform 1 x final 0 {0} y final 0 {0} z final {1} {2} remap x units box",
          settings_.across * one.spacing, middle - half, middle + half);
      if (!drive_.settle(one.steps))
        return false;
      lammps_.command("unfix squeeze");
      if (!drive_.settle(settings_.squeeze_steps / 2))
        return false;
    }
    return true;
  }

  bool equilibrate() { return drive_.settle(settings_.equilibration_steps); }

  void put_walls() {
    auto const& s = settings_;
    lammps_.command("unfix bath");
    lammps_.command("unfix ends");
    lammps_.command("velocity all zero linear");
    lammps_.command("change_box all z final 0 {} remap units box", s.length());
    drive_.put_walls();
  }

  static PistonBox box_of(StarPistonSettings const& s) {
    double const edge = s.across * s.spacing();
    return {.length = s.length(),
            .area = edge * edge,
            .v_P = s.v_P,
            .dt = s.dt,
            .slices = s.slices(),
            .sample_every = s.sample_every,
            .atoms_per_molecule = s.star.atoms(),
            .end = s.length() - end_zone * s.spacing()};
  }

  MpiWorld const& world_;
  StarPistonSettings const& settings_;
  LammpsSession lammps_;
  PistonDrive drive_;
};

} // namespace

double StarPistonSettings::spacing() const {
  return std::cbrt(star.atoms() / rho);
}

double StarPistonSettings::length() const {
  return along * spacing();
}

std::int64_t StarPistonSettings::steps_before() const {
  std::int64_t steps = equilibration_steps;
  for (auto const& one : squeezes(*this))
    steps += one.steps + squeeze_steps / 2;
  return steps;
}

std::int64_t StarPistonSettings::steps(double v_S) const {
  return steps_to_far_end(length(), spacing(), v_S, dt);
}

std::string StarPistonSettings::description() const {
  return fmt::format(
      "Melt of {} stars at rho = {}, T = {} before a piston at v = {}, {} molecules of {} beads in a "
      "box {} x {} x {} molecules, time step {}, seed {}",
      star.name(), rho, T, v_P, molecules(), star.atoms(), across, across, along, dt, seed);
}

StarPistonSettings star_piston_settings(Preset preset) {
  StarPistonSettings settings;
  if (preset == Preset::standard)
    settings.across = 8, settings.along = 160;
  else if (preset == Preset::paper)
    settings.across = 12, settings.along = 300, settings.dt = 0.002, settings.sample_every = 100,
    settings.equilibration_steps = 100000;
  return settings;
}

void check(StarPistonSettings const& settings) {
  check(settings.star);
  require(settings.rho > 0 && settings.rho <= 0.7, "density rho [beads/sigma^3]", settings.rho,
          "must be in (0, 0.7]");
  require(settings.T >= 0.1 && settings.T <= 10, "temperature T", settings.T, "must be 0.1 ... 10");
  require(settings.v_P > 0 && settings.v_P <= 10, "velocity of the piston v", settings.v_P,
          "must be in (0, 10]");
  require(settings.across >= 2 && settings.across <= 1000, "molecules across", settings.across,
          "must be in [2, 1000]");
  require(settings.along >= 10 && settings.along <= 10000, "molecules along", settings.along,
          "must be in [10, 10000]");
  require(settings.molecules() <= 1000000, "molecules", settings.molecules(), "must be at most 1000000");
  require(settings.friction > 0 && settings.friction <= 100, "friction of the thermostat", settings.friction,
          "must be in (0, 100]");
  require(settings.dt > 0 && settings.dt <= 0.02, "time step", settings.dt, "must be in (0, 0.02]");
  require(settings.sample_every > 0, "steps between samples", settings.sample_every, "must be > 0");
  require(settings.squeeze > 1 && settings.squeeze <= 2, "growth of the density at once", settings.squeeze,
          "must be in (1, 2]");
  require(settings.squeeze_steps >= 200, "steps of a squeeze", settings.squeeze_steps,
          "must be at least 200");
  require(settings.equilibration_steps > 0, "equilibration steps", settings.equilibration_steps,
          "must be > 0");
  double const edge = settings.across * settings.spacing(),
               smallest = smallest_edge(settings.star, settings.T);
  require(edge > smallest, "molecules across", settings.across,
          fmt::format("the box has the edge {:.4g} across; for {} stars it must be over {:.4g}, so that none "
                      "meets its own image: take more",
                      edge, settings.star.name(), smallest));
}

bool sample_star_piston(MpiWorld const& world, StarPistonSettings const& settings, std::int64_t steps,
                        PistonConsumers const& consumers) {
  check(settings);
  return StarPistonRun(world, settings, consumers).run(steps);
}

} // namespace mesobridge::md
