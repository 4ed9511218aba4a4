#include "md/melt_run.hpp"
#include "md/canonical_run.hpp"
#include "md/held_molecules.hpp"
#include "md/seeds.hpp"
#include "md/star_checkpoint.hpp"
#include "md/star_system.hpp"
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace mesobridge::md {
namespace {

/// How far the energy may go astray, in k_B T an atom. At the thesis's time step it moves by 1e-5.
constexpr double energy_tolerance = 0.01;
/// Steps between two looks at whether the user wants to stop.
constexpr std::int64_t piece = 100;

/// One stretch of the run in a session of its own.
class Stretch {
 public:
  Stretch(MpiWorld const& world, MeltSystem const& system, MeltProtocol const& protocol,
          StarConsumers const& consumers, MeltStretch const& stretch, std::int64_t all_steps,
          std::optional<double>& first_energy)
      : world_(world), system_(system), protocol_(protocol), consumers_(consumers), stretch_(stretch),
        all_steps_(all_steps), first_energy_(first_energy),
        lammps_(world, Ranks::all, protocol.log_file, stretch.first_step == 0 ? Log::replace : Log::append) {}

  bool run() {
    if (!start())
      return false;
    set_motion();
    bool on = true;
    explained(fmt::format("the {} melt at rho = {}", system_.name(), protocol_.rho), protocol_.dt,
              system_.shorter_step(), [&] { on = advance(); });
    return on && (keep(), true);
  }

 private:
  bool start() {
    system_.prepare(lammps_);
    if (stretch_.first_step == 0)
      system_.create(world_, lammps_);
    else
      lammps_.command_with_file("read_restart", protocol_.restart_file);
    system_.set_forces(lammps_);
    if (stretch_.first_step == 0 && !system_.relax(lammps_, [&] { return asked(0); }))
      return false;
    lammps_.command("timestep {}", protocol_.dt);
    lammps_.command("thermo {}", samples() ? protocol_.sample_every : 10 * piece);
    if (stretch_.first_step == 0)
      lammps_.command("velocity all create {} {} dist gaussian", protocol_.T, lammps_seed(protocol_.seed, 1));
    return true;
  }

  void set_motion() {
    lammps_.command("fix move all nve");
    if (stretch_.phase == MeltPhase::hold)
      hold();
    else if (stretch_.phase == MeltPhase::sample)
      lammps_.command("velocity all zero linear"); // exact zeros again after each reading
    else
      lammps_.command("fix bath all langevin {0} {0} {1} {2} zero yes", protocol_.T, 1 / protocol_.friction,
                      lammps_seed(protocol_.seed, 1000 + std::uint64_t(stretch_.first_step)));
    if (stretch_.phase == MeltPhase::squeeze)
      squeeze();
  }

  bool samples() const { return stretch_.phase == MeltPhase::sample || stretch_.phase == MeltPhase::hold; }

  void hold() {
    held_.emplace(world_, lammps_, system_.molecules(), system_.masses());
    held_->stop();
    if (stretch_.begins)
      held_->set_temperature(protocol_.T), first_energy_.reset();
    held_->hold();
  }

  /// The box grows or shrinks about its middle, and the atoms with it.
  void squeeze() {
    Vec3 const edges = system_.edges(stretch_.rho);
    std::string words = "fix squeeze all deform 1";
    for (auto const& [axis, edge] : {std::pair{'x', edges.x}, {'y', edges.y}, {'z', edges.z}}) {
      double const now = lammps_.thermo(fmt::format("l{}", axis)),
                   middle = lammps_.thermo(fmt::format("{}lo", axis)) + now / 2;
      words += fmt::format(" {} final {} {}", axis, middle - edge / 2, middle + edge / 2);
    }
    lammps_.command(words + " remap x units box");
  }

  bool advance() {
    std::int64_t const begin = stretch_.first_step, end = begin + stretch_.steps;
    std::int64_t const step = samples() ? protocol_.sample_every : piece;
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
    auto frame = collect_molecules(world_, lammps_, system_.molecules(), system_.atoms_per_molecule());
    if (held_)
      held_->put_back(frame);
    if (!first_energy_)
      first_energy_ = frame.energy;
    double const kT = lammps_.unit_constants().boltzmann * protocol_.T;
    double const astray = std::abs(frame.energy - *first_energy_) / (system_.atoms() * kT);
    if (!(astray <= energy_tolerance)) // a NaN too
      throw PhysicsError(fmt::format("the {} melt at rho = {} does not keep its energy: by step {} it went "
                                     "astray by {:.3g} k_B T a bead at the time step {}. Take a shorter --dt",
                                     system_.name(), protocol_.rho, frame.step, astray, protocol_.dt));
    if (consumers_.frames)
      consumers_.frames(frame);
  }

  bool asked(std::int64_t done) {
    if (world_.size() == 1)
      return !consumers_.steps || consumers_.steps(done, all_steps_);
    return world_.root_says(!world_.is_root() || !consumers_.steps || consumers_.steps(done, all_steps_));
  }

  void keep() { write_checkpoint(world_, lammps_, protocol_.restart_file, consumers_.checkpoint); }

  MpiWorld const& world_;
  MeltSystem const& system_;
  MeltProtocol const& protocol_;
  StarConsumers const& consumers_;
  MeltStretch stretch_;
  std::int64_t all_steps_;
  std::optional<double>& first_energy_;
  LammpsSession lammps_;
  std::optional<HeldMolecules> held_;
};

} // namespace

void check_run(MeltProtocol const& protocol) {
  require(protocol.squeeze > 1 && protocol.squeeze <= 2, "growth of the density at once", protocol.squeeze,
          "must be in (1, 2]");
  require(protocol.squeeze_steps >= 200, "steps of a squeeze", protocol.squeeze_steps,
          "must be at least 200");
  check_steps(protocol.equilibration_steps, protocol.sampling_steps, protocol.sample_every);
  require(protocol.sampling_steps % protocol.sample_every == 0, "sampling steps", protocol.sampling_steps,
          "must be a multiple of the steps between samples");
  require(protocol.checkpoint_every > 0 && protocol.checkpoint_every % protocol.sample_every == 0,
          "steps between checkpoints", protocol.checkpoint_every,
          "must be a multiple of the steps between samples");
}

std::vector<MeltStretch> plan(MeltProtocol const& protocol, double first_density) {
  std::vector<MeltStretch> stretches;
  std::int64_t step = 0;
  auto const add = [&](MeltPhase phase, std::int64_t steps, double rho) {
    stretches.push_back({.phase = phase, .first_step = step, .steps = steps, .rho = rho});
    step += steps;
  };
  auto const in_pieces = [&](MeltPhase phase, std::int64_t steps) {
    for (std::int64_t left = steps; left > 0; left -= protocol.checkpoint_every)
      add(phase, std::min(left, protocol.checkpoint_every), protocol.rho);
  };
  double const ratio = protocol.rho / first_density;
  int const changes =
      std::max(0, int(std::ceil(std::abs(std::log(ratio)) / std::log(protocol.squeeze) - 1e-9)));
  for (int k = 1; k <= changes; ++k) {
    double const rho = k == changes ? protocol.rho : first_density * std::pow(ratio, double(k) / changes);
    add(MeltPhase::squeeze, protocol.squeeze_steps / 2, rho);
    add(MeltPhase::rest, protocol.squeeze_steps - protocol.squeeze_steps / 2, rho);
  }
  in_pieces(MeltPhase::equilibrate, protocol.equilibration_steps);
  in_pieces(MeltPhase::sample, protocol.sampling_steps);
  return stretches;
}

bool run_stretches(MpiWorld const& world, MeltSystem const& system, MeltProtocol const& protocol,
                   std::vector<MeltStretch> const& stretches, bool resume, std::string const& why,
                   StarConsumers const& consumers) {
  Checkpoint const checkpoint{.restart_file = protocol.restart_file,
                              .log_file = protocol.log_file,
                              .prepare = [&](LammpsSession& lammps) { system.prepare(lammps); }};
  std::int64_t const done = step_to_begin_at(world, checkpoint, stretches, resume, why);
  std::optional<double> first_energy;
  for (auto const& stretch : stretches)
    if (stretch.first_step >= done &&
        !Stretch(world, system, protocol, consumers, stretch, steps_of(stretches), first_energy).run())
      return false;
  return true;
}

bool sample_melt(MpiWorld const& world, MeltSystem const& system, MeltProtocol const& protocol, bool resume,
                 StarConsumers const& consumers) {
  return run_stretches(
      world, system, protocol, plan(protocol, system.first_density()), resume,
      fmt::format("resume with a length that is a multiple of {} steps", protocol.checkpoint_every),
      consumers);
}

} // namespace mesobridge::md
