#include "pair_fluid_fixtures.hpp"
#include "sdpd/method/settings.hpp"
#include "sdpd/setup/equilibration.hpp"
#include "sdpd_fixtures.hpp"
#include <gtest/gtest.h>

// An equilibration that is stopped at any of its steps, also where heat is added or velocities are drawn, and
// goes on with another simulation, ends in the same bits.

namespace mesobridge::sdpd {
namespace {

constexpr std::uint64_t steps = 96; // runs of 3, 3, 6, 12, 24, 48

void expect_same(Checkpoint const& a, Checkpoint const& b) {
  EXPECT_EQ(a.step, b.step);
  auto const &of_a = a.particles, &of_b = b.particles;
  EXPECT_EQ(of_a.id, of_b.id);
  for (auto const& [x, y] : {std::pair(&of_a.q, &of_b.q), std::pair(&of_a.p, &of_b.p)})
    for (std::size_t i = 0; i < x->size(); ++i)
      ASSERT_TRUE((*x)[i].x == (*y)[i].x && (*x)[i].y == (*y)[i].y && (*x)[i].z == (*y)[i].z) << i;
  for (auto const& field : fields)
    EXPECT_EQ(of_a.*field.values, of_b.*field.values) << field.name;
  EXPECT_EQ(a.kept_energy, b.kept_energy);
}

Checkpoint equilibrated(SimulationSettings const& settings) {
  Simulation simulation(settings);
  equilibrate(simulation, steps, [] { return true; });
  return simulation.checkpoint();
}

Checkpoint stopped_at(std::uint64_t step, SimulationSettings const& settings) {
  Simulation first(settings);
  Equilibration begun(first, steps);
  while (begun.progress().done < step)
    begun.advance();
  Simulation second(settings);
  second.restore(first.checkpoint());
  Equilibration resumed(second, steps, begun.progress());
  while (!resumed.is_done())
    resumed.advance();
  return second.checkpoint();
}

TEST(Equilibration, GoesOnBitForBit) {
  auto small = [](SimulationSettings s) {
    s.lattice = {7, 7, 7};
    return s;
  };
  auto without_noise = small(argon(100, 0.05));
  without_noise.noise = false;
  auto in_bath = small(argon(100, 0.05));
  in_bath.bath_rate = 1;
  auto keeping = small(argon(20, 0.1));
  keeping.scheme.keep_energy = true;
  int compared = 0;
  for (auto const& settings : {small(argon(100, 0.05)), without_noise, in_bath, keeping,
                               small(dpde_fluid(100)), small(dpd_fluid())}) {
    auto const unbroken = equilibrated(settings);
    for (std::uint64_t const step : {1u, 3u, 12u, 13u, 48u, 71u}) {
      expect_same(unbroken, stopped_at(step, settings));
      ++compared;
    }
  }
  EXPECT_EQ(compared, 6 * 6);
}

} // namespace
} // namespace mesobridge::sdpd
