#include "sdpd/make_system.hpp"
#include "sdpd/observe/bond_order.hpp"
#include "sdpd/observe/list.hpp"
#include "sdpd/observe/structure_factor.hpp"
#include "sdpd/system/system.hpp"
#include "sdpd_fixtures.hpp"
#include <complex>
#include <gtest/gtest.h>
#include <numbers>
#include <random>

namespace mesobridge::sdpd {
namespace {

/// `cells` cubes along each edge with the given sites, in units of a cube, of density 1.
std::vector<Vec3> crystal(int cells, std::vector<Vec3> const& sites) {
  double const edge = std::cbrt(static_cast<double>(sites.size()));
  std::vector<Vec3> q;
  for (int x = 0; x < cells; ++x)
    for (int y = 0; y < cells; ++y)
      for (int z = 0; z < cells; ++z)
        for (auto const& site : sites)
          q.push_back(edge * (Vec3{double(x), double(y), double(z)} + site + Vec3{0.1, 0.2, 0.3}));
  return q;
}

std::vector<Vec3> const simple_cubic{{0, 0, 0}};
std::vector<Vec3> const body_centred{{0, 0, 0}, {0.5, 0.5, 0.5}};
std::vector<Vec3> const face_centred{{0, 0, 0}, {0.5, 0.5, 0}, {0.5, 0, 0.5}, {0, 0.5, 0.5}};

Box cube_of(std::size_t particles) {
  double const edge = std::cbrt(static_cast<double>(particles));
  return {.edge = {edge, edge, edge}};
}

/// A gas with its particles there.
Simulation placed(std::vector<Vec3> const& q) {
  auto settings = ideal_gas(100, 0.03);
  settings.as<Sdpd>().h_factor = 2;
  auto const edge = cube_of(q.size()).edge;
  Region const everywhere{.name = "all", .shape = Cuboid{{}, edge}, .lattice = Lattice::random};
  settings.layout = std::make_shared<Layout const>(edge, std::vector{everywhere}, 1);
  Simulation simulation(settings);
  auto checkpoint = simulation.checkpoint();
  EXPECT_EQ(checkpoint.particles.q.size(), q.size());
  checkpoint.particles.q = checkpoint.q_at_renewal = q;
  simulation.begin_from(checkpoint);
  return simulation;
}

std::vector<double> bond_order_of(Simulation const& simulation) {
  for (auto const& measured : measurements())
    if (measured.name == "bond_order")
      return simulation.measure(measured);
  return {};
}

// The thirteen numbers of two directions have the product P6 of the angle between them.
TEST(BondOrder, HasTheHarmonicsOfDegreeSix) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> gauss;
  auto const direction = [&] {
    Vec3 const v{gauss(random), gauss(random), gauss(random)};
    return v / norm(v);
  };
  int tried = 0;
  for (; tried < 100; ++tried) {
    auto const a = direction(), b = direction();
    auto const of_a = sixth_harmonics(a), of_b = sixth_harmonics(b);
    double sum = 0;
    for (std::size_t k = 0; k < of_a.size(); ++k)
      sum += of_a[k] * of_b[k];
    EXPECT_NEAR(sum, std::legendre(6, dot(a, b)), 1e-13);
  }
  EXPECT_EQ(tried, 100);
}

// Steinhardt, Nelson and Ronchetti, Phys. Rev. B 28 (1983) 784: sums of Legendre polynomials over the angles
// of a lattice's nearest neighbours.
TEST(BondOrder, IsThatOfKnownCrystals) {
  struct Case {
    int cells;
    std::vector<Vec3> sites;
    double q6;
  };
  // sc: [1 + P6(-1) + 4 P6(0)]/6; fcc and bcc the same by hand: 0.57452, 0.51069 (14 neighbours)
  std::vector<Case> const cases{{6, simple_cubic, std::sqrt((2 - 4 * 5.0 / 16) / 6)},
                                {5, body_centred, 0.51069},
                                {4, face_centred, 0.57452}};
  int ran = 0;
  for (auto const& [cells, sites, q6] : cases) {
    SCOPED_TRACE(sites.size());
    auto const order = bond_order_of(placed(crystal(cells, sites)));
    EXPECT_NEAR(order.at(0), q6, 1e-5);
    EXPECT_NEAR(order.at(1), q6, 1e-5);
    EXPECT_EQ(order.at(2), 1);
    ++ran;
  }
  EXPECT_EQ(ran, 3);
}

// Where particles lie anywhere no two have the same order, and the whole has none.
TEST(BondOrder, VanishesForParticlesAnywhere) {
  std::mt19937_64 random(5);
  double const edge = 12;
  std::uniform_real_distribution<double> anywhere(0, edge);
  std::vector<Vec3> q(1728);
  for (auto& at : q)
    at = {anywhere(random), anywhere(random), anywhere(random)};
  auto const order = bond_order_of(placed(q));
  // Sums of b random harmonics of length 1: b^(1/2), over b; 1728 * 10.3/2 bonds.
  EXPECT_NEAR(order.at(1), 0.5 / std::sqrt(1728 * 10.3 / 2) * 2, 0.006);
  EXPECT_LT(order.at(2), 0.03);
}

std::vector<Vec3> gas(std::size_t particles, double edge, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> anywhere(0, edge);
  std::vector<Vec3> q(particles);
  for (auto& at : q)
    at = {anywhere(random), anywhere(random), anywhere(random)};
  return q;
}

// Over independent vectors S has the exponential law: a mean of n is uncertain by n^(-1/2).
TEST(StructureFactor, IsOneForAnIdealGas) {
  Box const box{.edge = {9, 8, 10}};
  double sum = 0, count = 0;
  for (unsigned seed = 1; seed <= 10; ++seed)
    for (auto const& [k, S] : structure_factor(gas(500, 8, seed), Box{.edge = {8, 8, 8}}, 3, 8))
      sum += S, ++count;
  EXPECT_GT(count, 1e4);
  EXPECT_NEAR(sum / count, 1, 4 / std::sqrt(count));
  // As many vectors as fit into the shell, in half of space.
  auto const all = structure_factor(gas(10, 8, 1), box, 3, 8);
  double const shell =
      4 * std::numbers::pi / 3 * (512 - 27) * box.volume() / std::pow(2 * std::numbers::pi, 3);
  EXPECT_NEAR(static_cast<double>(all.size()), shell / 2, 0.02 * shell);
}

// Against sums over pairs, which know no vectors: mean of S over a complete set of images.
TEST(StructureFactor, IsTheSumOverPairs) {
  Box const box{.edge = {5, 6, 7}};
  auto const q = gas(40, 5, 2);
  double const unit_z = 2 * std::numbers::pi / 7;
  // The only vector between 0.85 and 0.95 is (0, 0, 1).
  auto const found = structure_factor(q, box, 0.85, 0.95);
  ASSERT_EQ(found.size(), 1u);
  double sum = 0;
  for (auto const& a : q)
    for (auto const& b : q)
      sum += std::cos(unit_z * (a.z - b.z));
  EXPECT_NEAR(found[0].S, sum / 40, 1e-12);
  EXPECT_NEAR(found[0].k, unit_z, 1e-14);
  // Three components at once, one of them negative.
  auto const more = structure_factor(q, box, 1.8, 1.9);
  double const x = 2 * std::numbers::pi / 5, y = 2 * std::numbers::pi / 6;
  auto const of = [&](double k_x, double k_y, double k_z) {
    std::complex<double> amplitude;
    for (auto const& at : q)
      amplitude += std::polar(1.0, k_x * at.x + k_y * at.y + k_z * at.z);
    return std::norm(amplitude) / 40;
  };
  std::vector<double> expected, values;
  for (int a = -2; a <= 2; ++a)
    for (int b = -2; b <= 2; ++b)
      for (int c = -2; c <= 2; ++c)
        if (double const k = std::hypot(a * x, b * y, c * unit_z); k >= 1.8 && k <= 1.9)
          expected.push_back(of(a * x, b * y, c * unit_z));
  for (auto const& scattered : more)
    values.push_back(scattered.S), values.push_back(scattered.S); // k and -k
  std::ranges::sort(expected), std::ranges::sort(values);
  ASSERT_EQ(values.size(), expected.size());
  ASSERT_GE(values.size(), 4u);
  for (std::size_t k = 0; k < values.size(); ++k)
    EXPECT_NEAR(values[k], expected[k], 1e-12);
}

TEST(StructureFactor, OfACrystalIsItsNumberOfParticlesAtItsOwnVectors) {
  int ran = 0;
  for (auto const& sites : {simple_cubic, body_centred, face_centred}) {
    auto const q = crystal(5, sites);
    auto const peak = structure_peak(q, cube_of(q.size()));
    EXPECT_NEAR(peak.largest, static_cast<double>(q.size()), 1e-9 * static_cast<double>(q.size()));
    EXPECT_LT(peak.shell, peak.largest);
    ++ran;
  }
  EXPECT_EQ(ran, 3);
  EXPECT_THROW(structure_factor(crystal(2, simple_cubic), cube_of(8), 0.1, 0.2), InputError);
}

// exp(-(2 pi u)^2) of displacements u (Debye and Waller), and nothing where particles lie anywhere.
TEST(LatticeOrder, FallsAsDisplacementsTellIt) {
  auto settings = argon(100, 0.03);
  settings.lattice = {9, 10, 11};
  int ran = 0;
  for (double const u : {0.0, 0.1, 0.15, 0.2}) {
    settings.disorder = u;
    Simulation const simulation(settings);
    double const left = std::exp(-std::pow(2 * std::numbers::pi * u, 2));
    EXPECT_NEAR(lattice_order(simulation.snapshot().q, simulation.box()), left, 0.12 * left + 1e-12) << u;
    EXPECT_GE(simulation.crystal_fraction(),
              lattice_order(simulation.snapshot().q, simulation.box()) - 1e-12);
    ++ran;
  }
  EXPECT_EQ(ran, 4);
  EXPECT_LT(lattice_order(gas(1000, 10, 4), cube_of(1000)), 0.01);
}

} // namespace
} // namespace mesobridge::sdpd
