#include "sdpd/lammps/lammps_engine.hpp"
#include "sdpd/lammps/fluid_styles.hpp"
#include "sdpd/lammps/styles.hpp"
#include <chrono>
#include <optional>
#include <utility>

namespace mesobridge::sdpd {
namespace {

/// What a run finds about its fluid before it begins: constants of the densities, viscosities of the pairs.
struct Found {
  DensityCorrection constants = {};
  double eta = 0, zeta = 0;

  static Found of(SimulationSettings const& settings) {
    auto const* const sdpd = std::get_if<Sdpd>(&settings.method);
    return sdpd ? Found{sdpd->density_correction, sdpd->eta, sdpd->zeta} : Found{};
  }
  void set(SimulationSettings& settings) const {
    if (auto* const sdpd = std::get_if<Sdpd>(&settings.method))
      sdpd->density_correction = constants, sdpd->eta = eta, sdpd->zeta = zeta;
  }
};

/// What the first rank tells the others: steps to make, 0 at the end; where the run is, and what it has
/// found.
struct Order {
  std::uint64_t steps = 0, first = 0;
  Found found = {};

  std::array<double, 6> numbers() const {
    return {static_cast<double>(steps),
            static_cast<double>(first),
            found.constants.scale,
            found.constants.self,
            found.eta,
            found.zeta};
  }
  static Order of(std::vector<double> const& numbers) {
    return {.steps = static_cast<std::uint64_t>(numbers.at(0)),
            .first = static_cast<std::uint64_t>(numbers.at(1)),
            .found = {{.scale = numbers.at(2), .self = numbers.at(3)}, numbers.at(4), numbers.at(5)}};
  }
};

/// All of the particles as rows, as LammpsStyles::own_rows() gives those of a rank.
std::vector<double> rows_of(Particles const& particles) {
  std::vector<double> rows;
  rows.reserve(LammpsStyles::numbers_per_particle * particles.size());
  for (std::size_t i = 0; i < particles.size(); ++i) {
    auto const &q = particles.q[i], &p = particles.p[i];
    bool const energies = !particles.eps.empty();
    rows.insert(rows.end(), {double(particles.id[i]), q.x, q.y, q.z, p.x, p.y, p.z,
                             energies ? particles.eps[i] : 0, energies ? particles.T[i] : 1});
  }
  return rows;
}

/// The other way round, in the order of the ids, which are 0 ... n-1: what a checkpoint holds, no more.
Particles particles_of(std::vector<double> const& rows, Features const& features) {
  std::size_t const width = LammpsStyles::numbers_per_particle, n = rows.size() / width;
  Particles particles;
  particles.id.resize(n), particles.q.resize(n), particles.p.resize(n);
  for (auto const& field : fields)
    (particles.*field.values).resize(field.checkpointed && features.*field.feature ? n : 0);
  for (std::size_t k = 0; k < n; ++k) {
    double const* const row = &rows[width * k];
    auto const i = static_cast<std::size_t>(row[0]);
    particles.id[i] = static_cast<std::uint32_t>(i);
    particles.q[i] = {row[1], row[2], row[3]}, particles.p[i] = {row[4], row[5], row[6]};
    if (features.energies)
      particles.eps[i] = row[7], particles.T[i] = row[8];
  }
  return particles;
}

} // namespace

struct LammpsEngine::Inside {
  md::MpiWorld const& world;
  SimulationSettings settings;
  std::filesystem::path log_file;
  std::optional<DecomposedFluid> fluid = {};    ///< these three from the first step on
  std::optional<md::LammpsSession> lammps = {}; ///< until then the ranks wait without load
  std::optional<LammpsStyles> styles = {};
  bool has_forces = false; ///< from the first run on: they are found when no copies of the particles are left
  std::chrono::duration<double> in_steps{};

  /// A box with the styles and without atoms.
  void prepare() {
    fluid.emplace(settings);
    auto& session = lammps.emplace(world, md::Ranks::all, log_file);
    Vec3 const edge = box_of(settings).edge;
    auto const commands = fluid_commands(*fluid);
    for (auto const& command : commands.before)
      session.command(command);
    session.command("region box block 0 {} 0 {} 0 {} units box", edge.x, edge.y, edge.z);
    session.command("create_box 1 box");
    session.command("mass 1 1");
    for (auto const& command : commands.after)
      session.command(command);
    styles.emplace(session, *fluid);
    session.command("thermo_style custom step");
    session.command("thermo 0");
  }

  /// The particles, which the first rank has.
  void begin(Order const& order, std::vector<double> const& rows) {
    order.found.set(settings);
    prepare();
    styles->create(particles_of(world.root_gives(rows), settings.features()));
    lammps->command("reset_timestep {}", order.first);
  }

  /// All particles, on the first rank; `counts` gains what the pairs of all ranks did.
  std::vector<double> run(std::uint64_t steps, PairCounts& counts) {
    if (!std::exchange(has_forces, true))
      lammps->command("run 0 post no");
    world.barrier(); // the others wake when they see the order
    auto const start = std::chrono::steady_clock::now();
    lammps->command("run {} pre no post no", steps);
    in_steps += std::chrono::steady_clock::now() - start;
    auto const own = fluid->take_counts();
    std::array numbers{double(own.proposed), double(own.out_of_domain), double(own.metropolis)};
    world.add_up(numbers);
    counts += {.proposed = std::uint64_t(numbers[0]),
               .out_of_domain = std::uint64_t(numbers[1]),
               .metropolis = std::uint64_t(numbers[2])};
    return world.gather_at_root(styles->own_rows());
  }
};

LammpsEngine::LammpsEngine(md::MpiWorld const& world, SimulationSettings const& settings,
                           std::filesystem::path const& log_file) {
  refuse_for_lammps(settings);
  inside_ = std::unique_ptr<Inside>(new Inside{.world = world, .settings = settings, .log_file = log_file});
}

LammpsEngine::~LammpsEngine() {
  if (inside_ && inside_->world.is_root())
    inside_->world.root_gives(Order{}.numbers());
}

void LammpsEngine::settle(SimulationSettings const& settings) {
  Found::of(settings).set(inside_->settings);
}

void LammpsEngine::advance(Simulation& simulation, std::uint64_t steps) {
  auto checkpoint = simulation.checkpoint();
  Order const order{.steps = steps, .first = checkpoint.step, .found = Found::of(inside_->settings)};
  inside_->world.root_gives(order.numbers());
  if (!inside_->lammps)
    inside_->begin(order, rows_of(checkpoint.particles));
  // Large fluids leave no memory for a second copy; `= {}` would keep a vector's room.
  checkpoint.particles = Particles(), checkpoint.q_at_renewal = std::vector<Vec3>();
  checkpoint.particles =
      particles_of(inside_->run(steps, checkpoint.pair_counts), inside_->settings.features());
  checkpoint.q_at_renewal = checkpoint.particles.q;
  checkpoint.step += steps;
  simulation.begin_from(checkpoint);
}

double LammpsEngine::seconds_in_steps() const {
  return inside_->in_steps.count();
}

void LammpsEngine::serve() {
  for (;;) {
    auto const order = Order::of(inside_->world.root_gives({}));
    if (order.steps == 0)
      return;
    if (!inside_->lammps)
      inside_->begin(order, {});
    PairCounts of_all;
    inside_->run(order.steps, of_all);
  }
}

} // namespace mesobridge::sdpd
