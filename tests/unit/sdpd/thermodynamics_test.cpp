#include "fitting/eos/centre_of_mass_free.hpp"
#include "fitting/eos/evaluate.hpp"
#include "sdpd/thermodynamics/thermodynamics.hpp"
#include <gtest/gtest.h>

namespace mesobridge::sdpd {
namespace {

struct Totals {
  double eps, P; ///< per particle and with the motion of its centre of mass, in the model's units
};

/// One particle of size K at the given state, and the (3/2) k_B T and k_B T/V that its motion adds.
Totals particle_and_its_motion(fitting::AnyEos const& eos, double K, double rho, double T,
                               CentreOfMass part) {
  auto const units = std::visit(
      [&](auto const& model) {
        return ReducedUnits{.K = K,
                            .m0 = model.molecular_mass(),
                            .density = 0.9 * rho, // the state is not the one of the units
                            .temperature = 1.2 * T,
                            .boltzmann = model.boltzmann()};
      },
      eos);
  auto const thermodynamics = make_thermodynamics(eos, units, part);
  Particles one;
  one.resize(1);
  one.rho[0] = rho / units.density, one.T[0] = T / units.temperature;
  Failure failure;
  thermodynamics->energy_from_temperature(one, {0, 1}, failure);
  one.T[0] = 0.8;
  thermodynamics->from_energy(one, {0, 1}, failure);
  EXPECT_FALSE(failure.any()) << failure.message();
  double const thermal = units.boltzmann * T, volume = units.mass() / rho;
  return {one.eps[0] * units.energy() + 1.5 * thermal, one.P[0] * units.pressure() + thermal / volume};
}

// What a particle has inside and what its centre of mass carries are the bulk together, whatever the size.
TEST(CentreOfMassFreeParticles, HaveTheBulksTotalsAtEverySize) {
  int cases = 0;
  for (auto const& material : fitting::materials()) {
    SCOPED_TRACE(material.name);
    auto const domain = std::visit([](auto const& eos) { return eos.domain(); }, material.eos);
    double const rho = material.name == "tin"            ? 7500
                       : material.name.starts_with("lj") ? 0.7
                       : std::isfinite(domain.rho_max)   ? 0.5 * domain.rho_max
                                                         : 1100;
    double const T = material.name.starts_with("lj") ? 2 : 1200;
    auto const bulk = std::visit(
        [&](auto const& eos) { return fitting::state_from_temperature(eos, rho, T); }, material.eos);
    double const m0 = std::visit([](auto const& eos) { return eos.molecular_mass(); }, material.eos);
    for (double const K : {2.0, 5.0, 300.0}) {
      auto const totals = particle_and_its_motion(material.eos, K, rho, T, CentreOfMass::free);
      EXPECT_NEAR(totals.eps / (K * m0 * bulk.e), 1, 1e-11);
      EXPECT_NEAR(totals.P / bulk.P, 1, 1e-11);
      auto const other = particle_and_its_motion(material.eos, K, rho, T, CentreOfMass::bulk);
      EXPECT_GT(other.eps / (K * m0), bulk.e + 1e-4 * std::abs(bulk.e)); // the motion comes on top
      EXPECT_GT(other.P, bulk.P);
      ++cases;
    }
  }
  EXPECT_EQ(cases, 3 * int(fitting::materials().size()));
}

TEST(CentreOfMassFreeParticles, RefuseHeatCapacitiesWithoutAPositiveFriction) {
  ReducedUnits const units{.K = 1.2, .m0 = 1e-25, .density = 1000, .temperature = 500, .boltzmann = k_B};
  auto const gas = make_thermodynamics(fitting::IdealGas(1e-25), units); // (3/2) (K - 1) k_B = 0.3 k_B
  Particles one;
  one.resize(1);
  one.rho[0] = one.T[0] = 1;
  try {
    gas->caloric(one, 0, 0.25, 1);
    FAIL() << "a heat capacity of 0.3 k_B was accepted";
  } catch (PhysicsError const& error) {
    EXPECT_NE(std::string(error.what()).find("is 0.3 k_B"), std::string::npos) << error.what();
  }
}

/// States about (0.6 to 1.4 times) a middle one; every seventh is far below the temperatures of the others,
/// and every eleventh temperature to begin the inversion at is far off.
Particles scattered_states(Thermodynamics const& thermodynamics, std::size_t count, double cold) {
  Particles particles;
  particles.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    particles.id[i] = static_cast<std::uint32_t>(i);
    particles.rho[i] = 0.6 + 0.8 * std::fmod(0.618034 * double(i), 1);
    particles.T[i] = 0.6 + 0.8 * std::fmod(0.414214 * double(i), 1);
    if (i % 7 == 0)
      particles.T[i] *= cold;
  }
  Failure failure;
  thermodynamics.energy_from_temperature(particles, {0, count}, failure);
  for (std::size_t i = 0; i < count; ++i)
    particles.T[i] *= i % 11 == 0 ? 30 : 1.01;
  EXPECT_FALSE(failure.any()) << failure.message();
  return particles;
}

bool same_bits(Particles const& a, Particles const& b, std::size_t i) {
  auto const &x = a.caloric[i], &y = b.caloric[i];
  return a.T[i] == b.T[i] && a.S[i] == b.S[i] && a.eps[i] == b.eps[i] && a.P[i] == b.P[i] && x.T_0 == y.T_0 &&
         x.inverse_C_0 == y.inverse_C_0 && x.curvature == y.curvature && x.limit == y.limit;
}

class PackedParticles : public testing::TestWithParam<std::string> {
 protected:
  fitting::AnyEos const& eos() const { return fitting::material(GetParam()).eos; }
  ReducedUnits units() const {
    bool const reduced = GetParam().starts_with("lj");
    double const m0 = std::visit([](auto const& model) { return model.molecular_mass(); }, eos());
    return {.K = 20,
            .m0 = m0,
            .density = reduced ? 0.6 : 1000,
            .temperature = reduced ? 2.0 : 500.0,
            .boltzmann = reduced ? 1.0 : k_B};
  }
};

// The oracle: the bulk's equation of state, one state at a time.
TEST_P(PackedParticles, HaveTheStatesOfTheModelForOneParticle) {
  auto const of = make_thermodynamics(eos(), units());
  auto many = scattered_states(*of, 203, 0.2);
  Failure failure;
  of->from_energy(many, {0, many.size()}, failure);
  ASSERT_FALSE(failure.any()) << failure.message();
  auto const u = units();
  auto const scalar = [&](std::size_t i) {
    return std::visit(
        [&](auto const& bulk) {
          fitting::CentreOfMassFree const model(bulk, u.K);
          double const rho = many.rho[i] * u.density, e = many.eps[i] * u.specific_energy();
          auto const isochore = model.isochore(rho);
          double const T = isochore.temperature_from_energy(e, many.T[i] * u.temperature);
          return std::array{T / u.temperature, isochore.entropy(T) / u.specific_entropy(),
                            isochore.pressure(T) / u.pressure(),
                            u.specific_entropy() / isochore.heat_capacity(T)};
        },
        eos());
  };
  for (std::size_t i = 0; i < many.size(); ++i) {
    auto const [T, S, P, inverse_C] = scalar(i);
    EXPECT_NEAR(many.T[i], T, 1e-12 * T);
    EXPECT_NEAR(many.S[i], S, 1e-12 * (std::abs(S) + 1));
    EXPECT_NEAR(many.P[i], P, 1e-11 * (std::abs(P) + 1));
    EXPECT_NEAR(many.caloric[i].inverse_C_0, inverse_C, 1e-11 * inverse_C);
  }
  auto back = many;
  for (std::size_t i = 0; i < back.size(); ++i)
    back.T[i] *= 0.99;
  of->from_entropy(back, {0, back.size()}, failure);
  for (std::size_t i = 0; i < back.size(); ++i)
    EXPECT_NEAR(back.eps[i], many.eps[i], 1e-12 * (std::abs(many.eps[i]) + 1));
}

// Threads cut the particles elsewhere, and a restart knows the temperatures alone.
TEST_P(PackedParticles, DoNotFeelTheirNeighboursInMemoryNorARestart) {
  auto const of = make_thermodynamics(eos(), units());
  auto const start = scattered_states(*of, 203, 0.2);
  auto whole = start, parts = start;
  Failure failure;
  of->from_energy(whole, {0, start.size()}, failure);
  std::size_t begin = 0;
  for (std::size_t const end : {3u, 4u, 97u, 203u})
    of->from_energy(parts, {begin, end}, failure), begin = end;
  auto restarted = whole;
  std::ranges::fill(restarted.P, 0);
  std::ranges::fill(restarted.caloric, Caloric{});
  of->response(restarted, {0, start.size()}, failure);
  ASSERT_FALSE(failure.any()) << failure.message();
  for (std::size_t i = 0; i < start.size(); ++i) {
    EXPECT_TRUE(same_bits(whole, parts, i)) << i;
    EXPECT_TRUE(same_bits(whole, restarted, i)) << i;
  }
}

TEST_P(PackedParticles, HaveTheSameTemperaturesWithoutPressures) {
  auto const of = make_thermodynamics(eos(), units());
  auto whole = scattered_states(*of, 203, 0.2), alone = whole;
  Failure failure;
  of->from_energy(whole, {0, whole.size()}, failure);
  of->temperature_from_energy(alone, {0, alone.size()}, failure);
  ASSERT_FALSE(failure.any()) << failure.message();
  for (std::size_t i = 0; i < whole.size(); ++i) {
    EXPECT_EQ(alone.T[i], whole.T[i]) << i;
    EXPECT_EQ(alone.S[i], whole.S[i]) << i;
    EXPECT_EQ(alone.P[i], 0) << i;
  }
}

TEST_P(PackedParticles, OutsideTheModelAreReportedAndTheOthersGoOn) {
  auto const of = make_thermodynamics(eos(), units());
  auto many = scattered_states(*of, 24, 1);
  many.eps[13] = -1e9;
  Failure failure;
  of->from_energy(many, {0, many.size()}, failure);
  EXPECT_TRUE(failure.any());
  EXPECT_EQ(failure.id(), 13u);
  EXPECT_GT(many.P[12], 0);
  EXPECT_GT(many.P[14], 0);
}

INSTANTIATE_TEST_SUITE_P(Models, PackedParticles, testing::Values("argon", "lj", "ideal-gas", "water"),
                         [](auto const& info) {
                           std::string name = info.param;
                           std::erase(name, '-');
                           return name;
                         });

} // namespace
} // namespace mesobridge::sdpd
