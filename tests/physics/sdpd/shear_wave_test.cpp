#include "sdpd/conservative/conservative.hpp"
#include "sdpd/make_system.hpp"
#include "sdpd/method/settings.hpp"
#include "sdpd/scheme/list.hpp"
#include "sdpd/scheme/scheme.hpp"
#include "sdpd/system/total_energy.hpp"
#include "sdpd_fixtures.hpp"
#include <algorithm>
#include <gtest/gtest.h>
#include <numbers>

namespace mesobridge::sdpd {
namespace {

/// A fluid with the velocity (0, U sin kz, 0), k = 2 pi/L.
class ShearWave {
 public:
  ShearWave(SimulationSettings settings, double U, std::uint64_t equilibrate_for = 0)
      : scheme_(settings.scheme) {
    settings.lattice = {6, 6, 24};
    eta_ = settings.as<Sdpd>().eta / settings.units().viscosity();
    dt_ = settings.dt;
    system_ = make_system(settings);
    advance(equilibrate_for);
    for (std::size_t i = 0; i < system_->size(); ++i)
      system_->particles.p[i].y += U * wave(i);
  }
  void advance(std::uint64_t steps) {
    for (std::uint64_t k = 0; k < steps; ++k)
      step(*system_, scheme_, dt_);
  }
  System const& system() const { return *system_; }
  double amplitude() const {
    double sum = 0, norm = 0;
    for (std::size_t i = 0; i < system_->size(); ++i)
      sum += system_->particles.p[i].y * wave(i), norm += wave(i) * wave(i);
    return sum / norm;
  }
  /// The decay rate of the Navier-Stokes equations, eta k^2/rho.
  double rate() const { return eta_ * k() * k(); }
  /// That of the particles on their lattice: the friction of each pair, summed directly.
  double rate_by_direct_sum() const {
    auto const& particles = system_->particles;
    CubicKernel const kernel(2.5);
    double sum = 0;
    for (std::size_t j = 1; j < particles.size(); ++j) {
      Vec3 const r = system_->box.minimum_image(particles.q[j] - particles.q[0]);
      double const d = norm(r);
      if (d < 2.5)
        sum += kernel.F(d, 1 / d) * 5 * eta_ / 3 * (1 + r.y * r.y / (d * d)) * (1 - std::cos(k() * r.z));
    }
    return sum / (particles.rho[0] * particles.rho[0]);
  }

 private:
  double k() const { return 2 * std::numbers::pi / system_->box.edge.z; }
  double wave(std::size_t i) const { return std::sin(k() * system_->particles.q[i].z); }

  double eta_, dt_;
  Scheme scheme_;
  std::unique_ptr<System> system_;
};

SimulationSettings without_noise(SimulationSettings settings, std::string const& pairs) {
  settings.noise = false;
  settings.scheme.pairs = pairs;
  return settings;
}

class SmoothedParticleHydrodynamics : public ::testing::TestWithParam<std::string> {};

// On a lattice the wave is an eigenvector of the friction, so that its decay is known exactly; it is 3.6 %
// slower than that of the Navier-Stokes equations: the SPH error of this kernel on this lattice at this wave
// number. Only the beginning is looked at: later on the stiffness of the lattice speeds the decay up.
TEST_P(SmoothedParticleHydrodynamics, DampsAShearWaveWithTheSetViscosityAndHeatsTheFluid) {
  double const U = 0.01;
  ShearWave wave(without_noise(argon(100, 0.02), GetParam()), U);
  double const energy = total_energy(wave.system()), kinetic = 0.5 * 864 * U * U / 2;
  wave.advance(30);
  double const time = 30 * 0.02, measured = -std::log(wave.amplitude() / U) / time;
  EXPECT_GT(measured * time, 0.06); // it has decayed
  EXPECT_NEAR(measured / wave.rate_by_direct_sum(), 1, 0.01);
  EXPECT_NEAR(measured / wave.rate(), 0.964, 0.006);
  // What the wave has lost is heat, to the accuracy of the Verlet steps.
  EXPECT_LT(std::abs(total_energy(wave.system()) - energy), 1e-3 * kinetic);
  Vec3 momentum{};
  for (auto const& p : wave.system().particles.p)
    momentum += p;
  EXPECT_LT(norm(momentum), 1e-12);
}

std::vector<std::string> without_need_of_noise() {
  std::vector<std::string> names;
  for (auto const& integrator : pair_integrators())
    if (!refusal(integrator, {}, false))
      names.push_back(integrator.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(Schemes, SmoothedParticleHydrodynamics, ::testing::ValuesIn(without_need_of_noise()),
                         [](auto const& info) {
                           std::string name = info.param;
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

TEST(SmoothedParticleHydrodynamicsWithoutNoise, IsMadeByMostSchemes) {
  EXPECT_GE(without_need_of_noise().size(), 6u);
}

TEST(SmoothedParticleHydrodynamicsWithoutFlow, StaysAtRestOnALattice) {
  Simulation simulation(without_noise(argon(100, 0.05), "ssa"));
  simulation.advance(20);
  EXPECT_LT(simulation.observe().kinetic, 1e-20);
  EXPECT_NEAR(simulation.observe().T_int, 1, 1e-12);
}

TEST(SmoothedParticleHydrodynamicsWithoutFlow, HasNoMetropolisTest) {
  EXPECT_THROW(Simulation(without_noise(argon(100, 0.05), "ems")), InputError);
}

// With noise the amplitude fluctuates with the variance 2 k_B T/(m N) once it has decayed.
TEST(ShearWaveWithNoise, DecaysAtTheRateOfTheSetViscosity) {
  double const U = 0.6, K = 400, dt = 0.1;
  std::uint64_t const steps = 40;
  double sum = 0, square = 0;
  int const repeats = 6;
  double rate = 0;
  for (int seed = 1; seed <= repeats; ++seed) {
    auto settings = ideal_gas(K, dt);
    settings.seed = static_cast<std::uint64_t>(seed), settings.disorder = 0.15;
    ShearWave wave(settings, U, 60);
    double const before = wave.amplitude();
    wave.advance(steps);
    double const measured = std::log(before / wave.amplitude()) / (static_cast<double>(steps) * dt);
    rate = wave.rate();
    sum += measured / rate, square += measured * measured / (rate * rate);
  }
  double const mean = sum / repeats, se = std::sqrt((square / repeats - mean * mean) / (repeats - 1));
  RecordProperty("rate_over_navier_stokes", std::to_string(mean));
  RecordProperty("se", std::to_string(se));
  EXPECT_LT(se, 0.02);
  EXPECT_NEAR(mean, 1, 0.1 + 3 * se);
}

} // namespace
} // namespace mesobridge::sdpd
