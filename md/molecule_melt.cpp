#include "md/molecule_melt.hpp"
#include <algorithm>
#include <cmath>
#include <map>

namespace mesobridge::md {
namespace {

/// What runs take where nothing is said.
struct UsualRun {
  double T, dt;
};

std::map<std::string, UsualRun> const usual_runs{
    {"lj", {1, 0.002}}, {"real", {300, 1}}, {"metal", {300, 0.001}}};

double usual(std::optional<double> const& given, double UsualRun::*value, std::string const& units,
             char const* option) {
  if (given)
    return *given;
  auto const found = usual_runs.find(units);
  require(found != usual_runs.end(), "units", units, fmt::format("{} must be given in these", option));
  return found->second.*value;
}

MeltProtocol protocol_of(MoleculeMeltSettings const& s, MoleculeSystem const& system) {
  constexpr double steps_of_memory = 1000;
  auto const& molecules = system.molecules;
  auto protocol = protocol_of_run(s);
  protocol.rho = s.rho.value_or(double(molecules.q.size()) / molecules.box.volume());
  protocol.T = usual(s.T, &UsualRun::T, system.units, "--T");
  protocol.dt = usual(s.dt, &UsualRun::dt, system.units, "--dt");
  protocol.friction = s.friction.value_or(1 / (steps_of_memory * protocol.dt));
  return protocol;
}

MoleculeSystem system_of(MoleculeMeltSettings const& s) {
  for (int const times : s.replicate)
    require(times >= 1 && times <= 1000, "--replicate", times, "must be 1 ... 1000");
  auto system = read_molecule_system(s.data, s.forces, s.styles);
  auto const& box = system.molecules.box;
  require(!box.tilted(), s.data.string(), fmt::format("tilts {} {} {}", box.xy, box.xz, box.yz),
          "must be 0: melts are made in rectangular boxes");
  double count = double(system.molecules.q.size());
  for (int const times : s.replicate)
    count *= times;
  require(count <= 1e8, "atoms", count, "must be at most 1e8");
  system.molecules = replicated(system.molecules, s.replicate);
  return system;
}

void check(MoleculeSystem const& system, MeltProtocol const& protocol) {
  auto const& molecules = system.molecules;
  auto const positive = [](double value, char const* what) {
    require(value > 0 && std::isfinite(value), what, value, "must be > 0");
  };
  positive(protocol.rho, "density rho [atoms per volume]");
  positive(protocol.T, "temperature T");
  positive(protocol.dt, "time step");
  positive(protocol.friction, "friction of the thermostat");
  check_run(protocol);
  require(molecules.count >= 2, "molecules", molecules.count, "must be at least 2: --replicate makes more");
  double const shrink = std::cbrt(double(molecules.q.size()) / protocol.rho / molecules.box.volume());
  auto const& edge = molecules.box.edge;
  double const narrowest = shrink * std::min({edge.x, edge.y, edge.z}), width = mean_width(molecules);
  require(narrowest > width, "molecules", molecules.count,
          fmt::format("the narrowest edge of the box is {:.4g} and the molecules of the data file are {:.4g} "
                      "wide, which meet their own images: a larger --replicate makes a larger box",
                      narrowest, width));
}

/// A number that tells texts apart (Fowler, Noll and Vo's).
class TextHash {
 public:
  void add(std::string const& text) {
    for (char const c : text + "\n")
      value_ = (value_ ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325u;
};

std::uint64_t hash_of(MoleculeSystem const& system) {
  TextHash hash;
  auto const& kind = system.molecules.kind;
  for (std::size_t i = 0; i < kind.types.size(); ++i)
    hash.add(fmt::format("{} {}", kind.types[i], kind.charges[i]));
  for (double const mass : kind.masses_of_types)
    hash.add(fmt::format("{}", mass));
  for (auto const& terms : kind.bonded)
    for (auto const& term : terms)
      hash.add(fmt::format("{} {} {} {} {}", term.type, term.atoms[0], term.atoms[1], term.atoms[2],
                           term.atoms[3]));
  for (Vec3 const& q : system.molecules.q)
    hash.add(fmt::format("{} {} {}", q.x, q.y, q.z));
  for (auto const* lines : {&system.forces.lines(), &system.coefficients})
    for (auto const& line : *lines)
      hash.add(line.text());
  return hash.value();
}

/// The molecules as the melt's run takes them.
class MoleculeMeltSystem final : public MeltSystem {
 public:
  explicit MoleculeMeltSystem(MoleculeMelt const& melt)
      : system_(melt.system()), molecules_(system_.molecules), settings_(melt.settings()) {}

  std::string name() const override { return molecules_.kind.name; }
  int molecules() const override { return molecules_.count; }
  int atoms_per_molecule() const override { return molecules_.kind.atoms(); }
  std::vector<double> masses() const override { return molecules_.kind.masses(); }
  double first_density() const override { return atoms() / molecules_.box.volume(); }
  Vec3 edges(double rho) const override {
    return std::cbrt(atoms() / rho / molecules_.box.volume()) * molecules_.box.edge;
  }
  void prepare(LammpsSession& lammps) const override { system_.prepare(lammps); }

  void create(MpiWorld const& world, LammpsSession& lammps) const override {
    auto const file = settings_.directory / "molecules.data";
    if (world.is_root())
      write_data_file(file, molecules_.kind, molecules_.q, molecules_.box);
    world.barrier();
    try {
      lammps.command_with_file("read_data", file);
    } catch (LammpsError const& error) {
      throw InputError(fmt::format("'{}': {}", settings_.data.string(), error.what()));
    }
    world.barrier();
    if (world.is_root())
      std::filesystem::remove(file);
  }

  void set_forces(LammpsSession& lammps) const override { system_.set_forces(lammps); }

  bool relax(LammpsSession& lammps, std::function<bool()> const& goes_on) const override {
    try {
      system_.require_few_images(lammps, molecules_.box);
      lammps.command("run 0 post no"); // LAMMPS looks for coefficients that are missing
      return !settings_.minimise || minimised(lammps, goes_on);
    } catch (LammpsError const& error) {
      throw InputError(fmt::format("'{}' with '{}': {}", settings_.data.string(), settings_.forces.string(),
                                   error.what()));
    }
  }

  std::string shorter_step() const override { return "may help, or a start whose atoms do not overlap"; }

 private:
  bool minimised(LammpsSession& lammps, std::function<bool()> const& goes_on) const {
    constexpr std::int64_t pieces = 20, iterations = 25;
    lammps.command("min_modify dmax {}", 0.1 * typical_distance());
    for (std::int64_t k = 0; k < pieces; ++k) {
      auto const before = lammps.step();
      lammps.command("minimize 1e-5 0 {} {}", iterations, 10 * iterations);
      if (!goes_on())
        return false;
      if (lammps.step() < before + iterations)
        break;
    }
    lammps.command("reset_timestep 0");
    return true;
  }

  double typical_distance() const { return std::cbrt(molecules_.box.volume() / atoms()); }

  MoleculeSystem const& system_;
  Molecules const& molecules_;
  MoleculeMeltSettings const& settings_;
};

} // namespace

MoleculeMelt::MoleculeMelt(MoleculeMeltSettings const& settings)
    : settings_(settings), system_(system_of(settings)), protocol_(protocol_of(settings, system_)) {
  check(system_, protocol_);
}

std::string MoleculeMelt::fingerprint() const {
  auto const& p = protocol_;
  auto const& kind = system_.molecules.kind;
  return fmt::format(
      "{}, {} molecules of {} atoms, units {}, start and force field {:016x}, rho = {}, T = {}, "
      "Langevin friction {}, time step {}, {}squeezed by {} in {} steps, {} steps of "
      "equilibration, a sample every {} steps, a checkpoint every {}, seed {}",
      kind.name, system_.molecules.count, kind.atoms(), system_.units, hash_of(system_), p.rho, p.T,
      p.friction, p.dt, settings_.minimise ? "minimised, " : "", p.squeeze, p.squeeze_steps,
      p.equilibration_steps, p.sample_every, p.checkpoint_every, p.seed);
}

void try_forces(MpiWorld const& world, MoleculeMelt const& melt) {
  if (world.is_root()) {
    auto const& molecules = melt.system().molecules;
    MoleculeFrame start{.box = molecules.box,
                        .molecules = molecules.count,
                        .atoms_per_molecule = molecules.kind.atoms(),
                        .q = molecules.q};
    InsideEnergies(world, melt.system(), melt.settings().directory).add_to(start);
  }
  world.barrier();
}

bool sample_molecules(MpiWorld const& world, MoleculeMelt const& melt, bool resume,
                      StarConsumers const& consumers) {
  InsideEnergies inside(world, melt.system(), melt.settings().directory);
  auto with_insides = consumers;
  with_insides.frames = [&](MoleculeFrame const& frame) {
    auto told = frame;
    inside.add_to(told);
    if (consumers.frames)
      consumers.frames(told);
  };
  return sample_melt(world, MoleculeMeltSystem(melt), melt.protocol(), resume, with_insides);
}

} // namespace mesobridge::md
