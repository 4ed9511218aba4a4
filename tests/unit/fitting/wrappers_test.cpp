#include "fitting/eos/centre_of_mass_free.hpp"
#include "fitting/eos/list.hpp"
#include "unit/fitting/random_states.hpp"
#include <gtest/gtest.h>

namespace mesobridge::fitting::test {
namespace {

static_assert(EquationOfState<CentreOfMassFree<LjBwr>> && EquationOfState<CentreOfMassFree<LjThol>>);
static_assert(EquationOfState<CentreOfMassFree<Hz>> && EquationOfState<CentreOfMassFree<IdealGas>>);

TEST(CentreOfMassFree, IdealGasObeysTheLawOfOneAtomLess) {
  // sdpd/README.md, Eq. (S19): S = 3/2 (K-1) k_B ln eps - (K-1) k_B ln rho, for one particle of K atoms.
  int cases = 0;
  for (double K : {2.0, 5.0, 1000.0}) {
    double const m0 = 1e-25, M = K * m0, C = 1.5 * (K - 1) * k_B;
    CentreOfMassFree const inner(IdealGas(m0), K);
    for (double rho : {10.0, 1150.0})
      for (double T : {20.0, 1000.0, 1e6}) {
        double const eps = C * T, e = eps / M;
        EXPECT_NEAR(inner.temperature(e, rho) / T, 1, 1e-14);
        EXPECT_NEAR(inner.heat_capacity(e, rho) * M / C, 1, 1e-14);
        EXPECT_NEAR(inner.pressure(e, rho) / ((K - 1) * k_B * T * rho / M), 1, 1e-14);
        double const dS = (inner.entropy(2 * e, 3 * rho) - inner.entropy(e, rho)) * M;
        EXPECT_NEAR(dS / (C * std::log(2) - (K - 1) * k_B * std::log(3)), 1, 1e-12);
        ++cases;
      }
  }
  EXPECT_EQ(cases, 18);
  EXPECT_THROW(CentreOfMassFree(IdealGas(1e-25), 1), InputError);
  EXPECT_THROW(CentreOfMassFree(IdealGas(1e-25), NAN), InputError);
}

/// Adding the ideal gas of the particles back gives the bulk; -s and P are derivatives of the free energy.
template <class E>
void check_parts(E const& bulk, double K) {
  CentreOfMassFree const inner(bulk, K);
  std::mt19937_64 generator(3);
  double const r = bulk.boltzmann() / (K * bulk.molecular_mass()), h = 1e-30;
  using Complex = std::complex<double>;
  int cases = 0;
  for (; cases < 1000; ++cases) {
    auto const [rho, T] = random_state(bulk, generator);
    auto const whole = bulk.isochore(rho);
    auto const part = inner.isochore(rho);
    double const e = part.energy(T), s = part.entropy(T),
                 T_scale = std::max(T, interaction_temperature(bulk));
    double const P_scale = rho * r * K * T_scale + cold_pressure(bulk, rho);
    ASSERT_LT(discrepancy(e + 1.5 * r * T, whole.energy(T), r * K * T), 1e-12);
    ASSERT_LT(discrepancy(part.pressure(T) + rho * r * T, whole.pressure(T), P_scale), 1e-12);
    ASSERT_LT(std::abs(part.temperature_from_energy(e, 2 * T) / T - 1), 1e-10);
    ASSERT_LT(std::abs(part.temperature_from_entropy(s, 0.3 * T) / T - 1), 1e-10);
    auto free_energy = [](auto const& i, Complex t) { return i.energy(t) - t * i.entropy(t); };
    double const minus_s = free_energy(inner.isochore(Complex(rho)), Complex(T, h * T)).imag() / (h * T);
    double const P = rho * free_energy(inner.isochore(Complex(rho, h * rho)), Complex(T)).imag() / h;
    ASSERT_LT(discrepancy(s, -minus_s, r * K), 1e-9);
    ASSERT_LT(discrepancy(part.pressure(T), P, P_scale), 1e-9);
  }
  EXPECT_EQ(cases, 1000);
}

TEST(CentreOfMassFree, AndTheCentreOfMassMakeTheBulk) {
  int models = 0;
  for (auto const& material : materials()) {
    SCOPED_TRACE(material.name);
    std::visit([](auto const& eos) { check_parts(eos, 7); }, material.eos);
    ++models;
  }
  EXPECT_GE(models, 9);
}

TEST(CentreOfMassFree, RefusesEnergiesBelowItsColdest) {
  auto const& argon = std::get<LjBwr>(material("argon").eos);
  CentreOfMassFree const inner(argon, 10);
  EXPECT_THROW(inner.temperature(-1e7, 1150), PhysicsError);
  EXPECT_THROW(inner.temperature(NAN, 1150), PhysicsError);
  EXPECT_THROW(CentreOfMassFree(argon, 0.5), InputError);
}

} // namespace
} // namespace mesobridge::fitting::test
