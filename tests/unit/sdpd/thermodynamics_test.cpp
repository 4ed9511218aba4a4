#include "fitting/eos/evaluate.hpp"
#include "sdpd/thermodynamics.hpp"
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
  EXPECT_EQ(cases, 27);
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

} // namespace
} // namespace mesobridge::sdpd
