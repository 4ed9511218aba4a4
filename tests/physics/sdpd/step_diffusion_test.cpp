#include "cg/diffusion.hpp"
#include "sdpd/method/step_diffusion.hpp"
#include "sdpd/setup/equilibration.hpp"
#include "sdpd_fixtures.hpp"
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <gtest/gtest.h>
#include <iostream>
#include <random>

namespace mesobridge::sdpd {
namespace {

TEST(StepDiffusion, IsThatOfAVelocityThatForgetsInSteps) {
  // sum of v_0 v_k over the steps by hand: step (1/2 + sum_k exp(-k rate step)), over 1/rate
  int cases = 0;
  for (double const step : {0.01, 0.3, 2.0}) {
    double const rate = 3;
    double sum = 0.5;
    for (int k = 1; k < 4000; ++k)
      sum += std::exp(-k * rate * step);
    EXPECT_NEAR(1 + diffusion_excess(rate, step), rate * step * sum, 1e-9) << step;
    ++cases;
  }
  EXPECT_EQ(cases, 3);
  EXPECT_NEAR(diffusion_excess(3, step_of_diffusion_excess(3, 0.05)), 0.05, 1e-9);
  EXPECT_NEAR(diffusion_excess(3, step_of_diffusion_excess(3, 7)), 7, 1e-9);
  EXPECT_TRUE(std::isinf(step_of_diffusion_excess(0, 0.05)));
}

std::vector<double> const excesses{0.05, 0.2, 0.6, 1.5, 5};

/// Diffusions D_0 = 2 with the share 0.4 of the excess, known to 2 %.
std::vector<cg::Estimate> diffusions(std::function<double()> const& noise) {
  std::vector<cg::Estimate> D;
  for (double const excess : excesses) {
    double const exact = 2 * (1 + 0.4 * excess);
    D.push_back({exact * (1 + 0.02 * noise()), 0.02 * exact, 100});
  }
  return D;
}

TEST(DiffusionAgainstStep, FindsTheShareWithItsError) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> gauss;
  constexpr int runs = 500;
  double squares = 0, mean = 0;
  int known = 0;
  for (int k = 0; k < runs; ++k)
    if (auto const found = diffusion_against_step(excesses, diffusions([&] { return gauss(random); }));
        found.known()) {
      squares += std::pow(cg::deviation(found.share, 0.4), 2), mean += found.share.mean;
      ++known;
    }
  EXPECT_GE(known, 495);                 // chance can bend every line
  EXPECT_NEAR(mean / known, 0.4, 0.005); // 0.019 in one run
  EXPECT_NEAR(squares / known, 1, 0.25); // by chance 0.06
}

TEST(DiffusionAgainstStep, LeavesOutStepsThatDoNotFollow) {
  auto D = diffusions([] { return 0.0; });
  auto const all = diffusion_against_step(excesses, D);
  EXPECT_NEAR(all.share.mean, 0.4, 1e-12);
  EXPECT_NEAR(all.D_0.mean, 2, 1e-12);
  EXPECT_EQ(all.share.n_eff, 5);
  D.back().mean *= 0.7; // 15 standard errors
  auto const less = diffusion_against_step(excesses, D);
  EXPECT_NEAR(less.share.mean, 0.4, 1e-12);
  EXPECT_EQ(less.share.n_eff, 4);
  D[1].se = D[2].se = 0; // not measured: two are left that follow
  EXPECT_FALSE(diffusion_against_step(excesses, D).known());
}

TEST(DiffusionAgainstStep, AllowsAtMostWhatAParticleAloneHas) {
  auto const at_most = [](double share, double se) {
    return DiffusionAgainstStep{.D_0 = {1, 0.1, 5}, .share = {share, se, 5}}.at_most();
  };
  EXPECT_DOUBLE_EQ(at_most(0.4, 0.1), 0.5);
  EXPECT_DOUBLE_EQ(at_most(-0.4, 0.1), 0.5); // slower by as much is no better
  EXPECT_DOUBLE_EQ(at_most(0.4, 2), 1);
  EXPECT_DOUBLE_EQ(at_most(1.4, 0.1), 1.5); // surely more
  EXPECT_DOUBLE_EQ(DiffusionAgainstStep{}.at_most(), 1);
}

/// Self-diffusion of particles of an ideal gas, which the structure hardly holds back.
cg::Estimate measured(SimulationSettings settings, double dt) {
  settings.dt = dt;
  Simulation simulation(settings);
  equilibrate(simulation, static_cast<std::uint64_t>(20 / dt), [] { return true; });
  cg::BlobSeries series{.molecules = simulation.size(), .atoms = 1, .mass = 1, .free_atoms = true};
  auto const every = static_cast<std::uint64_t>(std::lround(0.4 / dt));
  for (int k = 0; k < 300; ++k) {
    auto const now = simulation.snapshot();
    series.times.push_back(0.4 * k), series.boxes.push_back(simulation.box());
    series.R.insert(series.R.end(), now.q.begin(), now.q.end());
    series.P.insert(series.P.end(), now.p.begin(), now.p.end());
    simulation.advance(every);
  }
  return cg::diffusion(series).D;
}

// The friction of neighbours gives part of a momentum back, so that the whole excess is less; what a step
// adds is what it adds to a particle alone.
TEST(StepDiffusion, IsAtMostWhatTheFluidHas) {
  auto settings = ideal_gas(10, 0.1);
  settings.as<Sdpd>().kernel = "wendland-c4";
  settings.lattice = {7, 7, 7}, settings.disorder = 0.15, settings.scheme.pairs = "ems";
  double const rate = velocity_decay_rate(settings), tolerable = step_of_diffusion_excess(rate, 0.05);
  auto const slow = measured(settings, 0.025), quick = measured(settings, 0.4);
  auto const kept = measured(settings, 0.05);
  auto const share = [&](cg::Estimate const& of) { return of.mean / slow.mean - 1; };
  auto const se = [&](cg::Estimate const& of) {
    return of.mean / slow.mean * std::hypot(of.se / of.mean, slow.se / slow.mean);
  };
  std::cout << fmt::format(
      "rate {:.3g}, dt for 5 % {:.3g}; excess at 0.4: {:.3f}({:.3f}), bound {:.3f}; at 0.05: "
      "{:.3f}({:.3f}), bound {:.3f}; D {:.5f} {:.5f}, {:.5f}\n",
      rate, tolerable, share(quick), se(quick), diffusion_excess(rate, 0.4), share(kept), se(kept),
      diffusion_excess(rate, 0.05), slow.mean, quick.mean, 0.1 / rate);
  EXPECT_GT(share(quick), 1);
  EXPECT_LT(share(quick), diffusion_excess(rate, 0.4) + 3 * se(quick));
  EXPECT_LT(share(kept), diffusion_excess(rate, 0.05) + 3 * se(kept));
}

} // namespace
} // namespace mesobridge::sdpd
