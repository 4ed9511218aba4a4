#include "cg/estimate.hpp"
#include "fitting/eos/evaluate.hpp"
#include "sdpd/observe/canonical_energy.hpp"
#include "sdpd/setup/equilibration.hpp"
#include "sdpd_fixtures.hpp"
#include <gtest/gtest.h>

namespace mesobridge::sdpd {
namespace {

// Its energies follow Gamma(C_K/k_B, k_BT), whose mean is C_K T: C_K = (3/2)(K - 1) k_B, and (3/2) K k_B with
// the centre of mass.
TEST(CanonicalEnergy, OfTheIdealGasIsThatOfTheGammaLaw) {
  int cases = 0;
  for (double const K : {2.0, 5.0, 100.0, 25000.0})
    for (bool const free : {true, false}) {
      auto settings = ideal_gas(K, 0.1);
      settings.as<Sdpd>().centre_of_mass = free ? CentreOfMass::free : CentreOfMass::bulk;
      CanonicalEnergy const energy(settings);
      double const C = 1.5 * (free ? K - 1 : K);
      EXPECT_NEAR(K * energy(1) / C, 1, 1e-7) << K;
      EXPECT_NEAR(energy(1.3), energy(1), 1e-12) << K;
      ++cases;
    }
  EXPECT_EQ(cases, 8);
}

// Small particles of argon: the total energy is not the equation of state's at the mean density and
// temperature, but the invariant measure's.
TEST(CanonicalEnergy, IsThatOfSmallParticles) {
  auto settings = argon(5, 0.03);
  settings.lattice = {8, 8, 8}, settings.disorder = 0.15;
  settings.as<Sdpd>().density_correction = {.scale = 0.9985, .self = 0.1};
  Simulation simulation(settings);
  equilibrate(simulation, 320, [] { return true; });
  CanonicalEnergy const internal(settings);
  double const count = static_cast<double>(simulation.size());
  std::vector<double> found, expected;
  for (int k = 0; k < 60; ++k) {
    simulation.advance(6);
    double sum = 0;
    for (double const rho : simulation.snapshot().rho)
      sum += internal(rho);
    expected.push_back(1.5 * (count - 1) / settings.K() + sum);
    auto const now = simulation.observe();
    // at constant energy both temperatures scatter about the set one; with their heat capacities taken out
    double const kinetic = 1.5 * (count - 1) / settings.K(), all = simulation.heat_capacity() / settings.K();
    found.push_back(now.energy() - kinetic * (now.T_kin - 1) - (all - kinetic) * (now.T_int - 1));
  }
  auto const ours = cg::estimate_mean(found), measure = cg::estimate_mean(expected);
  EXPECT_LT(ours.se / ours.mean, 5e-4);
  EXPECT_NEAR(ours.mean / measure.mean, 1, 1e-3);
  auto const eos = std::visit(
      [&](auto const& model) { return fitting::state_from_temperature(model, settings.rho, settings.T); },
      settings.as<Sdpd>().eos);
  EXPECT_LT(ours.mean * settings.units().specific_energy() / eos.e / count, 0.996);
  RecordProperty("ratio", std::to_string(ours.mean / measure.mean));
}

} // namespace
} // namespace mesobridge::sdpd
