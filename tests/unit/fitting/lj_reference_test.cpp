#include "fitting/eos/list.hpp"
#include <gtest/gtest.h>

namespace mesobridge::fitting::test {
namespace {

/// Kolafa and Nezbeda's pressure as they print it, Eq. (31): z of the spheres and the derivatives by hand.
double printed_pressure(double rho, double T) {
  double const s = std::sqrt(T);
  double const d =
      -0.063920968 * std::log(T) + 0.011117524 / T - 0.076383859 / s + 1.080142248 + 0.000693129 * s;
  double const eta = std::numbers::pi / 6 * rho * d * d * d, g = 1.92907278;
  double const z = (1 + eta * (1 + eta * (1 - eta / 1.5 * (1 + eta)))) / std::pow(1 - eta, 3);
  double const B = -7.02181962 / T + 2.90616279 * std::pow(T, -1.5) - 4.13749995 / (T * T) +
                   0.87361369 * std::pow(T, -2.5) + 0.43102052 / (T * T * T) -
                   0.58544978 * std::pow(T, -3.5) + 0.02459877;
  double P = rho * T * (z + rho * B * std::exp(-g * rho * rho) * (1 - 2 * g * rho * rho));
  auto add = [&](double power, std::initializer_list<double> C) {
    int j = 2;
    for (double c : C) {
      P += j * c * std::pow(T, power) * std::pow(rho, j + 1);
      ++j;
    }
  };
  add(0, {2.01546797, -28.17881636, 28.28313847, -10.42402873});
  add(-0.5, {-19.58371655, 75.62340289, -120.70586598, 93.92740328, -27.37737354});
  add(-1, {29.34470520, -112.35356937, 170.64908980, -123.06669187, 34.42288969});
  add(-2, {-13.37031968, 65.38059570, -115.09233113, 88.91973082, -25.62099890});
  return P;
}

TEST(KolafaNezbeda, HasThePrintedPressure) {
  auto const& lj = std::get<LjKolafaNezbeda>(material("lj-kn").eos);
  int cases = 0;
  for (double rho : {0.01, 0.2, 0.8, 1.2})
    for (double T : {0.7, 1.3, 5.0, 20.0}) {
      double const printed = printed_pressure(rho, T);
      EXPECT_NEAR(lj.isochore(rho).pressure(T), printed, 1e-11 * (1 + std::abs(printed)));
      ++cases;
    }
  EXPECT_EQ(cases, 16);
}

TEST(KolafaNezbeda, AgreesWithTheCirculatedValues) {
  // Computed by a program with single-precision coefficients: good to 2e-7 (in double, the same formula gives
  // P = 0.12147934165615).
  auto const& lj = std::get<LjKolafaNezbeda>(material("lj-kn").eos);
  auto const at = lj.isochore(0.2);
  EXPECT_NEAR(at.pressure(1.3), 0.121479368, 4e-8);
  EXPECT_NEAR(at.energy(1.3) - 1.95, -1.537151128, 2e-7);
  EXPECT_NEAR(at.pressure(1.3), 0.12147934165615, 1e-13);
}

TEST(Thol, HasThePublishedResidualEnergy) {
  // Independent value at the critical parameters.
  EXPECT_NEAR(std::get<LjThol>(material("lj-thol").eos).alpha_r(0.31, 1.32), -0.848655028421735, 1e-14);
}

TEST(LjReferences, AgreeWithEachOtherInTheDenseFluid) {
  // Three equations fitted to different simulations: close to each other where they are all good.
  auto const& kn = std::get<LjKolafaNezbeda>(material("lj-kn").eos);
  auto const& thol = std::get<LjThol>(material("lj-thol").eos);
  auto const& bwr = std::get<LjBwr>(material("lj").eos);
  int cases = 0;
  for (double rho : {0.1, 0.5, 0.8})
    for (double T : {1.5, 3.0, 5.0}) {
      double const P = thol.isochore(rho).pressure(T), e = thol.isochore(rho).energy(T);
      EXPECT_NEAR(kn.isochore(rho).pressure(T), P, 0.01 * P + 0.005);
      EXPECT_NEAR(bwr.isochore(rho).pressure(T), P, 0.01 * P + 0.005);
      EXPECT_NEAR(kn.isochore(rho).energy(T), e, 0.06);
      EXPECT_NEAR(bwr.isochore(rho).energy(T), e, 0.06);
      EXPECT_NEAR(kn.isochore(rho).entropy(T), thol.isochore(rho).entropy(T), 0.02);
      ++cases;
    }
  EXPECT_EQ(cases, 9);
}

/// The smallest heat capacity per atom over a fine grid of the domain.
template <class R>
double lowest_heat_capacity(int& states) {
  double lowest = 1e300;
  for (double rho = 0.002; rho <= R::rho_max; rho += 0.004) {
    BasicFreeEnergyIsochore<R, double> const isochore({}, rho);
    for (double T = R::T_min(rho); T <= R::T_max; T *= 1.01, ++states)
      lowest = std::min(lowest, isochore.heat_capacity(T));
  }
  return lowest;
}

TEST(LjReferences, HaveUniqueTemperaturesAllOverTheirDomains) {
  int states = 0;
  EXPECT_GT(lowest_heat_capacity<KolafaNezbeda>(states), 1.5);
  EXPECT_GT(lowest_heat_capacity<Thol>(states), 0.9);
  EXPECT_GT(states, 100000 / 2);
  // Inside the region that is left out, Thol's loops have no unique temperature.
  EXPECT_LT((BasicFreeEnergyIsochore<Thol, double>({}, 0.306).heat_capacity(1.124)), -1e4);
}

TEST(LjReferences, StatesOutsideAreRefusedByName) {
  auto const& thol = std::get<LjThol>(material("lj-thol").eos);
  auto const& kn = std::get<LjKolafaNezbeda>(material("lj-kn").eos);
  EXPECT_THROW(thol.energy_from_temperature(1.19, 0.3), PhysicsError);
  EXPECT_NO_THROW(thol.energy_from_temperature(0.7, 0.85));
  EXPECT_THROW(thol.isochore(1.21), PhysicsError);
  EXPECT_THROW(kn.energy_from_temperature(0.6, 0.85), PhysicsError);
  try {
    kn.temperature(-8, 0.8);
    FAIL() << "no exception";
  } catch (PhysicsError const& error) {
    std::string const what = error.what();
    for (auto const* part : {"Kolafa-Nezbeda", "density 0.8", "energy -8", "0.68 <= T* <= 20"})
      EXPECT_NE(what.find(part), std::string::npos) << what;
  }
  // Between the spinodals there is no sound.
  EXPECT_THROW(kn.sound_speed(kn.energy_from_temperature(0.8, 0.4), 0.4), PhysicsError);
}

} // namespace
} // namespace mesobridge::fitting::test
