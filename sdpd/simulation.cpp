#include "sdpd/simulation.hpp"
#include "sdpd/observe/compression.hpp"
#include "sdpd/particle_eos.hpp"
#include "sdpd/random.hpp"
#include "sdpd/step/conservative.hpp"
#include "sdpd/step/langevin.hpp"
#include "sdpd/step/pair_forces.hpp"
#include <algorithm>

namespace mesobridge::sdpd {
namespace {

/// Skin of the neighbour lists, from the rms step of a particle, dt sqrt(3/K): fast particles want a wide
/// skin, slow ones a narrow one. The lower bound and the factor were chosen by timing the ideal gas
/// and argon at K = 100, where 0.35 ... 0.5 cost the same.
double skin_of(SimulationSettings const& s) {
  if (s.pair_fluid && s.skin == 0)
    return std::clamp(23 * s.dt * std::sqrt(3.0), 0.25, 0.5); // 0.4 at dt = 0.01 was timed
  return s.skin > 0 ? s.skin : std::clamp(20 * s.dt * std::sqrt(3 / s.K), 0.3, 0.7);
}

std::size_t particle_count(SimulationSettings const& s) {
  return std::size_t{s.lattice[0]} * s.lattice[1] * s.lattice[2];
}

/// Positions on a simple cubic lattice whose spacing is the mean distance between particles, with Gaussian
/// displacements, ids in its order.
void place_on_lattice(Particles& particles, SimulationSettings const& settings) {
  NoiseSource const source(settings.seed, Stream::initial_positions, 0);
  double const spacing = settings.spacing();
  auto const [n_x, n_y, n_z] = settings.lattice;
  std::uint32_t id = 0;
  for (std::uint32_t z = 0; z < n_z; ++z)
    for (std::uint32_t y = 0; y < n_y; ++y)
      for (std::uint32_t x = 0; x < n_x; ++x, ++id) {
        auto const G = gaussians_reference(source, id, 0);
        particles.id[id] = id;
        particles.q[id] =
            spacing * (Vec3{x + 0.5, y + 0.5, z + 0.5} + settings.disorder * Vec3{G[0], G[1], G[2]});
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

Box box_of(SimulationSettings const& s) {
  return {s.spacing() * Vec3{double(s.lattice[0]), double(s.lattice[1]), double(s.lattice[2])}};
}

System sdpd_system(SimulationSettings const& s) {
  ReducedUnits const units = s.units();
  AnyKernel const kernel = make_kernel(s.kernel, s.h_factor, s.density_correction.scale);
  return {
      .box = box_of(s),
      .thermodynamics = make_thermodynamics(s.eos, units, centre_of_mass_of(s)),
      .kernel = kernel,
      .self_density = self_density(kernel, s.density_correction),
      .potential = NoPotential{},
      .law = SdpdLaw{SdpdFriction(s.eta / units.viscosity(), s.zeta / units.viscosity()), noise_boltzmann(s)},
      .conduction = conduction_of(s),
      .neighbours = Neighbours(box_of(s), s.range(), skin_of(s), s.threads),
      .particles = {},
      .boltzmann = 1 / s.K,
      .seed = s.seed,
      .threads = s.threads,
      .block_virial = {},
      .block_energy = {},
      .energy_gain = {},
      .impulse = {}};
}

System pair_fluid_system(SimulationSettings const& s) {
  ReducedUnits const units = s.units();
  auto const& fluid = *s.pair_fluid;
  return {.box = box_of(s),
          .thermodynamics =
              fluid.follows_energy() ? make_thermodynamics(*fluid.internal_energy, units) : nullptr,
          .kernel = CubicKernel(s.range()),
          .self_density = 0,
          .potential = fluid.reduced_potential(units),
          .law = fluid.law(units),
          .conduction = std::monostate(),
          .neighbours = Neighbours(box_of(s), s.range(), skin_of(s), s.threads),
          .particles = {},
          .boltzmann = 1,
          .seed = s.seed,
          .threads = s.threads,
          .block_virial = {},
          .block_energy = {},
          .energy_gain = {},
          .impulse = {}};
}

std::unique_ptr<System> build(SimulationSettings const& s) {
  auto system = std::make_unique<System>(s.pair_fluid ? pair_fluid_system(s) : sdpd_system(s));
  system->dt = s.dt;
  system->particles.resize(particle_count(s), system->has_energies(), system->has_densities());
  place_on_lattice(system->particles, s);
  if (s.noise)
    draw_momenta(system->particles, system->boltzmann, s.seed);
  std::fill(system->particles.T.begin(), system->particles.T.end(), 1.0);
  return system;
}

/// Thermodynamics and forces that belong to positions, with `thermodynamics` for what has energies.
template <class F>
void refresh_by(System& system, F const& thermodynamics) {
  if (system.has_densities())
    find_pairs_and_densities(system);
  if (system.has_energies())
    thermodynamics(system);
  if (system.has_densities())
    find_forces(system);
  else
    find_pair_forces(system);
}

/// Lists, densities, thermodynamics and forces from positions and energies.
void refresh(System& system) {
  refresh_lists(system);
  refresh_by(system, thermodynamics_from_energy);
  system.kept_energy = total_energy(system);
}

void set_energies_from_temperatures(System& system) {
  if (!system.has_energies())
    return;
  refresh_lists(system);
  if (system.has_densities())
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
  std::vector<double> C(system.particles.eps.size());
  for (std::size_t i = 0; i < C.size(); ++i)
    C[i] = system.thermodynamics->heat_capacity(system.particles, static_cast<Index>(i));
  return C;
}

void check_lengths(Checkpoint const& c, Particles const& of) {
  for (auto const length : {c.id.size(), c.q.size(), c.q_at_renewal.size(), c.p.size()})
    require(length == of.size(), "particles in the checkpoint", length,
            fmt::format("must be {} as in the scene", of.size()));
  for (auto const length : {c.eps.size(), c.T.size()})
    require(length == of.eps.size(), "internal energies in the checkpoint", length,
            fmt::format("must be {} as in the scene", of.eps.size()));
  require(c.S.size() == of.S.size(), "entropies in the checkpoint", c.S.size(),
          fmt::format("must be {} as in the scene", of.S.size()));
}

} // namespace

namespace {

void check_sdpd(SimulationSettings const& s) {
  require(s.K >= 1 && std::isfinite(s.K), "particle size K", s.K, "must be >= 1 and finite");
  double const C = heat_capacity_of_a_particle(s);
  require(
      C > least_heat_capacity, "particle size K", s.K,
      fmt::format("is too small: a particle has the heat capacity {:.4g} k_B at rho and T{}, and above {} "
                  "k_B is needed for a positive friction (theory, Eq. (2.16))",
                  C, centre_of_mass_of(s) == CentreOfMass::free ? " without its centre of mass" : "",
                  least_heat_capacity));
  require(s.h_factor >= 1 && s.h_factor <= 10, "kernel support h_factor", s.h_factor, "must lie in 1 ... 10");
  auto const& [scale, self] = s.density_correction;
  require(scale > 0 && std::isfinite(scale), "density correction scale", scale, "must be > 0 and finite");
  require(self < scale && self > -scale, "density correction self", self,
          "must lie between -scale and scale");
  make_kernel(s.kernel, s.h_factor);
  auto const units = s.units();
  SdpdFriction(s.eta / units.viscosity(), s.zeta / units.viscosity());
  require(s.kappa >= 0 && std::isfinite(s.kappa), "thermal conductivity kappa", s.kappa, "must be >= 0");
  if (!s.noise && s.scheme.pairs == PairScheme::ems)
    throw InputError("scheme ems without noise: there is nothing to put to a Metropolis test; take ssa");
}

void check_pair_fluid(SimulationSettings const& s) {
  check(*s.pair_fluid);
  require(s.noise, "noise", s.noise, "DPD and DPDE need their noise");
  require(s.kappa == 0, "thermal conductivity kappa", s.kappa, "is a property of SDPD's fluid");
  bool const rejects = s.scheme.pairs == PairScheme::ams || s.scheme.pairs == PairScheme::ems;
  require(s.pair_fluid->follows_energy() || !rejects, "scheme", rejects ? "ams or ems" : "",
          "DPD has no internal energies, so there is no step to reject: take ssa or ser");
  require(s.pair_fluid->follows_energy() || !s.scheme.keep_energy, "energy", "kept",
          "DPD has no internal energies that could give or take energy");
}

} // namespace

void check(SimulationSettings const& s) {
  require(s.rho > 0 && std::isfinite(s.rho), "density rho", s.rho, "must be > 0 and finite");
  require(s.T > 0 && std::isfinite(s.T), "temperature T", s.T, "must be > 0 and finite");
  require(s.dt > 0 && std::isfinite(s.dt), "time step dt", s.dt, "must be > 0 and finite (reduced units)");
  require(s.skin >= 0 && std::isfinite(s.skin), "skin", s.skin, "must be >= 0");
  require(s.threads >= 1, "threads", s.threads, "must be >= 1");
  require(s.scheme.verlet_steps >= 1, "Verlet steps for one of fluctuation and dissipation",
          s.scheme.verlet_steps, "must be >= 1");
  require(s.disorder >= 0 && s.disorder <= 0.5, "disorder", s.disorder,
          "must lie in 0 ... 0.5 lattice spacings");
  for (auto const n : s.lattice)
    require(n >= 1, "particles along an edge", n, "must be >= 1");
  require(s.bath_rate >= 0 && std::isfinite(s.bath_rate), "rate of the bath", s.bath_rate, "must be >= 0");
  require(s.noise || s.bath_rate == 0, "rate of the bath", s.bath_rate, "must be 0 without noise");
  s.pair_fluid ? check_pair_fluid(s) : check_sdpd(s);
  CellGrid(box_of(s), s.range() + skin_of(s));
}

std::unique_ptr<System> make_system(SimulationSettings const& settings) {
  check(settings);
  auto system = build(settings);
  set_energies_from_temperatures(*system);
  refresh(*system);
  return system;
}

double SimulationSettings::spacing() const {
  return pair_fluid ? std::cbrt(pair_fluid->mass / rho) / units().length() : 1;
}

double SimulationSettings::range() const {
  return pair_fluid ? pair_fluid->range() / units().length() : h_factor;
}

ReducedUnits SimulationSettings::units() const {
  if (pair_fluid)
    return pair_fluid->units(T);
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
    : has_noise_(settings.noise), bath_rate_(settings.bath_rate), units_(settings.units()), dt_(settings.dt),
      scheme_(settings.scheme), system_(make_system(settings)) {}

Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

void Simulation::advance(std::uint64_t steps) {
  for (std::uint64_t k = 0; k < steps; ++k)
    sdpd::step(*system_, scheme_, dt_);
}
std::uint64_t Simulation::step() const {
  return system_->step;
}
Observation Simulation::observe() const {
  return sdpd::observe(*system_);
}
bool Simulation::has_thermostat() const {
  return !system_->has_energies();
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
  std::size_t const energies = particles.eps.size(), densities = particles.rho.size();
  Snapshot s{std::vector<Vec3>(n),           std::vector<Vec3>(n),          std::vector<double>(energies),
             std::vector<double>(densities), std::vector<double>(energies), std::vector<double>(densities)};
  for (std::size_t i = 0; i < n; ++i) {
    auto const id = particles.id[i];
    s.q[id] = box().wrap(particles.q[i]), s.p[id] = particles.p[i];
    if (energies > 0)
      s.eps[id] = particles.eps[i], s.T[id] = particles.T[i];
    if (densities > 0)
      s.rho[id] = particles.rho[i], s.P[id] = particles.P[i];
  }
  return s;
}

void Simulation::heat(double rise) {
  auto const C = heat_capacities(*system_);
  auto& eps = system_->particles.eps;
  auto const& T = system_->particles.T;
  double sum_C = 0, sum_CT = 0;
  for (std::size_t i = 0; i < eps.size(); ++i)
    sum_C += C[i], sum_CT += C[i] * T[i];
  double const factor = rise * sum_C / sum_CT; // one for all: small cold particles stay above zero
  for (std::size_t i = 0; i < eps.size(); ++i)
    eps[i] += C[i] * T[i] * factor;
  refresh(*system_);
}

void Simulation::couple_to_bath() {
  sdpd::couple_to_bath(*system_, bath_rate_, dt_);
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
  auto const C = heat_capacities(*system_);
  bool const small = system_->has_densities() ? units_.K < 50 : C.front() < 50;
  if (!small) {
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
  check_lengths(c, particles);
  // The lists of the checkpoint are those of its last renewal: renew them there, then move on.
  particles.id = c.id, particles.p = c.p, particles.eps = c.eps, particles.S = c.S, particles.T = c.T;
  particles.q = c.q_at_renewal;
  system_->neighbours.renew(particles);
  particles.q = c.q;
  system_->step = c.step;
  system_->kept_energy = c.kept_energy, system_->pair_counts = c.pair_counts;
  system_->conduction_counts = c.conduction_counts;
  refresh_by(*system_, response_from_temperature);
}

void Simulation::begin_from(Checkpoint const& c) {
  auto& particles = system_->particles;
  check_lengths(c, particles);
  particles.id = c.id, particles.q = c.q, particles.p = c.p, particles.eps = c.eps, particles.T = c.T;
  system_->step = c.step;
  system_->neighbours.renew(particles);
  refresh(*system_);
}

} // namespace mesobridge::sdpd
