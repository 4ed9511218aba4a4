#include "workflows/size_study/fluid_run.hpp"
#include "sdpd/observe/canonical_energy.hpp"
#include "sdpd/observe/radial_distribution.hpp"
#include "sdpd/setup/equilibration.hpp"
#include "workflows/interrupt.hpp"
#include <algorithm>
#include <span>

namespace mesobridge::workflows {

namespace {

constexpr std::uint32_t side = 10; // of the lattice, in particles
constexpr std::uint64_t instants = 20;

/// Small particles are fast and have small heat capacities: they need short steps.
double time_step(double K) {
  return K < 50 ? 0.03 : K < 1000 ? 0.06 : K < 10000 ? 0.1 : 0.2;
}

/// SSA leads an energy below zero now and then where particles are small (Gamma-distributed energies come
/// near zero); EMS does not, and its equilibrium is exact.
std::string scheme_of(double K) {
  return K < 50 ? "ems" : "ssa";
}

/// A structure that still settles sets energy free, which friction passes on to the internal energies: in
/// between it warms the motion. Counted in k_BT that energy goes as K. At K = 25000 the motion is too warm by
/// 2 per cent after 250 units of time and by 0.3 or less after 2000; with the kernel Wendland C2 such
/// particles crystallise on the way.
std::uint64_t settling_steps(SizeRunLength const& run_length, double K) {
  return std::max(run_length.settle,
                  static_cast<std::uint64_t>(run_length.settle_per_size * K / time_step(K)));
}

/// Kinetic and internal energy of a particle that the invariant measure gives, at densities that were met.
class ExpectedEnergy {
 public:
  ExpectedEnergy(sdpd::SimulationSettings const& settings, std::size_t particles)
      : internal_(settings), kinetic_(1.5 * (1 - 1 / static_cast<double>(particles)) / settings.K()) {}
  void add(std::span<double const> rho) {
    for (double const one : rho)
      sum_ += internal_(one);
    count_ += rho.size();
  }
  double mean() const { return kinetic_ + sum_ / static_cast<double>(count_); }

 private:
  sdpd::CanonicalEnergy internal_;
  double kinetic_, sum_ = 0;
  std::size_t count_ = 0;
};

} // namespace

sdpd::SimulationSettings fluid(std::string const& kernel, double K, std::uint64_t seed) {
  return {.method = sdpd::Sdpd{.eos = fitting::material("argon").eos, .K = K, .kernel = kernel, .eta = 2e-3},
          .rho = state_rho,
          .T = state_T,
          .lattice = {side, side, side},
          .disorder = 0.15,
          .dt = time_step(K),
          .scheme = {.pairs = scheme_of(K)},
          .seed = seed};
}

fitting::EosState eos_state(sdpd::SimulationSettings const& s) {
  return std::visit([&](auto const& eos) { return fitting::state_from_temperature(eos, s.rho, s.T); },
                    s.as<sdpd::Sdpd>().eos);
}

FluidRun run_fluid(sdpd::SimulationSettings const& settings, Treatment treatment,
                   SizeRunLength const& run_length) {
  sdpd::Simulation simulation(settings);
  auto const keep_going = [] { return !interrupt_requested(); };
  sdpd::equilibrate(simulation, settling_steps(run_length, settings.K()), keep_going);
  auto const eos = eos_state(settings);
  auto const units = settings.units();
  constexpr std::uint64_t every = 3;
  auto const& fluid = settings.as<sdpd::Sdpd>();
  FluidRun result{
      .kernel = fluid.kernel, .K = fluid.K, .treatment = treatment, .constants = fluid.density_correction};
  std::vector<double> P, rho, T_kin, T_int;
  std::uint64_t const samples = run_length.sample / every,
                      between = std::max<std::uint64_t>(1, samples / instants);
  double energy = 0;
  ExpectedEnergy expected(settings, simulation.size());
  for (std::uint64_t k = 0; k < samples; ++k) {
    simulation.advance(every);
    throw_if_interrupted();
    auto const now = simulation.observe();
    P.push_back(now.P), rho.push_back(now.rho), T_kin.push_back(now.T_kin), T_int.push_back(now.T_int);
    energy += now.energy() / static_cast<double>(samples * simulation.size());
    if (k % between != 0)
      continue;
    auto const particles = simulation.snapshot();
    expected.add(particles.rho);
    for (std::size_t i = 0; i < particles.rho.size(); ++i)
      result.rho_i.push_back(particles.rho[i] * units.density),
          result.P_i.push_back(particles.P[i] * units.pressure() / 1e9);
  }
  result.P = scaled(cg::estimate_mean(P), units.pressure() / eos.P);
  result.rho = cg::estimate_mean(rho);
  result.T_kin = cg::estimate_mean(T_kin), result.T_int = cg::estimate_mean(T_int);
  result.energy = energy * units.specific_energy() / eos.e;
  result.energy_expected = expected.mean() * units.specific_energy() / eos.e;
  return result;
}

Structure find_structure(std::string const& kernel, double K, std::uint64_t seed,
                         SizeRunLength const& run_length) {
  constexpr double r_max = 4;
  constexpr std::size_t bins = 100;
  auto const settings = fluid(kernel, K, seed);
  sdpd::Simulation simulation(settings);
  sdpd::equilibrate(simulation, settling_steps(run_length, K), [] { return !interrupt_requested(); });
  sdpd::RadialDistribution g(simulation.box(), r_max, bins);
  for (std::uint64_t k = 0; k < instants; ++k) {
    simulation.advance(run_length.sample / (2 * instants));
    throw_if_interrupted();
    g.add(simulation.snapshot().q);
  }
  Structure structure{.kernel = kernel, .r = {}, .g = g.g(), .pairs = g.neighbours_within(0.5)};
  for (std::size_t bin = 0; bin < bins; ++bin)
    structure.r.push_back(g.centre(bin));
  return structure;
}

} // namespace mesobridge::workflows
