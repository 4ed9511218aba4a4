#include "md/star_melt.hpp"
#include "md/star_checkpoint.hpp"
#include "md/star_system.hpp"
#include "md/star_width.hpp"
#include <algorithm>
#include <cmath>

namespace mesobridge::md {
namespace {

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

MeltProtocol protocol_of(StarMeltSettings const& s) {
  auto protocol = protocol_of_run(s);
  protocol.rho = s.rho, protocol.T = s.T, protocol.friction = s.friction, protocol.dt = s.dt;
  return protocol;
}

double first_density_of(StarMeltSettings const& settings) {
  return beads_of(settings) / std::pow(lattice_of(settings).edge(), 3);
}

/// Stars on a dilute lattice at first.
class StarSystem final : public MeltSystem {
 public:
  explicit StarSystem(StarMeltSettings const& settings) : settings_(settings) {}

  std::string name() const override { return settings_.star.name(); }
  int molecules() const override { return settings_.molecules; }
  int atoms_per_molecule() const override { return settings_.star.atoms(); }
  std::vector<double> masses() const override {
    return std::vector<double>(std::size_t(settings_.star.atoms()), 1.0);
  }
  double first_density() const override { return first_density_of(settings_); }
  Vec3 edges(double rho) const override {
    double const edge = std::cbrt(beads_of(settings_) / rho);
    return {edge, edge, edge};
  }
  void prepare(LammpsSession& lammps) const override { prepare_for_stars(lammps, settings_.star); }
  void create(MpiWorld const& world, LammpsSession& lammps) const override {
    create_stars(world, lammps, lattice_of(settings_), settings_.directory / "star-melt.data");
  }
  void set_forces(LammpsSession& lammps) const override { set_star_forces(lammps, settings_.star); }
  std::string shorter_step() const override { return shorter_step_of_stars; }

 private:
  StarMeltSettings const& settings_;
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
  check_run(protocol_of(settings));
  double const edge = std::cbrt(beads_of(settings) / settings.rho);
  double const smallest = smallest_edge(settings.star, settings.T);
  require(
      edge > smallest, "molecules", settings.molecules,
      fmt::format("the box has the edge {:.4g}; for {} stars it must be over {:.4g}, so that half the box "
                  "holds one and none meets its own image: take more molecules",
                  edge, settings.star.name(), smallest));
}

std::vector<MeltStretch> plan(StarMeltSettings const& settings) {
  return plan(protocol_of(settings), first_density_of(settings));
}

std::int64_t frames_of(StarMeltSettings const& settings) {
  return settings.sampling_steps / settings.sample_every;
}

bool run_stretches(MpiWorld const& world, StarMeltSettings const& settings,
                   std::vector<MeltStretch> const& stretches, bool resume, std::string const& why,
                   StarConsumers const& consumers) {
  return run_stretches(world, StarSystem(settings), protocol_of(settings), stretches, resume, why, consumers);
}

bool sample_star_melt(MpiWorld const& world, StarMeltSettings const& settings, bool resume,
                      StarConsumers const& consumers) {
  check(settings);
  return sample_melt(world, StarSystem(settings), protocol_of(settings), resume, consumers);
}

} // namespace mesobridge::md
