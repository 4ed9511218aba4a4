#include "workflows/coarse/potential_search.hpp"
#include "md/error.hpp"
#include "sdpd/observe/radial_distribution.hpp"
#include "sdpd/simulation.hpp"
#include "workflows/interrupt.hpp"
#include <algorithm>
#include <cmath>

namespace mesobridge::workflows {
namespace {

constexpr int most_without_gain = 5;

/// From r = 0 to the cut-off, where it is zero.
sdpd::TabulatedPotential table_of(cg::PairPotential const& potential) {
  auto const& u = potential.u;
  std::vector<double> r{0}, values{u[0] + (u[0] - u[1]) / 8}; // a + b r^2 through the first two
  for (std::size_t k = 0; k < u.size(); ++k)
    r.push_back(potential.r(k)), values.push_back(u[k]);
  r.push_back(potential.cutoff()), values.push_back(0);
  return {r, values};
}

sdpd::SimulationSettings settings_of(cg::PairPotential const& potential, CoarseStructure const& structure,
                                     PotentialSearch const& search) {
  double const r_c = potential.cutoff(),
               friction = search.friction * std::sqrt(structure.mass * structure.kT) / r_c;
  return {.method = sdpd::Dpd{{.mass = structure.mass,
                               .potential = table_of(potential),
                               .friction = sdpd::PowerFriction(friction, 0, r_c, 2)}},
          .rho = structure.mass * structure.density,
          .T = structure.kT,
          .lattice = {search.lattice, search.lattice, search.lattice},
          .disorder = 0.05,
          .dt = search.dt,
          .seed = search.seed,
          .threads = search.threads};
}

/// A target near zero asks for no more digits than an ideal gas has.
double pressure_scale(CoarseStructure const& structure) {
  return std::max(std::abs(*structure.P), structure.density * structure.kT);
}

} // namespace

void check_search(PotentialSearch const& search) {
  constexpr std::uint64_t least_samples = 16; // of an error
  require(search.iterations >= 1, "iterations", search.iterations, "must be at least 1");
  require(search.every >= 1, "steps between instants", search.every, "must be at least 1");
  require(search.sample >= least_samples * search.every, "steps", search.sample,
          fmt::format("must be at least {}, {} instants, for a standard error", least_samples * search.every,
                      least_samples));
  require(search.enough >= 0, "enough", search.enough, "must be >= 0");
}

PotentialTrial try_potential(cg::PairPotential const& potential, CoarseStructure const& structure,
                             PotentialSearch const& search) {
  sdpd::Simulation simulation(settings_of(potential, structure, search));
  auto const& units = simulation.units();
  auto const& target = structure.g;
  sdpd::RadialDistribution found(simulation.box(), target.width * double(target.g.size()) / units.length(),
                                 target.g.size());
  std::vector<double> pressures;
  auto const advance = [&](std::uint64_t steps) {
    if (interrupt_requested())
      throw Interrupted("stopped while a potential was looked for: begin again");
    simulation.advance(steps);
  };
  for (std::uint64_t step = 0; step < search.settle; step += search.every)
    advance(search.every);
  for (std::uint64_t step = 0; step < search.sample; step += search.every) {
    advance(search.every);
    found.add(simulation.snapshot().q);
    pressures.push_back(simulation.observe().P * units.pressure());
  }
  PotentialTrial trial{
      .potential = potential, .g = {target.width, found.g()}, .P = cg::estimate_mean(pressures)};
  trial.distance = trial.difference = cg::g_difference(target, trial.g);
  if (structure.P)
    trial.distance += std::pow((trial.P.mean - *structure.P) / pressure_scale(structure), 2);
  return trial;
}

std::vector<PotentialTrial> search_potential(CoarseStructure const& structure, PotentialSearch const& search,
                                             std::function<void(int)> const& done) {
  check_search(search);
  std::vector<PotentialTrial> trials;
  auto potential = cg::boltzmann_potential(structure.g, search.inversion);
  int without_gain = 0;
  for (int k = 0; k < search.iterations; ++k) {
    trials.push_back(try_potential(potential, structure, search));
    auto const& now = trials.back();
    without_gain = &best(trials) == &now ? 0 : without_gain + 1;
    done(k + 1);
    if (now.distance < search.enough || without_gain == most_without_gain)
      break;
    potential = structure.P ? cg::inverted_at_pressure(potential, structure.g, now.g, search.inversion,
                                                       structure.density, now.P.mean - *structure.P)
                            : cg::inverted(potential, structure.g, now.g, search.inversion);
  }
  return trials;
}

PotentialTrial const& best(std::vector<PotentialTrial> const& trials) {
  return *std::ranges::min_element(trials, {}, &PotentialTrial::distance);
}

} // namespace mesobridge::workflows
