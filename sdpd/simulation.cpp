#include "sdpd/simulation.hpp"
#include "sdpd/observe/compression.hpp"
#include "sdpd/particle_eos.hpp"
#include "sdpd/random.hpp"
#include "sdpd/step/conservative.hpp"
#include <algorithm>

namespace mesobridge::sdpd {
namespace {

/// Skin of the neighbour lists, from the rms step of a particle, dt sqrt(3/K): fast particles want a wide
/// skin, slow ones a narrow one. The lower bound and the factor were chosen by timing the ideal gas
/// and argon at K = 100, where 0.35 ... 0.5 cost the same.
double skin_of(SimulationSettings const& s) {
  return s.skin > 0 ? s.skin : std::clamp(20 * s.dt * std::sqrt(3 / s.K), 0.3, 0.7);
}

std::size_t particle_count(SimulationSettings const& s) {
  return std::size_t{s.lattice[0]} * s.lattice[1] * s.lattice[2];
}

/// Positions on a simple cubic lattice of spacing 1 (the mean distance between particles) with Gaussian
/// displacements, ids in its order.
void place_on_lattice(Particles& particles, SimulationSettings const& settings) {
  NoiseSource const source(settings.seed, Stream::initial_positions, 0);
  auto const [n_x, n_y, n_z] = settings.lattice;
  std::uint32_t id = 0;
  for (std::uint32_t z = 0; z < n_z; ++z)
    for (std::uint32_t y = 0; y < n_y; ++y)
      for (std::uint32_t x = 0; x < n_x; ++x, ++id) {
        auto const G = gaussians_reference(source, id, 0);
        particles.id[id] = id;
        particles.q[id] = Vec3{x + 0.5, y + 0.5, z + 0.5} + settings.disorder * Vec3{G[0], G[1], G[2]};
      }
}

/// Maxwell velocities at T = 1 whose sum is zero and whose kinetic energy is exactly (3/2)(N-1) k_B T.
void draw_momenta(Particles& particles, double boltzmann, std::uint64_t seed) {
  NoiseSource const source(seed, Stream::initial_velocities, 0);
  Vec3 sum{};
  for (std::size_t i = 0; i < particles.size(); ++i) {
    auto const G = gaussians_reference(source, particles.id[i], 0);
    sum += particles.p[i] = {G[0], G[1], G[2]};
  }
  double const count = static_cast<double>(particles.size());
  double square = 0;
  for (auto& p : particles.p)
    square += norm2(p -= sum / count);
  double const scale = std::sqrt(3 * (count - 1) * boltzmann / square);
  for (auto& p : particles.p)
    p *= scale;
}

/// Without noise the centres of mass have no thermal motion that could carry anything.
CentreOfMass centre_of_mass_of(SimulationSettings const& s) {
  return s.noise ? s.centre_of_mass : CentreOfMass::bulk;
}

/// Boltzmann's constant of friction and conduction: what has no noise is the limit k_B -> 0.
double noise_boltzmann(SimulationSettings const& s) {
  return s.noise ? 1 / s.K : 0;
}

double self_density(AnyKernel const& kernel, DensityCorrection const& correction) {
  double const W_0 = std::visit([](auto const& of) { return of.W(0.0); }, kernel); // with the scale
  return W_0 * (1 - correction.self / correction.scale);
}

AnyConduction conduction_of(SimulationSettings const& s) {
  if (s.kappa == 0)
    return std::monostate();
  return SdpdConduction(s.kappa / s.units().conductivity(), noise_boltzmann(s));
}

std::unique_ptr<System> build(SimulationSettings const& s) {
  ReducedUnits const units = s.units();
  Box const box{{double(s.lattice[0]), double(s.lattice[1]), double(s.lattice[2])}};
  double const h = s.h_factor;
  AnyKernel const kernel = make_kernel(s.kernel, h, s.density_correction.scale);
  auto system = std::make_unique<System>(System{
      .box = box,
      .thermodynamics = make_thermodynamics(s.eos, units, centre_of_mass_of(s)),
      .kernel = kernel,
      .self_density = self_density(kernel, s.density_correction),
      .law = SdpdLaw{SdpdFriction(s.eta / units.viscosity(), s.zeta / units.viscosity()), noise_boltzmann(s)},
      .conduction = conduction_of(s),
      .neighbours = Neighbours(box, h, skin_of(s), s.threads),
      .particles = {},
      .boltzmann = 1 / s.K,
      .seed = s.seed,
      .threads = s.threads,
      .block_virial = {},
      .energy_gain = {},
      .impulse = {},
  });
  system->particles.resize(particle_count(s));
  place_on_lattice(system->particles, s);
  if (s.noise)
    draw_momenta(system->particles, system->boltzmann, s.seed);
  std::fill(system->particles.T.begin(), system->particles.T.end(), 1.0);
  return system;
}

/// Lists, densities, thermodynamics and forces from positions and energies.
void refresh(System& system) {
  refresh_lists(system);
  find_pairs_and_densities(system);
  thermodynamics_from_energy(system);
  find_forces(system);
  system.kept_energy = total_energy(system);
}

void set_energies_from_temperatures(System& system) {
  refresh_lists(system);
  find_pairs_and_densities(system);
  Failure failure;
  for_each_range(system, [&](Range range) {
    system.thermodynamics->energy_from_temperature(system.particles, range, failure);
  });
  system.stop_at(failure);
}

/// At the set density and temperature, in k_B. Throws PhysicsError when the model has no such state.
double heat_capacity_of_a_particle(SimulationSettings const& s) {
  double const bulk = std::visit(
      [&](auto const& eos) {
        return eos.heat_capacity(eos.energy_from_temperature(s.T, s.rho), s.rho) * eos.molecular_mass() /
               eos.boltzmann();
      },
      s.eos);
  return s.K * bulk - (centre_of_mass_of(s) == CentreOfMass::free ? 1.5 : 0);
}

std::vector<double> heat_capacities(System const& system) {
  std::vector<double> C(system.size());
  for (std::size_t i = 0; i < C.size(); ++i)
    C[i] = system.thermodynamics->heat_capacity(system.particles, static_cast<Index>(i));
  return C;
}

struct MeanTemperatures {
  double T_kin = 0, T_int = 0;
};

/// With `quench`, kinetic energy that the settling structure sets free is taken out on the way: a structure
/// of large particles falls from one arrangement to the next, and each fall is worth many of their k_B T.
MeanTemperatures run_and_average(Simulation& simulation, std::uint64_t steps, bool quench,
                                 std::function<bool()> const& keep_going) {
  constexpr double too_hot = 1.2;
  constexpr std::uint64_t quench_every = 8;
  MeanTemperatures sum;
  for (std::uint64_t k = 0; k < steps; ++k) {
    simulation.advance(1);
    Observation const now = simulation.observe();
    if (quench && k % quench_every == 0 && now.T_kin > too_hot)
      simulation.scale_momenta(1 / std::sqrt(now.T_kin));
    sum.T_kin += now.T_kin, sum.T_int += now.T_int;
    if (k % 32 == 0 && !keep_going())
      throw Interrupted("stopped while the system came to equilibrium");
  }
  return {sum.T_kin / static_cast<double>(steps), sum.T_int / static_cast<double>(steps)};
}

} // namespace

void check(SimulationSettings const& s) {
  require(s.rho > 0 && std::isfinite(s.rho), "density rho", s.rho, "must be > 0 and finite");
  require(s.T > 0 && std::isfinite(s.T), "temperature T", s.T, "must be > 0 and finite");
  require(s.K >= 1 && std::isfinite(s.K), "particle size K", s.K, "must be >= 1 and finite");
  double const C = heat_capacity_of_a_particle(s);
  require(
      C > least_heat_capacity, "particle size K", s.K,
      fmt::format("is too small: a particle has the heat capacity {:.4g} k_B at rho and T{}, and above {} "
                  "k_B is needed for a positive friction (theory, Eq. (2.16))",
                  C, centre_of_mass_of(s) == CentreOfMass::free ? " without its centre of mass" : "",
                  least_heat_capacity));
  require(s.dt > 0 && std::isfinite(s.dt), "time step dt", s.dt, "must be > 0 and finite (reduced units)");
  require(s.h_factor >= 1 && s.h_factor <= 10, "kernel support h_factor", s.h_factor, "must lie in 1 ... 10");
  auto const& [scale, self] = s.density_correction;
  require(scale > 0 && std::isfinite(scale), "density correction scale", scale, "must be > 0 and finite");
  require(self < scale && self > -scale, "density correction self", self,
          "must lie between -scale and scale");
  make_kernel(s.kernel, s.h_factor);
  require(s.skin >= 0 && std::isfinite(s.skin), "skin", s.skin, "must be >= 0");
  require(s.threads >= 1, "threads", s.threads, "must be >= 1");
  require(s.scheme.verlet_steps >= 1, "Verlet steps for one of fluctuation and dissipation",
          s.scheme.verlet_steps, "must be >= 1");
  require(s.disorder >= 0 && s.disorder <= 0.5, "disorder", s.disorder,
          "must lie in 0 ... 0.5 lattice spacings");
  for (auto const n : s.lattice)
    require(n >= 1, "particles along an edge", n, "must be >= 1");
  auto const units = s.units();
  SdpdFriction(s.eta / units.viscosity(), s.zeta / units.viscosity());
  require(s.kappa >= 0 && std::isfinite(s.kappa), "thermal conductivity kappa", s.kappa, "must be >= 0");
  if (!s.noise && s.scheme.pairs == PairScheme::ems)
    throw InputError("scheme ems without noise: there is nothing to put to a Metropolis test; take ssa");
  Box const box{{double(s.lattice[0]), double(s.lattice[1]), double(s.lattice[2])}};
  CellGrid(box, s.h_factor + skin_of(s));
}

std::unique_ptr<System> make_system(SimulationSettings const& settings) {
  check(settings);
  auto system = build(settings);
  set_energies_from_temperatures(*system);
  refresh(*system);
  return system;
}

ReducedUnits SimulationSettings::units() const {
  return std::visit(
      [this](auto const& model) {
        return ReducedUnits{.K = K,
                            .m0 = model.molecular_mass(),
                            .density = rho,
                            .temperature = T,
                            .boltzmann = model.boltzmann()};
      },
      eos);
}

Simulation::Simulation(SimulationSettings const& settings)
    : has_noise_(settings.noise), units_(settings.units()), dt_(settings.dt), scheme_(settings.scheme),
      system_(make_system(settings)) {}

Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

void Simulation::advance(std::uint64_t steps) {
  for (std::uint64_t k = 0; k < steps; ++k)
    step(*system_, scheme_, dt_);
}
Observation Simulation::observe() const {
  return sdpd::observe(system_->particles, system_->box, system_->virial, system_->boltzmann, system_->step);
}
Box const& Simulation::box() const {
  return system_->box;
}
std::size_t Simulation::size() const {
  return system_->particles.size();
}
PairCounts Simulation::pair_counts() const {
  return system_->pair_counts;
}
PairCounts Simulation::conduction_counts() const {
  return system_->conduction_counts;
}
std::uint64_t Simulation::list_renewals() const {
  return system_->renewals;
}

double Simulation::neighbours() const {
  return 2.0 * static_cast<double>(system_->neighbours.pair_count()) / static_cast<double>(size());
}

Snapshot Simulation::snapshot() const {
  auto const& particles = system_->particles;
  std::size_t const n = particles.size();
  Snapshot s{std::vector<Vec3>(n),   std::vector<Vec3>(n),   std::vector<double>(n),
             std::vector<double>(n), std::vector<double>(n), std::vector<double>(n)};
  for (std::size_t i = 0; i < n; ++i) {
    auto const id = particles.id[i];
    s.q[id] = box().wrap(particles.q[i]), s.p[id] = particles.p[i], s.eps[id] = particles.eps[i];
    s.rho[id] = particles.rho[i], s.T[id] = particles.T[i], s.P[id] = particles.P[i];
  }
  return s;
}

void Simulation::heat(double rise) {
  auto const C = heat_capacities(*system_);
  auto& eps = system_->particles.eps;
  for (std::size_t i = 0; i < eps.size(); ++i)
    eps[i] += C[i] * rise;
  refresh(*system_);
}

void Simulation::scale_momenta(double factor) {
  for (auto& p : system_->particles.p)
    p *= factor;
  system_->kept_energy = total_energy(*system_);
}

void Simulation::draw_temperatures() {
  auto& particles = system_->particles;
  std::fill(particles.T.begin(), particles.T.end(), 1.0);
  if (units_.K >= 50) {
    auto const C = heat_capacities(*system_);
    NoiseSource const source(system_->seed, Stream::initial_energies, system_->step);
    for (std::size_t i = 0; i < particles.size(); ++i) // C counts in K k_B
      particles.T[i] += std::sqrt(1 / (units_.K * C[i])) * gaussians_reference(source, particles.id[i], 0)[0];
  }
  set_energies_from_temperatures(*system_);
  refresh(*system_);
}

double Simulation::heat_capacity() const {
  double sum = 0;
  for (double const C : heat_capacities(*system_))
    sum += C * units_.K; // reduced C counts in K k_B
  return sum + 1.5 * (static_cast<double>(size()) - 1);
}

void Simulation::set_density_correction(DensityCorrection const& correction) {
  auto& kernel = system_->kernel;
  std::string_view const name = std::visit([](auto const& of) { return of.name; }, kernel);
  kernel = make_kernel(name, system_->neighbours.range(), correction.scale);
  system_->self_density = self_density(kernel, correction);
  set_energies_from_temperatures(*system_);
  refresh(*system_);
}

double Simulation::compression_response() const {
  return sdpd::compression_response(*system_);
}

Checkpoint Simulation::checkpoint() const {
  auto const& particles = system_->particles;
  auto const renewed = system_->neighbours.positions_at_renewal();
  return {system_->step,
          particles.id,
          particles.q,
          {renewed.begin(), renewed.end()},
          particles.p,
          particles.eps,
          particles.S,
          particles.T,
          system_->kept_energy,
          system_->pair_counts,
          system_->conduction_counts};
}

void Simulation::restore(Checkpoint const& c) {
  auto& particles = system_->particles;
  std::size_t const n = size();
  for (auto const length :
       {c.id.size(), c.q.size(), c.q_at_renewal.size(), c.p.size(), c.eps.size(), c.S.size(), c.T.size()})
    require(length == n, "particles in the checkpoint", length, fmt::format("must be {} as in the scene", n));
  // The lists of the checkpoint are those of its last renewal: renew them there, then move on.
  particles.id = c.id, particles.p = c.p, particles.eps = c.eps, particles.S = c.S, particles.T = c.T;
  particles.q = c.q_at_renewal;
  system_->neighbours.renew(particles);
  particles.q = c.q;
  system_->step = c.step;
  system_->kept_energy = c.kept_energy, system_->pair_counts = c.pair_counts;
  system_->conduction_counts = c.conduction_counts;
  find_pairs_and_densities(*system_);
  response_from_temperature(*system_);
  find_forces(*system_);
}

void equilibrate(Simulation& simulation, std::uint64_t steps, std::function<bool()> const& keep_going) {
  // Runs of 1/32, 1/32, 1/16, 1/8, 1/4 and 1/2 of the steps.
  std::array<double, 6> const shares{0.03125, 0.03125, 0.0625, 0.125, 0.25, 0.5};
  std::uint64_t done = 0;
  double share_done = 0;
  for (double const share : shares) {
    share_done += share;
    auto const end = static_cast<std::uint64_t>(share_done * static_cast<double>(steps));
    if (end == done)
      continue;
    auto const mean = run_and_average(simulation, end - done, share < 0.5, keep_going);
    done = end;
    if (!simulation.has_noise()) { // nothing but heat is there to be set
      simulation.heat(1 - mean.T_int);
      continue;
    }
    // Weighted with the heat capacities, most of the exchange between the two kinds of energy, which makes
    // each temperature fluctuate, cancels.
    double const kinetic_share =
        1.5 * (static_cast<double>(simulation.size()) - 1) / simulation.heat_capacity();
    double const missing = 1 - kinetic_share * mean.T_kin - (1 - kinetic_share) * mean.T_int;
    simulation.heat(missing / (1 - kinetic_share));
    // Large particles exchange their little kinetic energy slowly; it is brought to the set temperature
    // directly while the disorder of the start decays.
    if (share < 0.5)
      simulation.scale_momenta(1 / std::sqrt(mean.T_kin));
    // While the structure settles, densities change at constant entropies and leave every particle with a
    // temperature of its own, which large particles would keep for very long.
    if (share < 0.25)
      simulation.draw_temperatures();
  }
}

} // namespace mesobridge::sdpd
