#include "cg/diffusion.hpp"
#include "sdpd/observe/set_energy.hpp"
#include "sdpd/setup/equilibration.hpp"
#include "sdpd_fixtures.hpp"
#include <cmath>
#include <fmt/format.h>
#include <gsl/gsl_cdf.h>
#include <gtest/gtest.h>
#include <iostream>
#include <map>
#include <numeric>

// Are the errors that short runs quote the spread of such runs?

namespace mesobridge::sdpd {
namespace {

constexpr double settling = 75, dt = 0.1; // reduced

SimulationSettings melted_argon(std::uint32_t side, std::uint64_t seed) {
  auto settings = argon(100, dt);
  settings.as<Sdpd>().kernel = "wendland-c4";
  settings.lattice = {side, side, side}, settings.melted = true, settings.seed = seed;
  return settings;
}

/// The particles at equal intervals, as what measures diffusion takes them.
void record(cg::BlobSeries& series, Simulation const& simulation, double time) {
  auto const now = simulation.snapshot();
  series.times.push_back(time), series.boxes.push_back(simulation.box());
  series.R.insert(series.R.end(), now.q.begin(), now.q.end());
  series.P.insert(series.P.end(), now.p.begin(), now.p.end());
}

struct Means {
  std::map<std::string, cg::Estimate> all;
  cg::Estimate T_int_by_samples; ///< without the error of the energy that was set
};

Means short_run(std::uint32_t side, double duration, std::uint64_t seed) {
  auto const settings = melted_argon(side, seed);
  Simulation simulation(settings);
  equilibrate(simulation, static_cast<std::uint64_t>(settling / dt), [] { return true; });
  EquilibriumSampler sampler(settings.features());
  cg::BlobSeries series{.molecules = simulation.size(), .atoms = 1, .mass = 1, .free_atoms = true};
  for (int step = 0; step <= std::lround(duration / dt); ++step) {
    if (step > 0)
      simulation.advance(1);
    if (step % 4 == 0)
      sampler.sample(simulation.observe(), step * dt);
    if (step % 10 == 0)
      sampler.sample(moments(simulation.snapshot())), record(series, simulation, step * dt);
  }
  auto found = sampler.result();
  auto const T_int = found.T_int;
  SetEnergy const set{.last_part = last_share_of_equilibration * settling,
                      .kinetic_capacity = 1.5 * double(simulation.size() - 1) / settings.K(),
                      .capacity = simulation.heat_capacity() / settings.K(),
                      .pressure_slope = pressure_slope(settings),
                      .particles = simulation.size()};
  add_error_of_set_energy(found, set_temperature_error(sampler, set), set);
  return {.all = {{"T_kin", found.T_kin},
                  {"T_int", found.T_int},
                  {"P", found.P},
                  {"rho", found.rho.mean},
                  {"var eps", found.eps.variance},
                  {"var rho", found.rho.variance},
                  {"D", cg::diffusion(series).D},
                  {"drift", {found.drift.rate, found.drift.se, 8}}},
          .T_int_by_samples = T_int};
}

/// Chi^2 per degree of freedom of the estimates about their mean.
double chi_squared(std::vector<cg::Estimate> const& runs) {
  double mean = 0, sum = 0;
  for (auto const& run : runs)
    mean += run.mean / double(runs.size());
  for (auto const& run : runs)
    sum += std::pow(cg::deviation(run, mean), 2);
  return sum / double(runs.size() - 1);
}

/// Where chi^2 per degree of freedom of `runs` runs lies with this probability.
std::pair<double, double> chi_squared_range(std::size_t runs, double probability) {
  double const freedom = double(runs - 1), tail = 0.5 * (1 - probability);
  return {gsl_cdf_chisq_Pinv(tail, freedom) / freedom, gsl_cdf_chisq_Qinv(tail, freedom) / freedom};
}

/// Several ranges are to hold together with 95 %: each one is that of 1 - 0.05/8.
void expect_spreads_as_quoted(std::vector<Means> const& runs) {
  auto const [low, high] = chi_squared_range(runs.size(), 1 - 0.05 / 8);
  std::size_t quantities = 0;
  for (auto const& [name, ignored] : runs.front().all) {
    std::vector<cg::Estimate> of;
    for (auto const& run : runs)
      of.push_back(run.all.at(name));
    double const chi = chi_squared(of);
    auto const n_eff = std::accumulate(of.begin(), of.end(), 0.0, [&](double sum, auto const& e) {
      return sum + e.n_eff / double(of.size());
    });
    std::cout << fmt::format("{:<8} chi^2 {:.2f}, n_eff {:.0f}\n", name, chi, n_eff);
    EXPECT_GT(chi, low) << name;
    EXPECT_LT(chi, high) << name;
    ++quantities;
  }
  EXPECT_EQ(quantities, 8u);
}

std::vector<Means> runs_of(std::uint32_t side, double duration, std::uint64_t seeds) {
  std::vector<Means> runs;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed)
    runs.push_back(short_run(side, duration, seed));
  return runs;
}

TEST(QuotedErrors, AreTheSpreadOfShortRuns) {
  auto const runs = runs_of(6, 250, 8);
  expect_spreads_as_quoted(runs);
  std::vector<cg::Estimate> alone;
  for (auto const& run : runs)
    alone.push_back(run.T_int_by_samples);
  EXPECT_GT(chi_squared(alone), chi_squared_range(8, 0.95).second)
      << "samples of one run know nothing of the energy that was set";
}

TEST(Long_QuotedErrors, AreTheSpreadOf32Runs) {
  expect_spreads_as_quoted(runs_of(7, 450, 32));
}

} // namespace
} // namespace mesobridge::sdpd
