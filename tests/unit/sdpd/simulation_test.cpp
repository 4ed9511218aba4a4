#include "sdpd/conservative/conservative.hpp"
#include "sdpd/fluctuation/fluctuation.hpp"
#include "sdpd/fluctuation/pair_scheme.hpp"
#include "sdpd/make_system.hpp"
#include "sdpd/method/settings.hpp"
#include "sdpd/state/random.hpp"
#include "sdpd/system/system.hpp"
#include "sdpd/system/total_energy.hpp"
#include "sdpd_fixtures.hpp"
#include "unit/sdpd/every_fluid.hpp"
#include "unit/sdpd/oracle/plain.hpp"
#include <gtest/gtest.h>
#include <numeric>

namespace mesobridge::sdpd {
namespace {

struct Case {
  char const* name;
  SimulationSettings settings;
};

class EveryFluid : public ::testing::TestWithParam<Case> {};

TEST_P(EveryFluid, GivesTheSameBitsForAnyNumberOfThreads) {
  expect_same_bits_for_any_number_of_threads(GetParam().settings, 40);
}

TEST_P(EveryFluid, GoesOnBitForBitFromACheckpoint) {
  expect_to_go_on_bit_for_bit(GetParam().settings, 34);
}

TEST_P(EveryFluid, ConservesMomentumToRoundOff) {
  expect_conserved_momentum(GetParam().settings, 200);
}

SimulationSettings with_kernel(SimulationSettings s, std::string const& kernel) {
  s.as<Sdpd>().kernel = kernel;
  return s;
}

SimulationSettings corrected(SimulationSettings s, DensityCorrection correction) {
  s.as<Sdpd>().density_correction = correction;
  return s;
}

SimulationSettings with_scheme(SimulationSettings s, Scheme scheme) {
  s.scheme = scheme;
  return s;
}

INSTANTIATE_TEST_SUITE_P(
    Fluids, EveryFluid,
    ::testing::Values(
        Case{"ideal_gas_10", ideal_gas(10, 0.05)},
        Case{"ideal_gas_100", with_kernel(ideal_gas(100, 0.2), "lucy")}, Case{"argon_10", argon(10, 0.03)},
        Case{"argon_1000", argon(1000, 0.1)},
        Case{"argon_100_corrected",
             corrected(with_kernel(argon(100, 0.06), "wendland-c2"), {.scale = 1.03, .self = 0.2})},
        Case{"ideal_gas_2_ems", with_scheme(ideal_gas(2, 0.3), {.pairs = "ems"})},
        Case{"argon_10_ams_three_to_one", with_scheme(argon(10, 0.05), {.pairs = "ams", .verlet_steps = 3})},
        Case{"argon_10_ems_strang_kept",
             with_scheme(argon(10, 0.05),
                         {.pairs = "ems", .splitting = Splitting::strang, .keep_energy = true})},
        Case{"argon_10_ser_implicit", with_scheme(argon(10, 0.1), {.pairs = "ser-implicit"})},
        Case{"argon_100_entropy_form", with_scheme(argon(100, 0.02), {.pairs = "entropy"})},
        Case{"argon_100_hybrid", with_scheme(argon(100, 0.02), {.pairs = "hybrid"})},
        Case{"argon_100_that_conducts",
             with_conduction(with_scheme(argon(100, 0.05), {.pairs = "ems", .splitting = Splitting::strang}),
                             1.5)}),
    [](auto const& info) { return info.param.name; });

System lj_system(double K, std::string const& kernel = "cubic", DensityCorrection correction = {}) {
  auto settings = corrected(with_kernel(argon(K, 0.03), kernel), correction);
  settings.lattice = {7, 7, 7};
  settings.as<Sdpd>().zeta = 0.5e-3;
  settings.seed = 4;
  auto system = std::move(*make_system(settings));
  for (int k = 0; k < 50; ++k)
    step(system, {}, 0.03);
  return system;
}

/// Each kernel with constants of its own.
class EveryKernel : public ::testing::TestWithParam<std::string> {
 protected:
  DensityCorrection correction() const {
    bool const plain = GetParam() == "lucy";
    return plain ? DensityCorrection{} : DensityCorrection{.scale = 0.96, .self = 0.3};
  }
};

// An O(N^2) sum with minimum images: the plain oracle of lists, cells, images and constants.
TEST_P(EveryKernel, GivesTheDensitiesOfABruteForceSum) {
  auto const [scale, self] = correction();
  auto system = lj_system(50, GetParam(), correction());
  auto const& particles = system.particles;
  auto const W = [kernel = make_kernel(GetParam(), 2.5)](double r) {
    return r < 2.5 ? std::visit([r](auto const& of) { return of.W(r); }, kernel) : 0;
  };
  for (std::size_t i = 0; i < particles.size(); ++i) {
    double sum = 0;
    for (std::size_t j = 0; j < particles.size(); ++j)
      sum += W(norm(system.box.minimum_image(particles.q[i] - particles.q[j])));
    ASSERT_NEAR(particles.rho[i], scale * sum - self * W(0), 1e-13);
  }
  EXPECT_EQ(particles.size(), 343u);
}

// The force must be minus the gradient of sum eps(S_i, rho_i(q)) at constant entropies: central differences
// of that energy know nothing of the force's formula.
TEST_P(EveryKernel, GivesForcesThatAreMinusTheGradientOfTheEnergyAtConstantEntropies) {
  auto system = lj_system(50, GetParam(), correction());
  auto const f = system.particles.f;
  auto energy_with = [&](std::size_t i, Vec3 const& moved) {
    Vec3 const before = system.particles.q[i];
    system.particles.q[i] += moved;
    find_pairs_and_densities(system);
    thermodynamics_from_entropy(system);
    system.particles.q[i] = before;
    return std::accumulate(system.particles.eps.begin(), system.particles.eps.end(), 0.0);
  };
  double const h = 1e-5;
  int compared = 0;
  for (std::size_t const i : {0u, 57u, 342u})
    for (int d = 0; d < 3; ++d, ++compared) {
      Vec3 const e{d == 0 ? h : 0, d == 1 ? h : 0, d == 2 ? h : 0};
      double const slope = (energy_with(i, e) - energy_with(i, -e)) / (2 * h);
      double const force = d == 0 ? f[i].x : d == 1 ? f[i].y : f[i].z;
      EXPECT_NEAR(force, -slope, 1e-7);
    }
  EXPECT_EQ(compared, 9);
}

INSTANTIATE_TEST_SUITE_P(Kernels, EveryKernel, ::testing::ValuesIn(kernel_names()), [](auto const& info) {
  std::string name = info.param;
  std::erase(name, '-');
  return name;
});

TEST(FluctuationAndDissipation, ConservesEnergyAndMomentumToRoundOff) {
  auto system = lj_system(10);
  auto totals = [&] { return observe(system); };
  auto const before = totals();
  double moved = 0;
  auto const p = system.particles.p;
  for (int k = 0; k < 20; ++k) {
    thermodynamics_from_entropy(system);
    fluctuate(system, PairScheme::ssa, 0.03);
    thermodynamics_from_energy(system);
    ++system.step;
  }
  for (std::size_t i = 0; i < p.size(); ++i)
    moved += norm(system.particles.p[i] - p[i]);
  EXPECT_GT(moved / static_cast<double>(p.size()), 0.1); // it did something
  EXPECT_NEAR(totals().energy() / before.energy(), 1, 1e-14);
  EXPECT_LT(norm(totals().momentum - before.momentum), 1e-12);
}

// The sweep with caloric expansions against the same sweep with an exact inversion of the equation of state
// for every pair.
TEST(FluctuationAndDissipation, HasTemperaturesAsGoodAsAnInversionPerPair) {
  auto system = lj_system(10);
  thermodynamics_from_entropy(system);
  double worst = 0;
  fluctuate(system, PairScheme::ssa, 0.03);
  auto const& particles = system.particles;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    double const exact = system.thermodynamics->state(particles, static_cast<Index>(i), particles.eps[i]).T;
    worst = std::max(worst, std::abs(particles.T[i] / exact - 1));
  }
  RecordProperty("worst_relative_error_of_T", std::to_string(worst));
  EXPECT_LT(worst, 2e-5);
  EXPECT_GT(worst, 1e-12); // the expansion was used
}

// The sweep in lanes against the same sweep pair after pair, in double precision and with the library's
// functions.
class EveryPairScheme : public ::testing::TestWithParam<PairScheme> {};

TEST_P(EveryPairScheme, InLanesIsThatOfOnePairAfterTheOther) {
  auto fast = lj_system(10), plain = lj_system(10);
  for (auto* system : {&fast, &plain})
    thermodynamics_from_entropy(*system);
  auto const before = fast.particles.p;
  fluctuate(fast, GetParam(), 0.03);
  fluctuate_plain(plain, GetParam(), 0.03);
  double worst_p = 0, worst_eps = 0, moved = 0;
  for (std::size_t i = 0; i < fast.size(); ++i) {
    ASSERT_EQ(fast.particles.id[i], plain.particles.id[i]);
    worst_p = std::max(worst_p, norm(fast.particles.p[i] - plain.particles.p[i]));
    worst_eps = std::max(worst_eps, std::abs(fast.particles.eps[i] - plain.particles.eps[i]));
    moved += norm(fast.particles.p[i] - before[i]) / static_cast<double>(fast.size());
  }
  EXPECT_GT(moved, 0.05);
  EXPECT_LT(worst_p,
            1e-4 * moved); // the noise in single precision is right to 4e-4 near u = 1, 1e-7 elsewhere
  EXPECT_LT(worst_eps, 1e-4 * moved);
  EXPECT_GT(fast.pair_counts.proposed, 10000u);
  EXPECT_EQ(fast.pair_counts.proposed, plain.pair_counts.proposed);
  EXPECT_EQ(fast.pair_counts.out_of_domain, plain.pair_counts.out_of_domain);
  EXPECT_EQ(fast.pair_counts.metropolis, plain.pair_counts.metropolis);
  EXPECT_EQ(fast.pair_counts.metropolis > 0, GetParam() == PairScheme::ems);
}

INSTANTIATE_TEST_SUITE_P(Schemes, EveryPairScheme,
                         ::testing::Values(PairScheme::ssa, PairScheme::ams, PairScheme::ems),
                         [](auto const& info) {
                           return info.index == 0 ? "ssa" : info.index == 1 ? "ams" : "ems";
                         });

// SER from a double sum over all pairs with minimum images, in double precision: the plain oracle.
TEST(FluctuationAndDissipation, OfSerIsThatOfADirectSum) {
  auto system = lj_system(100);
  auto const before = system.particles;
  double const dt = 0.02, energy = total_energy(system);
  NoiseSource const source(system.seed, Stream::fluctuation, system.step);
  SdpdFriction const friction = std::get<SdpdLaw>(system.law).friction;
  CubicKernel const kernel(2.5);
  std::size_t const n = system.size();
  std::vector<Vec3> impulse(n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < i; ++j) {
      Vec3 const r = system.box.minimum_image(before.q[i] - before.q[j]), v = before.p[i] - before.p[j];
      if (norm(r) >= 2.5)
        continue;
      double const chi = kernel.F(norm(r), 1 / norm(r)) / (before.rho[i] * before.rho[j]);
      auto const C = [&](std::size_t k) {
        return 1 / system.thermodynamics->heat_capacity(before, static_cast<Index>(k));
      };
      PairBath<double> const bath(system.boltzmann, before.T[i], before.T[j], C(i), C(j));
      auto const a = before.id[i], b = before.id[j];
      auto const g = gaussians_reference(source, std::min(a, b), std::max(a, b));
      Vec3 const G = (a < b ? 1.0 : -1.0) * Vec3{g[0], g[1], g[2]}, e = r / norm(r);
      double const par = friction.par(chi) * bath.gamma_over_a, perp = friction.perp(chi) * bath.gamma_over_a;
      double const kick_par = std::sqrt(bath.thermal * par * dt),
                   kick_perp = std::sqrt(bath.thermal * perp * dt);
      Vec3 const v_par = dot(e, v) * e, G_par = dot(e, G) * e;
      Vec3 const dp = -dt * (par * v_par + perp * (v - v_par)) + kick_par * G_par + kick_perp * (G - G_par);
      impulse[i] += dp, impulse[j] -= dp;
    }
  fluctuate_ser(system, dt);
  double worst = 0, moved = 0;
  for (std::size_t i = 0; i < n; ++i) {
    worst = std::max(worst, norm(system.particles.p[i] - before.p[i] - impulse[i]));
    moved += norm(impulse[i]) / static_cast<double>(n);
  }
  EXPECT_GT(moved, 0.003);
  EXPECT_LT(worst, 1e-4 * moved);
  EXPECT_NEAR(total_energy(system) / energy, 1, 1e-14);
}

// Pairs are keyed by ids and turned from the smaller to the larger one: exchanging the two partners of every
// pair in the lists is no change.
TEST(FluctuationAndDissipation, DoesNotKnowWhichPartnerComesFirst) {
  auto system = lj_system(10), exchanged = lj_system(10);
  std::size_t pairs = 0;
  for (std::size_t block = 0; block < exchanged.neighbours.grid().blocks().size(); ++block)
    for (std::size_t k = 0; k < exchanged.neighbours.pairs(block).size(); ++k, ++pairs) {
      auto& pair = exchanged.neighbours.pair_room(block)[k];
      std::swap(pair.i, pair.j);
    }
  EXPECT_GT(pairs, 10000u);
  for (auto* each : {&system, &exchanged}) {
    thermodynamics_from_entropy(*each);
    fluctuate(*each, PairScheme::ssa, 0.03);
  }
  for (std::size_t i = 0; i < system.size(); ++i) {
    ASSERT_LT(norm(system.particles.p[i] - exchanged.particles.p[i]), 1e-13);
    ASSERT_NEAR(system.particles.eps[i], exchanged.particles.eps[i], 1e-13);
  }
}

// Verlet alone is reversible: forward, momenta turned, forward again leads back.
TEST(ConservativeDynamics, IsReversible) {
  auto system = lj_system(100);
  auto verlet = [&](double dt) {
    kick_and_drift(system, dt / 2, dt);
    refresh_lists(system), find_pairs_and_densities(system), thermodynamics_from_entropy(system),
        find_forces(system);
    kick(system, dt / 2);
  };
  auto by_id = [&] {
    std::vector<Vec3> q(system.size());
    for (std::size_t i = 0; i < q.size(); ++i)
      q[system.particles.id[i]] = system.box.wrap(system.particles.q[i]);
    return q;
  };
  auto const start = by_id();
  for (int k = 0; k < 30; ++k)
    verlet(0.05);
  auto const away = by_id();
  for (auto& p : system.particles.p)
    p *= -1;
  for (int k = 0; k < 30; ++k)
    verlet(0.05);
  auto const back = by_id();
  double error = 0, way = 0;
  for (std::size_t i = 0; i < start.size(); ++i) {
    error = std::max(error, norm(system.box.minimum_image(back[i] - start[i])));
    way = std::max(way, norm(system.box.minimum_image(away[i] - start[i])));
  }
  EXPECT_GT(way, 0.05);
  EXPECT_LT(error, 1e-10);
}

TEST(Simulation, RefusesBadInputByName) {
  auto message = [](auto change) {
    auto settings = ideal_gas(10, 0.05);
    change(settings);
    try {
      Simulation const simulation(settings);
    } catch (InputError const& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  using S = SimulationSettings;
  EXPECT_NE(message([](S& s) { s.as<Sdpd>().K = 0.5; }).find("particle size K = 0.5"), std::string::npos);
  EXPECT_NE(message([](S& s) { s.as<Sdpd>().K = 1; }).find("heat capacity 0 k_B"), std::string::npos);
  EXPECT_NE(message([](S& s) { s.as<Sdpd>().K = 1.3; }).find("is too small"), std::string::npos);
  EXPECT_NE(message([](S& s) {
              s.as<Sdpd>().K = 1, s.as<Sdpd>().eos = fitting::material("argon").eos;
            }).find("heat capacity 0.232 k_B at rho and T without its centre of mass"),
            std::string::npos);
  EXPECT_EQ(message([](S& s) { s.as<Sdpd>().K = 1, s.as<Sdpd>().centre_of_mass = CentreOfMass::bulk; }),
            "accepted");
  EXPECT_NE(message([](S& s) { s.rho = -1; }).find("density rho = -1"), std::string::npos);
  EXPECT_NE(message([](S& s) { s.T = std::nan(""); }).find("temperature T = nan"), std::string::npos);
  EXPECT_NE(message([](S& s) { s.dt = 0; }).find("time step dt = 0"), std::string::npos);
  EXPECT_NE(message([](S& s) { s.as<Sdpd>().zeta = 1; }).find("bulk viscosity zeta"), std::string::npos);
  EXPECT_NE(message([](S& s) { s.lattice = {4, 10, 10}; }).find("box edge = 4"), std::string::npos);
}

TEST(Simulation, NamesParticleStepAndTimeStepWhenItCannotGoOn) {
  Simulation simulation(ideal_gas(2, 0.3)); // SSA cannot run K = 2 (thesis, section 4.3)
  try {
    simulation.advance(2000);
    FAIL() << "SSA ran at K = 2";
  } catch (PhysicsError const& error) {
    std::string const text = error.what();
    EXPECT_NE(text.find("particle "), std::string::npos);
    EXPECT_NE(text.find("at step "), std::string::npos);
    EXPECT_NE(text.find("dt = 0.3"), std::string::npos);
  }
}

} // namespace
} // namespace mesobridge::sdpd
