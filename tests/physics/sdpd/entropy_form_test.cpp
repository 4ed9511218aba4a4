#include "cg/estimate.hpp"
#include "sdpd/conservative/conservative.hpp"
#include "sdpd/fluctuation/fluctuation_entropy.hpp"
#include "sdpd/make_system.hpp"
#include "sdpd/scheme/list.hpp"
#include "sdpd/state/random.hpp"
#include "sdpd/system/total_energy.hpp"
#include "sdpd_fixtures.hpp"
#include <gtest/gtest.h>

namespace mesobridge::sdpd {
namespace {

// The covariance of the matrix noise is that of the energy form's projected noise.
TEST(EntropyForm, HasTheNoiseOfTheEnergyForm) {
  double const A = 1.3, B = 0.7;
  Vec3 const e{0.36, 0.48, 0.8}, across = Vec3{0.8, -0.6, 0};
  NoiseSource const source(5, Stream::fluctuation, 0);
  int const n = 200000;
  double par = 0, perp = 0, mixed = 0;
  for (std::uint32_t k = 0; k < n; ++k) {
    auto const d = gaussians_reference(source, k, 0), o = gaussians_reference(source, k, 1);
    Vec3 const noise = matrix_noise(A, B, e, {d[0], d[1], d[2]}, {o[0], o[1], o[2]});
    par += dot(noise, e) * dot(noise, e) / n;
    perp += dot(noise, across) * dot(noise, across) / n;
    mixed += dot(noise, across) * dot(noise, e) / n;
  }
  double const z = 5 * std::sqrt(2.0 / n), par_exact = 2 * A * A / 3 + B * B / 3, perp_exact = A * A / 2;
  EXPECT_NEAR(par, par_exact, z * par_exact);
  EXPECT_NEAR(perp, perp_exact, z * perp_exact);
  EXPECT_NEAR(mixed, 0, z * std::sqrt(par_exact * perp_exact));
}

struct Sampled {
  cg::Estimate T_kin, T_int, width; ///< width: variance of eps over that of the Gamma law (Eq. (S19))
  double energy_error;              ///< rms relative change of the energy in one step
};

Sampled sample(char const* integrator, double dt) {
  double const K = 100, C = 1.5 * (K - 1);
  auto settings = ideal_gas(K, dt);
  settings.disorder = 0.2;
  auto const system = make_system(settings);
  auto& particles = system->particles;
  for (std::size_t i = 0; i < system->size();
       ++i) // the width of the Gamma law from the start: it takes long to come
    particles.eps[i] *=
        1 + gaussians_reference(NoiseSource(3, Stream::initial_energies, 0), particles.id[i], 0)[0] /
                std::sqrt(C);
  thermodynamics_from_energy(*system);
  std::vector<double> T_kin, T_int, width;
  double square = 0;
  int const steps = static_cast<int>(std::lround(8 / dt));
  for (int k = 0; k < steps; ++k, ++system->step) {
    double const before = total_energy(*system);
    pair_integrator(integrator).sweep(*system, dt, false);
    thermodynamics_from_energy(*system);
    double const change = total_energy(*system) / before - 1;
    square += change * change / steps;
    auto const now = observe(*system);
    double mean = 0, variance = 0;
    for (double const eps : particles.eps)
      mean += eps * K / 1000;
    for (double const eps : particles.eps)
      variance += (eps * K - mean) * (eps * K - mean) / 999;
    T_kin.push_back(now.T_kin), T_int.push_back(now.T_int),
        width.push_back(variance / (C * now.T_int * now.T_int));
  }
  return {cg::estimate_mean(T_kin), cg::estimate_mean(T_int), cg::estimate_mean(width), std::sqrt(square)};
}

// Euler's steps heat in proportion to dt, and nothing is left in the limit: so the coefficients of the
// entropies' equation belong to those of the momenta's.
TEST(EntropyForm, ConservesEnergyInTheLimitOfShortSteps) {
  double const time = 1.5;
  std::array<double, 2> rise{};
  int made = 0;
  for (double const dt : {0.002, 0.001}) {
    auto settings = ideal_gas(10, dt);
    settings.lattice = {7, 7, 7}, settings.disorder = 0.2;
    auto const system = make_system(settings);
    double const before = total_energy(*system);
    for (int k = 0; k < static_cast<int>(std::lround(time / dt)); ++k, ++system->step) {
      fluctuate_entropies(*system, dt);
      thermodynamics_from_energy(*system);
    }
    rise[static_cast<std::size_t>(made++)] = (total_energy(*system) / before - 1) / time;
  }
  ASSERT_EQ(made, 2);
  EXPECT_NEAR(rise[0] / rise[1], 2, 0.5);
  EXPECT_NEAR(2 * rise[1] - rise[0], 0, 0.02); // extrapolated to dt = 0
  EXPECT_GT(rise[0], 0.04);
}

// The same measure as the energy form: temperatures and the spread of the energies agree within their errors;
// the energy is not conserved in a step, but better in a shorter one.
TEST(EntropyForm, HasTheMeasureOfTheEnergyFormAtShortSteps) {
  auto const original = sample("entropy", 0.01), finer = sample("entropy", 0.005),
             energy_form = sample("ssa", 0.01);
  auto agree = [](cg::Estimate const& a, cg::Estimate const& b) {
    return std::abs(a.mean - b.mean) / std::hypot(a.se, b.se);
  };
  EXPECT_LT(std::abs(finer.T_kin.mean / finer.T_int.mean - 1),
            0.03); // explicit Euler is a little hot, as SER is
  EXPECT_LT(agree(finer.T_int, energy_form.T_int), 5) << finer.T_int.mean << " +- " << finer.T_int.se;
  EXPECT_LT(agree(finer.width, energy_form.width), 5) << finer.width.mean << " " << energy_form.width.mean;
  EXPECT_GT(original.energy_error / finer.energy_error, 1.6);
  EXPECT_LT(original.energy_error / finer.energy_error, 4);
  EXPECT_GT(finer.energy_error, 1e-6);
  EXPECT_LT(energy_form.energy_error, 1e-15);
  RecordProperty("T_kin", std::to_string(finer.T_kin.mean));
  RecordProperty("width", std::to_string(finer.width.mean));
  RecordProperty("width_se", std::to_string(finer.width.se));
}

TEST(EntropyForm, ServesSdpdAlone) {
  auto const system = make_system(ideal_gas(10, 0.01));
  system->law = DpdLaw<Transverse::none>{PowerFriction(1, 0, 1, 2), 0.1};
  EXPECT_THROW(fluctuate_entropies(*system, 0.01), InputError);
}

} // namespace
} // namespace mesobridge::sdpd
