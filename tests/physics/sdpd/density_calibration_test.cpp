#include "cg/estimate.hpp"
#include "fitting/eos/evaluate.hpp"
#include "sdpd/method/settings.hpp"
#include "sdpd/setup/calibrate_density.hpp"
#include "sdpd/setup/equilibration.hpp"
#include "sdpd_fixtures.hpp"
#include <gtest/gtest.h>

namespace mesobridge::sdpd {
namespace {

/// Ratios to the equation of state at the set density and temperature.
struct Means {
  cg::Estimate P, rho, T_int;
  double energy;
};

Means measure(SimulationSettings const& settings, std::uint64_t settle, std::uint64_t steps) {
  Simulation simulation(settings);
  equilibrate(simulation, settle, [] { return true; });
  auto const eos = std::visit(
      [&](auto const& model) { return fitting::state_from_temperature(model, settings.rho, settings.T); },
      settings.as<Sdpd>().eos);
  std::vector<double> P, rho, T;
  for (std::uint64_t k = 0; k < steps; k += 3) {
    simulation.advance(3);
    auto const now = simulation.observe();
    P.push_back(now.P * settings.units().pressure() / eos.P);
    rho.push_back(now.rho), T.push_back(now.T_int);
  }
  double const energy = simulation.observe().energy() / static_cast<double>(simulation.size());
  return {cg::estimate_mean(P), cg::estimate_mean(rho), cg::estimate_mean(T),
          energy * settings.units().specific_energy() / eos.e};
}

struct Case {
  double K, dt;
  std::string kernel;
};

SimulationSettings small_box(Case const& c) {
  auto settings = argon(c.K, c.dt);
  settings.as<Sdpd>().kernel = c.kernel;
  settings.lattice = {8, 8, 8};
  settings.disorder = 0.15;
  return settings;
}

void expect_the_equation_of_state(Case const& c, std::uint64_t calibration, std::uint64_t settle,
                                  std::uint64_t steps) {
  SCOPED_TRACE(c.kernel + ", K = " + std::to_string(c.K));
  auto settings = small_box(c);
  auto const found = calibrate_density(settings, ScaleCondition::pressure, calibration, [] { return true; });
  EXPECT_LT(found.scale_se, 0.003);
  settings.as<Sdpd>().density_correction = found.constants;
  settings.seed = 77; // another history than the calibration's
  auto const means = measure(settings, settle, steps);
  EXPECT_NEAR(means.P.mean, 1, 0.01);
  EXPECT_NEAR(means.rho.mean, 1, 0.003);
  EXPECT_NEAR(means.T_int.mean, 1, 0.003);
  EXPECT_NEAR(means.energy, 1, 0.01);
  EXPECT_LT(means.P.se, 0.002);
  EXPECT_LT(means.rho.se, 0.001);
}

// The thesis's fluid with the constants of a calibration: pressure within 1 %, mean density within 0.3 %, the
// total energy per atom within 1 %.
TEST(DensityCalibration, MakesPressureAndDensityThoseOfTheEquationOfState) {
  std::vector<Case> const cases{{5, 0.03, "cubic"}, {100, 0.06, "wendland-c2"}, {1000, 0.1, "cubic"}};
  for (auto const& c : cases)
    expect_the_equation_of_state(c, 800, 200, 600);
  EXPECT_EQ(cases.size(), 3u);
  // What it is for: without constants the mean density is off, and with the bulk's equation of state the
  // energy, too.
  auto plain = small_box(cases[0]);
  plain.as<Sdpd>().centre_of_mass = CentreOfMass::bulk;
  auto const means = measure(plain, 100, 300);
  EXPECT_GT(means.rho.mean, 1.015);
  EXPECT_GT(means.P.mean, 1.03);
  EXPECT_GT(means.energy, 1.15);
}

// A dense, cold fluid, whose pressure is an eighth of that at 1000 K.
TEST(DensityCalibration, ByTheResponseServesALowPressure) {
  auto settings = small_box({50, 0.03, "cubic"});
  settings.T = 180;
  auto never = [] { return true; };
  settings.as<Sdpd>().density_correction =
      calibrate_density(settings, ScaleCondition::response, 800, never).constants;
  settings.seed = 5;
  Simulation simulation(settings);
  equilibrate(simulation, 200, never);
  std::vector<double> rho, response;
  for (int k = 0; k < 300; ++k) {
    simulation.advance(1);
    rho.push_back(simulation.observe().rho), response.push_back(simulation.compression_response());
  }
  EXPECT_NEAR(cg::estimate_mean(rho).mean, 1, 0.003);
  EXPECT_NEAR(cg::estimate_mean(response).mean, 1, 0.003);
  settings.T = 87, settings.rho = 1400; // at its boiling point
  EXPECT_THROW(calibrate_density(settings, ScaleCondition::pressure, 800, never), InputError);
}

// Particles so large that they hardly move settle into a glass, whose mean density asks for the self term.
TEST(GlassCorrection, IsThatOfAGlass) {
  struct Glass {
    std::string kernel;
    double tolerance; ///< of the mean density
  };
  int cases = 0;
  for (auto const& [kernel, tolerance] : {Glass{"wendland-c2", 5e-4},
                                          {"wendland-c4", 2.5e-3},
                                          {"wendland-c6", 2.5e-3},
                                          {"cubic", 5e-4},
                                          {"lucy", 3.5e-3}}) {
    SCOPED_TRACE(kernel);
    auto settings = small_box({1e6, 0.1, kernel});
    double const h = settings.as<Sdpd>().h_factor;
    settings.as<Sdpd>().density_correction = glass_correction(kernel, 4 * std::numbers::pi / 3 * h * h * h);
    Simulation simulation(settings);
    equilibrate(simulation, 300, [] { return true; });
    EXPECT_NEAR(simulation.observe().rho, 1, tolerance);
    settings.as<Sdpd>().density_correction = {};
    Simulation plain(settings);
    plain.advance(300);
    EXPECT_GT(std::abs(plain.observe().rho - 1), 2e-3);
    ++cases;
  }
  EXPECT_EQ(cases, 5);
}

// The response is the derivative of the mean density with respect to ln(1/V) at scaled positions.
TEST(CompressionResponse, IsTheDerivativeOfTheMeanDensity) {
  auto settings = small_box({50, 0.05, "wendland-c4"});
  settings.as<Sdpd>().density_correction = {.scale = 1.02, .self = 0.1};
  Simulation simulation(settings);
  simulation.advance(50);
  auto const now = simulation.snapshot();
  auto const kernel = make_kernel(settings.as<Sdpd>().kernel, settings.as<Sdpd>().h_factor, 1.02);
  auto mean_density = [&](double stretch) {
    double sum = 0;
    for (std::size_t i = 0; i < now.q.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        double const r = stretch * norm(simulation.box().minimum_image(now.q[i] - now.q[j]));
        sum += r < 2.5 ? 2 * std::visit([r](auto const& of) { return of.W(r); }, kernel) : 0;
      }
    return sum / static_cast<double>(now.q.size());
  };
  double const d = 1e-5; // V goes as stretch^3
  double const slope = (mean_density(1 - d) - mean_density(1 + d)) / (6 * d);
  EXPECT_NEAR(simulation.compression_response(), slope, 1e-7);
}

TEST(Long_DensityCalibration, HoldsAtEverySizeForTwoKernels) {
  int cases = 0;
  for (std::string const kernel : {"cubic", "wendland-c2"})
    for (double const K : {5, 10, 25, 50, 100, 250, 500, 1000, 2500, 5000, 10000, 25000}) {
      expect_the_equation_of_state({K, K < 50 ? 0.03 : K < 1000 ? 0.06 : 0.1, kernel}, 3000, 1000, 3000);
      ++cases;
    }
  EXPECT_EQ(cases, 24);
}

} // namespace
} // namespace mesobridge::sdpd
