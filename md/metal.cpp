#include "md/metal.hpp"
#include "md/canonical_run.hpp"
#include "md/seeds.hpp"
#include "md/units.hpp"
#include <algorithm>
#include <cmath>

namespace mesobridge::md {
namespace {

/// The temperature, in units of m c^2/k_B, at which a crystal of bulk sound speed c melts within a
/// picosecond. The melting points of Mg, Al, Fe, Cu, Sn and W lie between 0.004 and 0.016.
constexpr double surely_liquid = 0.05;
/// A lattice order above this is a crystal's.
constexpr double crystal_order = 0.3;

double number_density(double rho, MetalPotential const& potential) {
  return rho / potential.mass;
}

/// One run of one state: the steps of the protocol, in their order. LAMMPS works in its metal units.
class MetalRun {
 public:
  MetalRun(MpiWorld const& world, MetalState state, MetalSettings const& settings,
           MetalConsumers const& consumers, Log log)
      : state_(state), settings_(settings), consumers_(consumers),
        block_(settings.lattice, settings.least_atoms), scales_(scales_of(world, state.rho, settings, log)) {
    double const c = scales_.sound_speed;
    T_melt_ = std::max(1.5 * state.T, surely_liquid * settings.potential.mass * c * c / k_B);
    lammps_.emplace(world, Ranks::own, settings.log_file, Log::append);
  }

  std::optional<MetalEnd> run() {
    set_up();
    bool const to_the_end =
        (settings_.start == MetalStart::solid ? keep_crystal() : melt()) && equilibrate() && sample();
    return to_the_end ? std::optional(end()) : std::nullopt;
  }

 private:
  double time_step(double T) const { return scales_.time_step(T, settings_) / metal_units::time; }

  void set_up() {
    block_.create(*lammps_, settings_.potential, state_.rho);
    // The thermostat acts on all 3N momenta, those of the centre of mass too.
    lammps_->command("compute_modify thermo_temp extra/dof 0");
    lammps_->command("thermo {}", settings_.steps());
  }

  void set_temperature(double T, std::uint64_t purpose) {
    double const dt = time_step(T);
    set_bath(*lammps_, T, dt, settings_.friction_steps * dt, lammps_seed(settings_.seed, purpose));
    lammps_->command("run 0 post no");
  }

  bool keep_crystal() {
    // Atoms on their lattice sites: half of this energy becomes potential energy.
    lammps_->command("velocity all create {} {} dist gaussian", 2 * state_.T, lammps_seed(settings_.seed, 0));
    return true;
  }

  bool melt() {
    lammps_->command("velocity all create {} {} dist gaussian", 2 * T_melt_, lammps_seed(settings_.seed, 0));
    set_temperature(T_melt_, 1);
    if (!advance(settings_.melt_steps))
      return false;
    if (double const order = present_order(); order > crystal_order)
      throw PhysicsError(
          fmt::format("the crystal of {} at {} kg/m^3 did not melt at {:.0f} K in {} steps (lattice "
                      "order {:.2f}, a liquid has about {:.2f}): melt it longer",
                      settings_.potential.element, state_.rho, T_melt_, settings_.melt_steps, order,
                      1 / std::sqrt(block_.atoms())));
    lammps_->command("velocity all scale {}", state_.T);
    return true;
  }

  bool equilibrate() {
    lammps_->command("compute moved all msd com yes");
    set_temperature(state_.T, 2);
    return advance(settings_.equilibration_steps);
  }

  bool sample() {
    double const mass = block_.atoms() * settings_.potential.mass;
    for (std::int64_t done = settings_.sample_every; done <= settings_.sampling_steps;
         done += settings_.sample_every) {
      if (!advance(settings_.sample_every))
        return false;
      MetalSample const sample{
          .step = done,
          .T = lammps_->thermo("temp"),
          .e = lammps_->thermo("etotal") * metal_units::energy / mass - scales_.zero_of_e,
          .P = lammps_->thermo("press") * metal_units::pressure,
          .displacement_2 = lammps_->compute("moved", 3) * metal_units::length * metal_units::length};
      if (!std::isfinite(sample.e) || !std::isfinite(sample.P))
        fail("the energy or the pressure is no number");
      if (consumers_.samples && !consumers_.samples(sample))
        return false;
    }
    return true;
  }

  MetalEnd end() {
    return {.lattice_order = present_order(),
            .part_beyond_table = part_beyond_table(settings_.potential, lammps_->frame())};
  }

  double present_order() {
    Vec3 const planes = block_.plane_distances(number_density(state_.rho, settings_.potential));
    return lattice_order(lammps_->frame(), planes / metal_units::length);
  }

  bool advance(std::int64_t steps) {
    return run_in_pieces(
        steps, [&](std::int64_t n) { move(n); },
        [&](std::int64_t n) {
          steps_done_ += n;
          return !consumers_.steps || consumers_.steps(steps_done_);
        });
  }

