#include "fitting/particle_model_file.hpp"
#include "md/error.hpp"
#include <gtest/gtest.h>

namespace mesobridge::fitting {
namespace {

std::vector<double> points(double from, double to, std::size_t count) {
  std::vector<double> x(count);
  for (std::size_t k = 0; k < count; ++k)
    x[k] = from + (to - from) * static_cast<double>(k) / static_cast<double>(count - 1);
  return x;
}

/// S = 6 ln eps + eps/4 - eps^2/100 on 1 ... 6: neither C nor T is simple.
TabulatedEntropy entropy_table() {
  auto const eps = points(1, 6, 60);
  std::vector<double> S;
  for (double const x : eps)
    S.push_back(6 * std::log(x) + x / 4 - x * x / 100);
  return {eps, S};
}

struct Case {
  char const* name;
  AnyInternalEnergy model;
  double T_min, T_max;
};

class EveryInternalEnergy : public ::testing::TestWithParam<Case> {};

// dS = deps/T, C = deps/dT, C' = dC/dT by finite differences; the inversion.
TEST_P(EveryInternalEnergy, IsThermodynamicallyConsistent) {
  auto const& [name, any, T_min, T_max] = GetParam();
  int looked_at = 0;
  std::visit(
      [&](auto const& model) {
        for (double T = T_min + 0.011; T < T_max - 0.01; T += 0.0317, ++looked_at) {
          double const h = 1e-4 * T, eps = model.energy(T);
          double const d_eps = model.energy(T + h) - model.energy(T - h),
                       dS = model.entropy(T + h) - model.entropy(T - h);
          EXPECT_NEAR(dS / d_eps * T, 1, 1e-6);
          EXPECT_NEAR(d_eps / (2 * h) / model.heat_capacity(T), 1, 1e-4);
          EXPECT_NEAR(model.temperature(eps, 1.3 * T), T, 1e-12 * T);
          double const slope = (model.heat_capacity(T + h / 100) - model.heat_capacity(T - h / 100)) * 50 / h;
          EXPECT_NEAR(slope, model.heat_capacity_slope(T), 1e-3 * (1 + std::abs(slope)));
        }
      },
      any);
  EXPECT_GT(looked_at, 10);
}

INSTANTIATE_TEST_SUITE_P(
    Models, EveryInternalEnergy,
    ::testing::Values(Case{"constant", ConstantHeatCapacity(12.5), 0.2, 3},
                      Case{"heat_capacity",
                           TabulatedHeatCapacity({0.3, 0.7, 1, 1.5, 3}, {5, 9, 8, 12, 13}, 2), 0.3, 3},
                      Case{"entropy", entropy_table(), entropy_table().T_min(), entropy_table().T_max()}),
    [](auto const& info) { return info.param.name; });

// C = 4 + 2 T is reproduced exactly by the table, so energy and entropy are known: eps = 4 T + T^2, S = 4 ln
// T
// + 2 T, up to constants.
TEST(TabulatedHeatCapacity, IntegratesExactly) {
  TabulatedHeatCapacity const model(points(0.5, 2.5, 9), points(5, 9, 9), 2.25);
  EXPECT_NEAR(model.energy(2.2), 4 * 2.2 + 2.2 * 2.2, 1e-12);
  EXPECT_NEAR(model.entropy(2.2), 4 * std::log(4.4) + 2 * 1.7, 1e-12);
}

TEST(TabulatedEntropy, HasTheTemperatureOfItsFunction) {
  auto const model = entropy_table();
  for (double const eps : {1.7, 3.0, 5.1})
    EXPECT_NEAR(1 / model.temperature(eps, 1), 6 / eps + 0.25 - eps / 50, 1e-4);
}

TEST(InternalEnergy, RefusesWhatLiesOutside) {
  TabulatedHeatCapacity const model({1, 2, 3, 4}, {5, 5, 6, 6}, 0);
  EXPECT_THROW(model.energy(0.99), PhysicsError);
  EXPECT_THROW(model.energy(4.01), PhysicsError);
  EXPECT_THROW(model.temperature(-0.1, 1), PhysicsError);
  EXPECT_THROW(model.temperature(std::nan(""), 1), PhysicsError);
  EXPECT_THROW(entropy_table().temperature(0.9, 1), PhysicsError);
  EXPECT_THROW(ConstantHeatCapacity(3).temperature(0, 1), PhysicsError);
  EXPECT_THROW(ConstantHeatCapacity(0), InputError);
  EXPECT_THROW(TabulatedHeatCapacity({1, 2, 3, 4}, {5, 0, 6, 6}, 0), InputError);
  EXPECT_THROW(TabulatedHeatCapacity({1, 2, 2, 4}, {5, 5, 6, 6}, 0), InputError);
  EXPECT_THROW(TabulatedEntropy({1, 2, 3, 4, 5, 6}, {0, 1, 3, 6, 10, 15}), InputError); // convex
}

TEST(ParticleModelFile, ReadsBackBitForBit) {
  TabulatedHeatCapacity const table({0.3, 0.7, 1.0 / 3 + 1, 1.5}, {5, 9, 8.1, 12}, 2);
  ParticleModel const model{.internal_energy = table,
                            .reduced = true,
                            .data_hash = "abc",
                            .provenance = {{"made by", "a \"test\""}}};
  auto const read = parse_particle_model(to_toml(model), "model.toml");
  auto const& back = std::get<TabulatedHeatCapacity>(read.internal_energy);
  EXPECT_EQ(back.temperatures(), table.temperatures());
  EXPECT_EQ(back.heat_capacities(), table.heat_capacities());
  EXPECT_EQ(back.energy(1.2), table.energy(1.2));
  EXPECT_EQ(read.data_hash, "abc");
  EXPECT_EQ(read.provenance, model.provenance);
  EXPECT_TRUE(read.reduced);
  auto const entropy = parse_particle_model(to_toml({.internal_energy = entropy_table()}), "model.toml");
  EXPECT_EQ(std::get<TabulatedEntropy>(entropy.internal_energy).energy(0.5), entropy_table().energy(0.5));
  auto const constant =
      parse_particle_model(to_toml({.internal_energy = ConstantHeatCapacity(60)}), "model.toml");
  EXPECT_EQ(std::get<ConstantHeatCapacity>(constant.internal_energy).heat_capacity(1), 60);
  EXPECT_FALSE(constant.reduced);
}

/// A particle of which everything is known.
ParticleModel whole(bool reduced) {
  return {.internal_energy = ConstantHeatCapacity(30),
          .reduced = reduced,
          .data_hash = "",
          .provenance = {},
          .mass = 19.0 / 3,
          .state = ParticleModel::State{0.3, 1.0 / 3},
          .potential = {{"r", {0, 1, 2}}, {"u", {3, 1.0 / 3, 0}}, {"f", {2, 1, 0}}, {"u_se", {1, 0.1, 0.1}}},
          .friction = {{"r", {0, 2}}, {"gamma_par", {12.5, 0}}, {"gamma_perp", {4.0 / 7, 0}}},
          .conduction = {{"r", {0, 1, 3}}, {"kappa", {8, 2, 0}}}};
}

TEST(ParticleModelFile, HoldsAllThatAParticleIs) {
  for (bool const reduced : {true, false}) {
    auto const model = whole(reduced);
    auto const text = to_toml(model);
    EXPECT_EQ(text.find("gamma_par_kg_s") == std::string::npos, reduced);
    auto const read = parse_particle_model(text, "model.toml");
    EXPECT_EQ(read.mass, model.mass);
    EXPECT_EQ(read.state, model.state);
    EXPECT_EQ(read.potential, model.potential);
    EXPECT_EQ(read.friction, model.friction);
    EXPECT_EQ(read.conduction, model.conduction);
    EXPECT_EQ(to_toml(read), text);
  }
}

TEST(ParticleModelFile, NamesFileKeyAndWhatIsAllowed) {
  auto refused = [](std::string const& text, std::string const& what) {
    try {
      parse_particle_model(text, "model.toml");
      ADD_FAILURE() << text;
    } catch (InputError const& error) {
      EXPECT_NE(std::string(error.what()).find("model.toml"), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find(what), std::string::npos) << error.what();
    }
  };
  std::string const head = "format = \"mesobridge internal energy 1\"\ntemperature_unit = \"K\"\n";
  refused("format = \"x\"\n", "mesobridge particle 1");
  refused(head + "kind = \"linear\"\n", "heat-capacity");
  refused(head + "kind = \"constant\"\n[constant]\nC_kB = -1.0\n", "must be > 0");
  refused(head + "kind = \"constant\"\n[constant]\nC_kB = 2.0\nD = 1.0\n", "D");
  std::string const particle = head + "kind = \"constant\"\n[constant]\nC_kB = 2.0\n";
  refused(particle + "[particle]\nmass = 1.0\n", "mass_kg");
  refused(particle + "[particle]\nmass_kg = 0.0\n", "must be > 0");
  refused(particle + "[state]\nrho_kg_m3 = -1.0\nT = 1.0\n", "rho_kg_m3");
  refused(particle + "[potential]\npoints = 2\nr_m = [0.0, 1.0]\n", "u_J");
  refused(particle + "[friction]\npoints = 2\nr_m = [0.0, 1.0]\ngamma_par_kg_s = [1.0]\n", "gamma_par_kg_s");
  refused(particle + "[conduction]\npoints = 2\nr_m = [0.0, 1.0]\nkappa = [1.0, 0.0]\n", "kappa");
  refused(head + "kind = \"heat-capacity\"\n[heat_capacity]\npoints = 4\nT = [1.0, 2.0]\nC_kB = [1.0]\n",
          "T");
}

} // namespace
} // namespace mesobridge::fitting
