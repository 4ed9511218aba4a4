#include "md/error.hpp"
#include "sdpd/conservative/refresh.hpp"
#include "sdpd/make_system.hpp"
#include "sdpd/simulation.hpp"
#include "sdpd/start/layout.hpp"
#include "sdpd/system/system.hpp"
#include "sdpd/system/total_energy.hpp"
#include "sdpd_fixtures.hpp"
#include <gtest/gtest.h>
#include <numbers>
#include <random>

namespace mesobridge::sdpd {
namespace {

constexpr Vec3 edge{8, 8, 24};

Region everywhere() {
  return {.name = "fluid", .shape = Cuboid{{}, edge}};
}
Region upper_half() {
  return {.name = "upper", .shape = Cuboid{{0, 0, 12}, edge}};
}

/// One region of the given lattice and shape in an empty box.
Layout alone(Region region) {
  auto empty = everywhere();
  empty.vacuum = true;
  return {edge, {empty, std::move(region)}, 7};
}

// Each place lies inside its region, and no two regions share one.
TEST(Layout, GivesEachPlaceToTheLastRegionThatHoldsIt) {
  auto upper = upper_half();
  upper.spacing = 0.5;
  Region const hole{.name = "hole", .shape = Sphere{{4, 4, 12}, 3}, .vacuum = true};
  Layout const layout(edge, {everywhere(), upper, hole}, 1);
  std::vector<std::size_t> found(3);
  layout.for_each_place([&](Vec3 const& q, std::size_t region) {
    ++found[region];
    EXPECT_GE(norm(q - Vec3{4, 4, 12}), 3);
    EXPECT_EQ(region == 1, q.z >= 12);
  });
  EXPECT_EQ(found, layout.particles());
  EXPECT_EQ(found[2], 0u);
  EXPECT_EQ(found[0] + found[1], layout.size());
  // Half of the sphere's volume is missing from either side, to half a lattice plane of its largest circle.
  double const half_ball = 2 * std::numbers::pi / 3 * 27;
  EXPECT_NEAR(static_cast<double>(found[0]), 8 * 8 * 12 - half_ball, 14);
  EXPECT_NEAR(static_cast<double>(found[1]), 8 * (8 * 8 * 12 - half_ball), 56);
}

// Particles are counted without a walk through them; the walk counts as many.
TEST(Layout, CountsAsManyAsItPlaces) {
  std::mt19937 generator(5);
  auto const random = [&](double from, double to) {
    return std::uniform_real_distribution(from, to)(generator);
  };
  for (int trial = 0; trial < 200; ++trial) {
    std::vector regions{everywhere()};
    for (int k = 0; k < 3; ++k) {
      Region region{.name = "cuboid", .outside = random(0, 1) < 0.3, .vacuum = random(0, 1) < 0.2};
      Vec3 const from{random(-2, 6), random(-2, 6), random(-2, 20)};
      region.shape = Cuboid{from, from + Vec3{random(2, 9), random(2, 9), random(4, 20)}};
      region.lattice = random(0, 1) < 0.5 ? Lattice::fcc : Lattice::cubic, region.spacing = random(0.7, 1.3);
      regions.push_back(region);
    }
    regions.front().spacing = random(0.9, 1.1);
    try {
      Layout const layout(edge, regions, 1);
      std::vector<std::size_t> found(regions.size());
      layout.for_each_place([&](Vec3 const&, std::size_t region) { ++found[region]; });
      EXPECT_EQ(found, layout.particles()) << trial;
    } catch (InputError const&) { // nothing is left
    }
  }
  auto dense = everywhere(); // 3.07e9 particles, at once
  dense.spacing = 0.00794;
  EXPECT_GT(alone(dense).size(), 3'000'000'000u);
}

TEST(Layout, HasAsManyParticlesAsTheDensityAsksFor) {
  for (auto const lattice : {Lattice::cubic, Lattice::fcc, Lattice::random})
    for (double const spacing : {1.0, 0.77, 0.5}) {
      auto region = upper_half();
      region.lattice = lattice, region.spacing = spacing;
      double const wanted = 8 * 8 * 12 / std::pow(spacing, 3);
      auto const layout = alone(region);
      double const found = static_cast<double>(layout.size());
      EXPECT_NEAR(found / wanted, 1, lattice == Lattice::random ? 1e-3 : 0.05); // by whole cells
      EXPECT_NEAR(layout.excess(1), found / wanted - 1, 1e-12) << spacing;
    }
}

// In the fcc lattice each place has twelve neighbours, 2^(1/6) spacings away.
TEST(Layout, OfFccHasTwelveNearestNeighbours) {
  auto region = everywhere();
  region.lattice = Lattice::fcc, region.spacing = 0.5 * std::cbrt(2); // 8 cells of edge 1
  std::vector<Vec3> places;
  auto const layout = alone(region);
  layout.for_each_place([&](Vec3 const& q, std::size_t) { places.push_back(q); });
  Box const box{edge};
  int near = 0;
  for (auto const& q : places)
    if (double const r = norm(box.minimum_image(q - places.front())); r > 0 && r < 0.8) {
      ++near;
      EXPECT_NEAR(r, region.spacing * std::pow(2, 1.0 / 6), 1e-12);
    }
  EXPECT_EQ(near, 12);
}

TEST(Layout, OfRoundShapesHasTheirVolumes) {
  auto ball = everywhere(), rod = everywhere(), rest = everywhere();
  ball.shape = Sphere{{4, 4, 10}, 3.5}, rod.shape = Cylinder{0, {4, 4, 10}, 3.5, 1, 7};
  rest.shape = rod.shape, rest.outside = true;
  ball.spacing = rod.spacing = rest.spacing = 0.25;
  double const per_volume = 64, area = std::numbers::pi * 3.5 * 3.5;
  EXPECT_NEAR(static_cast<double>(alone(ball).size()) / (per_volume * 4 / 3 * area * 3.5), 1, 0.01);
  EXPECT_NEAR(static_cast<double>(alone(rod).size()) / (per_volume * area * 6), 1, 0.01);
  EXPECT_EQ(alone(rest).size() + alone(rod).size(), std::size_t{8 * 8 * 24 * 64});
}

TEST(Layout, RefusesWhatHoldsNoParticlesOrTooMany) {
  auto outside = upper_half(), dense = everywhere(), empty = everywhere();
  outside.shape = Sphere{{4, 4, 40}, 2};
  dense.spacing = 1e-4;
  empty.vacuum = true;
  EXPECT_THROW(alone(outside), InputError);
  EXPECT_THROW(Layout(edge, {dense}, 1), InputError);
  EXPECT_THROW(Layout(edge, {empty}, 1), InputError);
}

/// Two ideal gases side by side, equally far apart: the upper eight times lighter, colder, and in motion.
SimulationSettings side_by_side(DensitySum sum, bool noise) {
  auto settings = ideal_gas(80, 0.02);
  settings.noise = noise, settings.disorder = 0;
  settings.faces = walls_along(2);
  auto upper = upper_half();
  upper.species = 1, upper.T = 0.8, upper.velocity = {0.3, 0, -0.2}, upper.along_z = {0, 0.05, 0};
  settings.layout = std::make_shared<Layout const>(edge, std::vector{everywhere(), upper}, 1);
  auto& fluid = settings.as<Sdpd>();
  fluid.kernel = "wendland-c4", fluid.density_sum = sum;
  fluid.species = {{"heavy", 0, 80, fluid.eos}, {"light", 0, 10, fluid.eos}};
  return settings;
}

TEST(Regions, BeginWithTheirTemperaturesAndVelocities) {
  auto const system = make_system(side_by_side(DensitySum::number, true));
  auto const& particles = system->particles;
  std::array<Vec3, 2> momentum;
  std::array<double, 2> mass{}, square{}, count{};
  for (std::size_t i = 0; i < system->size(); ++i) {
    auto const s = particles.species[i];
    EXPECT_EQ(s == 1, particles.q[i].z >= 12);
    EXPECT_EQ(particles.T[i], s == 1 ? 0.8 : 1.0);
    Vec3 const flow = s == 1 ? Vec3{0.3, 0.05 * (particles.q[i].z - 12), -0.2} : Vec3{};
    momentum[s] += particles.p[i] - particles.mass[i] * flow;
    square[s] += norm2(particles.p[i] / particles.mass[i] - flow) * particles.mass[i];
    mass[s] += particles.mass[i], ++count[s];
  }
  for (std::size_t s : {0u, 1u}) {
    EXPECT_LT(norm(momentum[s]), 1e-10);
    EXPECT_NEAR(square[s] / (3 * (count[s] - 1) / 80), s == 1 ? 0.8 : 1.0, 1e-12);
  }
  EXPECT_NEAR(mass[0] / mass[1], 8, 1e-12);
}

// On one lattice throughout, each particle counts as many neighbours as any other, whatever they weigh.
TEST(Regions, MeetWithASharpDensityWhereTheNumberOfNeighboursCounts) {
  auto const by_number = make_system(side_by_side(DensitySum::number, false));
  auto const by_mass = make_system(side_by_side(DensitySum::mass, false));
  double jump = 0;
  for (std::size_t i = 0; i < by_number->size(); ++i) {
    auto const& number = by_number->particles;
    EXPECT_NEAR(number.rho[i] / number.mass[i], number.rho[0] / number.mass[0], 1e-12);
    auto const& mass = by_mass->particles;
    jump = std::max(jump, std::abs(mass.rho[i] / (mass.mass[i] * number.rho[0] / number.mass[0]) - 1));
  }
  EXPECT_GT(jump, 1); // by mass a light particle at the interface is far too dense
}

// f = -dE/dq at constant entropies, for both kinds of sums, at the interface and at a wall.
TEST(Regions, HaveForcesThatAreTheSlopeOfTheEnergy) {
  for (auto const sum : {DensitySum::mass, DensitySum::number}) {
    auto settings = side_by_side(sum, false);
    settings.disorder = 0.2;
    auto const system = make_system(settings);
    auto const forces = system->particles.f;
    auto energy = [&](std::size_t i, Vec3 const& by) {
      auto const before = system->particles.q[i];
      system->particles.q[i] += by;
      refresh_by(*system, [](System& s) {
        Failure failure;
        s.thermodynamics->from_entropy(s.particles, {0, s.size()}, failure);
      });
      system->particles.q[i] = before;
      return total_energy(*system);
    };
    int tried = 0;
    constexpr double step = 1e-5;
    for (std::size_t i = 0; i < system->size() && tried < 12; ++i)
      if (double const z = system->particles.q[i].z; std::abs(z - 12) < 1 || z > 23.2) {
        ++tried;
        for (int const axis : {0, 1, 2}) {
          Vec3 by;
          component(by, axis) = step;
          double const slope = (energy(i, by) - energy(i, -by)) / (2 * step);
          EXPECT_NEAR(component(forces[i], axis), -slope, 2e-5 * (1 + std::abs(slope)));
        }
      }
    EXPECT_EQ(tried, 12);
  }
}

// A tube of two gases: momentum, energy and bits.
TEST(Regions, ConserveAndDoNotDependOnThreads) {
  auto settings = side_by_side(DensitySum::number, true);
  settings.faces = {}, settings.dt = 0.01;
  Simulation one(settings);
  settings.threads = 2;
  Simulation two(settings);
  double const E = one.observe().energy();
  Vec3 const P = one.observe().momentum;
  one.advance(60), two.advance(60);
  EXPECT_EQ(one.observe().energy(), two.observe().energy());
  EXPECT_LT(norm(one.observe().momentum - P), 1e-9);
  EXPECT_NEAR(one.observe().energy() / E, 1, 1e-4);
  Simulation again(settings);
  again.restore(one.checkpoint());
  again.advance(20), one.advance(20);
  EXPECT_EQ(one.observe().energy(), again.observe().energy());
}

} // namespace
} // namespace mesobridge::sdpd
