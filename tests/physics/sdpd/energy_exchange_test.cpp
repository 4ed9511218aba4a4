#include "cg/energy_exchange.hpp"
#include "pair_fluid_fixtures.hpp"
#include "sdpd/simulation.hpp"
#include <gtest/gtest.h>

namespace mesobridge::sdpd {
namespace {

constexpr double C = 30, gamma_par = 4.5, gamma_perp = 8, kappa = 20; // gamma_par is the fixture's

/// DPDE particles that exchange heat by friction and by conduction, at equal intervals; m, r_c and k_BT are
/// one.
cg::BlobSeries particles_that_conduct() {
  auto settings = dpde_fluid(C, 0.01, gamma_perp);
  settings.as<Dpde>().conduction = PowerFriction(kappa, 0, 1, 2);
  settings.lattice = {7, 7, 7};
  Simulation simulation(settings);
  simulation.draw_temperatures();
  simulation.advance(500);
  cg::BlobSeries series{.molecules = simulation.size(), .atoms = 1, .mass = 1};
  for (int instant = 0; instant < 5000; ++instant) {
    simulation.advance(1);
    auto const now = simulation.snapshot();
    series.times.push_back(0.01 * instant);
    series.boxes.push_back(simulation.box());
    series.R.insert(series.R.end(), now.q.begin(), now.q.end());
    series.U.insert(series.U.end(), now.eps.begin(), now.eps.end());
  }
  return series;
}

// What is put in must come out: the flow of a pair is k_B kappa (1-r)^2 less what friction takes from both,
// (gamma_par + 2 gamma_perp) (1-r)^2 (k_BT)^2/2m (cg/README.md, Eq. (C41)).
TEST(EnergyExchange, FindsTheConductionThatWasPutIn) {
  auto const series = particles_that_conduct();
  auto const found = cg::energy_exchange(
      series, {.from = 0.01, .to = 0.12, .longest = 0.12, .cutoff = 1, .width = 0.125, .blocks = 12});
  int bins = 0, wrong = 0;
  for (auto const& bin : found.bins) {
    if (bin.neighbours < 0.2)
      continue;
    double const weight = (1 - bin.r) * (1 - bin.r),
                 put_in = (kappa - (gamma_par + 2 * gamma_perp) / 2) * weight;
    EXPECT_TRUE(cg::agrees(bin.flow, put_in, 4))
        << bin.r << ": " << bin.flow.mean << " +- " << bin.flow.se << ", not " << put_in;
    wrong += cg::agrees(bin.flow, kappa * weight, 4) ? 0 : 1;
    ++bins;
  }
  EXPECT_GE(bins, 5);
  EXPECT_GE(wrong, 2); // without friction's share
  EXPECT_NEAR(found.variance.mean / C, 1, 0.1);
}

} // namespace
} // namespace mesobridge::sdpd