  void move(std::int64_t steps) {
    try {
      lammps_->command("run {} pre no post no", steps);
    } catch (LammpsError const& error) {
      // What LAMMPS says when atoms fly apart; everything else is no matter of physics.
      std::string const text = error.what();
      for (char const* sign : {"Lost atoms", "Non-numeric", "Out of range atoms", "out of range"})
        if (text.find(sign) != std::string::npos)
          fail(text);
      throw;
    }
  }

  [[noreturn]] void fail(std::string const& why) const {
    throw PhysicsError(fmt::format(
        "the run of {} at {} kg/m^3, {} K became unstable at step {} with the time step "
        "{:.3g} fs ({}): a smaller --time-step helps if the state is in reason",
        settings_.potential.element, state_.rho, state_.T, steps_done_, 1000 * time_step(state_.T), why));
  }

  MetalState state_;
  MetalSettings const& settings_;
  MetalConsumers const& consumers_;
  CrystalBlock block_;
  MetalScales scales_;
  std::optional<LammpsSession> lammps_; // after the session that the scales come from
  double T_melt_ = 0;                   ///< [K]
  std::int64_t steps_done_ = 0;
};

} // namespace

double MetalScales::time_step(double T, MetalSettings const& settings) const {
  double const thermal = std::sqrt(k_B * T / settings.potential.mass);
  return settings.reduced_time_step * neighbour_distance / std::max(sound_speed, thermal);
}

MetalScales scales_of(MpiWorld const& world, double rho, MetalSettings const& settings, Log log) {
  MetalCrystal crystal(world, settings.potential, settings.lattice, settings.log_file, log);
  auto const ground = crystal.at_zero_pressure();
  CrystalBlock const block(settings.lattice, settings.least_atoms);
  return {.zero_of_e = ground.e,
          // An expanded crystal is soft or unstable, but its atoms still meet at the speed of the unexpanded
          // one's.
          .sound_speed = crystal.bulk_sound_speed(std::max(rho, ground.rho)),
          .neighbour_distance = block.neighbour_distance(number_density(rho, settings.potential))};
}

std::int64_t MetalSettings::steps() const {
  return (start == MetalStart::liquid ? melt_steps : 0) + equilibration_steps + sampling_steps;
}

std::string MetalSettings::description() const {
  auto const beginning =
      start == MetalStart::solid ? "from the crystal" : fmt::format("melted first ({} steps)", melt_steps);
  return fmt::format(
      "{} by {} ({}), NVT (Langevin, GJF), {} atoms of an {} lattice strained evenly, {}, time step {} "
      "d/c, {} + {} steps (equilibrate, sample), a sample every {}; e is 0 in the perfect {} crystal of "
      "zero pressure at rest",
      potential.element, potential.file.filename().string(), potential.style, atoms(), name_of(lattice),
      beginning, reduced_time_step, equilibration_steps, sampling_steps, sample_every, name_of(lattice));
}

MetalSettings metal_settings(Preset preset, MetalPotential const& potential) {
  MetalSettings settings{.potential = potential, .lattice = potential.lattice};
  if (preset == Preset::standard)
    settings.least_atoms = 864, settings.equilibration_steps = 4000, settings.sampling_steps = 60000;
  else if (preset == Preset::paper)
    settings.least_atoms = 4000, settings.melt_steps = 5000, settings.equilibration_steps = 10000,
    settings.sampling_steps = 100000;
  return settings;
}

void check(MetalState state, MetalSettings const& settings) {
  CrystalBlock const block(settings.lattice, settings.least_atoms);
  auto const& potential = settings.potential;
  double const reference = stated_density(potential);
  require(state.rho >= 0.5 * reference && state.rho <= 2 * reference, "density [kg/m^3]", state.rho,
          fmt::format("must be from half to twice that of the crystal, {:.0f} ... {:.0f}", 0.5 * reference,
                      2 * reference));
  require(state.T >= 10 && state.T <= 1e5, "temperature [K]", state.T, "must be in [10, 100000]");
  Vec3 const edges = block.edges(number_density(state.rho, potential));
  double const shortest = std::min({edges.x, edges.y, edges.z});
  require(shortest >= 2 * potential.cutoff, "atoms", block.atoms(),
          fmt::format(
              "too few: at {} kg/m^3 the box is {:.3g} nm wide and must be at least two cut-offs, {:.3g} nm",
              state.rho, 1e9 * shortest, 2e9 * potential.cutoff));
  require(settings.reduced_time_step > 0 && settings.reduced_time_step <= 0.1, "time step [d/c]",
          settings.reduced_time_step, "must be in (0, 0.1]");
  require(settings.friction_steps >= 10, "relaxation time of the velocities in steps",
          settings.friction_steps, "must be at least 10");
  require(settings.melt_steps > 0, "melt steps", settings.melt_steps, "must be > 0");
  check_steps(settings.equilibration_steps, settings.sampling_steps, settings.sample_every);
}

std::optional<MetalEnd> sample_metal(MpiWorld const& world, MetalState state, MetalSettings const& settings,
                                     MetalConsumers const& consumers, Log log) {
  check(state, settings);
  return MetalRun(world, state, settings, consumers, log).run();
}

} // namespace mesobridge::md
