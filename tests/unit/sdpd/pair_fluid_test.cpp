#include "pair_fluid_fixtures.hpp"
#include "sdpd/conservative/conservative.hpp"
#include "sdpd/conservative/pair_forces.hpp"
#include "sdpd/fluctuation/fluctuation.hpp"
#include "sdpd/fluctuation/pair_scheme.hpp"
#include "sdpd/make_system.hpp"
#include "sdpd/method/settings.hpp"
#include "sdpd/scheme/list.hpp"
#include "sdpd/state/random.hpp"
#include "sdpd/system/total_energy.hpp"
#include "unit/sdpd/every_fluid.hpp"
#include "unit/sdpd/oracle/plain.hpp"
#include <gtest/gtest.h>

namespace mesobridge::sdpd {
namespace {

SimulationSettings with_scheme(SimulationSettings s, Scheme scheme) {
  s.scheme = scheme;
  return s;
}

SimulationSettings with_table(SimulationSettings s) {
  TabulatedFriction const table({0.1, 0.3, 0.6, 0.9, 1.0}, {6, 5, 2, 0.5, 0}, {3, 3, 1, 0, 0});
  (s.features().energies ? s.as<Dpde>().friction : s.as<Dpd>().friction) = table;
  return s;
}

SimulationSettings with_heat_capacity_table(SimulationSettings s) {
  s.as<Dpde>().internal_energy =
      fitting::TabulatedHeatCapacity({0.1, 0.5, 1, 2, 10}, {8, 10, 14, 16, 17}, 0.5);
  return s;
}

struct Case {
  char const* name;
  SimulationSettings settings;
};

std::vector<Case> const cases{
    {"dpd_ssa", dpd_fluid()},
    {"dpd_ser", with_scheme(dpd_fluid(), {.pairs = "ser"})},
    {"dpd_strang_two_to_one",
     with_scheme(with_table(dpd_fluid()), {.verlet_steps = 2, .splitting = Splitting::strang})},
    {"dpde_ssa", dpde_fluid(60)},
    {"dpde_ams_across", with_scheme(dpde_fluid(5, 0.02, 2), {.pairs = "ams"})},
    {"dpde_ems_table", with_scheme(with_table(dpde_fluid(10)), {.pairs = "ems"})},
    {"dpde_ems_heat_capacity_table", with_scheme(with_heat_capacity_table(dpde_fluid(10)), {.pairs = "ems"})},
    {"dpde_ems_that_conducts",
     with_pair_conduction(with_scheme(dpde_fluid(10), {.pairs = "ems", .splitting = Splitting::strang}),
                          PowerFriction(20, 0, 1.3, 2))},
    {"dpde_ssa_that_conducts_by_a_table",
     with_pair_conduction(with_heat_capacity_table(dpde_fluid(60)),
                          TabulatedFriction({0.1, 0.5, 0.8}, {30, 10, 0}, {}))},
    {"dpde_ser", with_scheme(dpde_fluid(30, 0.005), {.pairs = "ser"})},
    {"dpde_strang_kept_three_to_one",
     with_scheme(dpde_fluid(20, 0.01),
                 {.verlet_steps = 3, .splitting = Splitting::strang, .keep_energy = true})}};

class EveryPairFluid : public ::testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(Fluids, EveryPairFluid, ::testing::ValuesIn(cases),
                         [](auto const& info) { return info.param.name; });

TEST_P(EveryPairFluid, GivesTheSameBitsForAnyNumberOfThreads) {
  expect_same_bits_for_any_number_of_threads(GetParam().settings, 30);
}

TEST_P(EveryPairFluid, GoesOnBitForBitFromACheckpoint) {
  expect_to_go_on_bit_for_bit(GetParam().settings, 32);
}

TEST_P(EveryPairFluid, ConservesMomentumToRoundOff) {
  expect_conserved_momentum(GetParam().settings, 100);
}

TEST_P(EveryPairFluid, HasNoArraysThatItDoesNotNeed) {
  auto const system = make_system(GetParam().settings);
  auto const& p = system->particles;
  EXPECT_TRUE(p.rho.empty() && p.S.empty() && p.P.empty());
  bool const energies = GetParam().settings.features().energies;
  EXPECT_EQ(p.eps.size(), energies ? system->size() : 0);
  EXPECT_EQ(p.T.size(), p.eps.size());
  EXPECT_EQ(p.caloric.size(), p.eps.size());
}

/// Fluctuation and dissipation alone, in a fluid that has left its lattice; by EMS where there are energies,
/// which SSA would take below zero now and then in particles as small as these.
System settled(SimulationSettings const& settings) {
  auto system = std::move(*make_system(settings));
  auto scheme = settings.scheme;
  if (system.has_energies())
    scheme.pairs = "ems";
  for (int k = 0; k < 20; ++k)
    step(system, scheme, settings.dt);
  system.pair_counts = {};
  return system;
}

std::string name_of(::testing::TestParamInfo<PairScheme> const& info) {
  return std::array<char const*, 3>{"ssa", "ams", "ems"}[info.index];
}

class EveryEnergyScheme : public ::testing::TestWithParam<PairScheme> {};
INSTANTIATE_TEST_SUITE_P(Schemes, EveryEnergyScheme,
                         ::testing::Values(PairScheme::ssa, PairScheme::ams, PairScheme::ems), name_of);

TEST_P(EveryEnergyScheme, ConservesTheEnergyOfFluctuationAndDissipationToRoundOff) {
  for (double const across : {0.0, 2.0}) {
    auto system = settled(dpde_fluid(40, 0.01, across));
    double const before = total_energy(system);
    auto const p = system.particles.p;
    fluctuate(system, GetParam(), 0.01);
    EXPECT_NEAR(total_energy(system) / before, 1, 1e-14);
    double moved = 0;
    for (std::size_t i = 0; i < p.size(); ++i)
      moved += norm(system.particles.p[i] - p[i]) / static_cast<double>(p.size());
    EXPECT_GT(moved, 0.05);
  }
}

TEST_P(EveryEnergyScheme, InLanesIsThatOfOnePairAfterTheOther) {
  int looked_at = 0;
  std::uint64_t rejected = 0;
  for (auto const& settings : {dpde_fluid(5, 0.02), dpde_fluid(5, 0.02, 3), with_table(dpde_fluid(4, 0.02)),
                               with_heat_capacity_table(dpde_fluid(10, 0.02))}) {
    auto fast = settled(settings), plain = settled(settings);
    auto const before = fast.particles.p;
    fluctuate(fast, GetParam(), 0.04);
    fluctuate_plain(plain, GetParam(), 0.04);
    double worst = 0, moved = 0;
    for (std::size_t i = 0; i < fast.size(); ++i) {
      ASSERT_EQ(fast.particles.id[i], plain.particles.id[i]);
      worst = std::max(worst, norm(fast.particles.p[i] - plain.particles.p[i]));
      worst = std::max(worst, std::abs(fast.particles.eps[i] - plain.particles.eps[i]));
      moved += norm(fast.particles.p[i] - before[i]) / static_cast<double>(fast.size());
    }
    EXPECT_GT(moved, 0.2);
    EXPECT_LT(worst, 1e-3 * moved);
    EXPECT_EQ(fast.pair_counts.proposed, plain.pair_counts.proposed);
    EXPECT_EQ(fast.pair_counts.metropolis, plain.pair_counts.metropolis);
    rejected += fast.pair_counts.metropolis;
    ++looked_at;
  }
  EXPECT_EQ(looked_at, 4);
  EXPECT_EQ(rejected > 0, GetParam() == PairScheme::ems);
}

TEST(DpdFluctuation, InLanesIsThatOfOnePairAfterTheOther) {
  for (auto const& settings : {dpd_fluid(), with_table(dpd_fluid())}) {
    auto fast = settled(settings), plain = settled(settings);
    auto const before = fast.particles.p;
    fluctuate(fast, PairScheme::ssa, 0.04);
    fluctuate_plain(plain, PairScheme::ssa, 0.04);
    double worst = 0, moved = 0;
    for (std::size_t i = 0; i < fast.size(); ++i) {
      worst = std::max(worst, norm(fast.particles.p[i] - plain.particles.p[i]));
      moved += norm(fast.particles.p[i] - before[i]) / static_cast<double>(fast.size());
    }
    EXPECT_GT(moved, 0.2);
    EXPECT_LT(worst, 1e-3 * moved);
  }
}

// Pairs are keyed by ids: exchanging the two partners of every pair in the lists is no change.
TEST(PairFluid, DoesNotKnowWhichPartnerComesFirst) {
  std::size_t looked_at = 0;
  for (auto const& integrator : pair_integrators())
    for (auto const& settings : {dpde_fluid(5, 0.02, 3), dpd_fluid()}) {
      if (refusal(integrator, settings.features()))
        continue;
      auto system = settled(settings), exchanged = settled(settings);
      std::size_t pairs = 0;
      for (std::size_t block = 0; block < exchanged.neighbours.grid().blocks().size(); ++block) {
        auto const room =
            exchanged.neighbours.pair_room(block).first(exchanged.neighbours.pairs(block).size());
        for (auto& pair : room)
          std::swap(pair.i, pair.j), ++pairs;
      }
      EXPECT_GT(pairs, 3000u);
      integrator.sweep(system, 0.02, false);
      integrator.sweep(exchanged, 0.02, false);
      double worst = 0;
      for (std::size_t i = 0; i < system.size(); ++i)
        worst = std::max(worst, norm(system.particles.p[i] - exchanged.particles.p[i]));
      EXPECT_LT(worst, 1e-6) << integrator.name;
      ++looked_at;
    }
  EXPECT_GE(looked_at, pair_integrators().size());
}

// A box turned by 90 degrees about z: forces turn with it. So does friction (of SER, where the order of the
// pairs does not matter; without noise, which is tied to the axes).
TEST(PairFluid, TurnsWithItsBox) {
  auto turned = [](Vec3 const& v) { return Vec3{-v.y, v.x, v.z}; };
  auto settings = dpde_fluid(20, 0.01, 2);
  settings.lattice = {8, 9, 10};
  auto system = settled(settings);
  settings.lattice = {9, 8, 10};
  auto other = std::move(*make_system(settings));
  std::vector<std::size_t> place(system.size());
  for (std::size_t i = 0; i < place.size(); ++i)
    place[system.particles.id[i]] = i;
  auto set_turned = [&] {
    for (std::size_t k = 0; k < place.size(); ++k) {
      std::size_t const from = place[other.particles.id[k]];
      other.particles.q[k] = other.box.wrap(turned(system.particles.q[from]));
      other.particles.p[k] = turned(system.particles.p[from]);
      other.particles.eps[k] = system.particles.eps[from], other.particles.T[k] = system.particles.T[from];
    }
  };
  set_turned();
  other.neighbours.renew(other.particles);
  set_turned();
  thermodynamics_from_energy(other);
  for (auto* each : {&system, &other}) {
    find_pair_forces(*each);
    std::get<DpdeLaw<Transverse::own>>(each->law).boltzmann = 0;
    fluctuate_ser(*each, 0.01);
  }
  EXPECT_NEAR(other.virial, system.virial, 1e-10 * system.virial);
  double worst_f = 0, worst_p = 0;
  for (std::size_t k = 0; k < place.size(); ++k) {
    std::size_t const from = place[other.particles.id[k]];
    worst_f = std::max(worst_f, norm(other.particles.f[k] - turned(system.particles.f[from])));
    worst_p = std::max(worst_p, norm(other.particles.p[k] - turned(system.particles.p[from])));
  }
  EXPECT_LT(worst_f, 1e-10);
  EXPECT_LT(worst_p, 1e-6);
}

TEST(PairFluid, RefusesWhatMakesNoSense) {
  auto refused = [](auto const& change) {
    auto s = dpd_fluid();
    change(s);
    EXPECT_THROW(check(s), InputError);
  };
  EXPECT_NO_THROW(check(dpd_fluid()));
  refused([](SimulationSettings& s) { s.as<Dpd>().mass = -1; });
  refused([](SimulationSettings& s) { s.as<Dpd>().mass = std::nan(""); });
  refused([](auto& s) { s.scheme.pairs = "ems"; });
  refused([](auto& s) { s.scheme.keep_energy = true; });
  refused([](auto& s) { s.scheme.pairs = "ser-implicit"; });
  refused([](auto& s) { s = dpde_fluid(60), s.scheme.pairs = "entropy"; });
  refused([](auto& s) { s.lattice = {3, 3, 3}; }); // narrower than twice the range
  refused([](auto& s) { s.rho = 0; });
}

// SSA has no way to refuse a step that takes an energy below zero: it says so.
TEST(PairFluid, StopsWhenAnInternalEnergyTurnsNegative) {
  auto settings = dpde_fluid(0.2, 0.05);
  Simulation simulation(settings);
  EXPECT_THROW(simulation.advance(200), PhysicsError);
}

} // namespace
} // namespace mesobridge::sdpd
