#include "fitting/eos/array.hpp"
#include "unit/fitting/random_states.hpp"
#include <gtest/gtest.h>

namespace mesobridge::fitting::test {
namespace {

double in_units_of_the_last_place(double a, double b) {
  return std::abs(a - b) / (std::numeric_limits<double>::epsilon() * std::abs(b));
}

TEST(Pack, ExpAndLogAreThoseOfTheLibrary) {
  std::mt19937_64 generator(5);
  std::uniform_real_distribution<double> exponent(-700, 700), near_one(0.5, 2);
  double worst_exp = 0, worst_log = 0;
  int cases = 0;
  for (; cases < 200000; ++cases) {
    double const x = exponent(generator) * (cases % 2 ? 1 : 1e-3),
                 y = cases % 2 ? std::exp(x) : near_one(generator);
    worst_exp =
        std::max(worst_exp, in_units_of_the_last_place(exp(Pack(x)).v[cases % Pack::size], std::exp(x)));
    worst_log =
        std::max(worst_log, in_units_of_the_last_place(log(Pack(y)).v[cases % Pack::size], std::log(y)));
  }
  std::printf("%d numbers; largest error of exp %.2f, of log %.2f units of the last place\n", cases,
              worst_exp, worst_log);
  EXPECT_EQ(cases, 200000);
  EXPECT_LT(worst_exp, 3);
  EXPECT_LT(worst_log, 3);
}

TEST(Pack, ExpHasItsLimits) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(exp(Pack(infinity)).v[0], infinity);
  EXPECT_EQ(exp(Pack(710.0)).v[0], infinity);
  EXPECT_EQ(exp(Pack(-infinity)).v[0], 0);
  EXPECT_EQ(exp(Pack(-746.0)).v[0], 0);
  EXPECT_EQ(exp(Pack(0.0)).v[0], 1);
  EXPECT_TRUE(std::isnan(exp(Pack(std::numeric_limits<double>::quiet_NaN())).v[0]));
  EXPECT_NEAR(exp(Pack(-740.0)).v[0] / std::exp(-740.0), 1, 1e-2); // denormal
}

struct Batch {
  std::vector<double> e, rho, T, P, C;
  EnergyStates in() const { return {e, rho}; }
  ThermalResponse out() { return {T, P, C}; }
};

template <class E>
Batch random_batch(E const& eos, std::size_t n) {
  std::mt19937_64 generator(6);
  Batch batch;
  for (std::size_t i = 0; i < n; ++i) {
    auto const [rho, T] = random_state(eos, generator);
    batch.rho.push_back(rho);
    batch.e.push_back(eos.energy_from_temperature(T, rho));
  }
  batch.T.resize(n), batch.P.resize(n), batch.C.resize(n);
  return batch;
}

template <class E>
int check_array(E const& eos, std::size_t n) {
  auto batch = random_batch(eos, n);
  evaluate(eos, batch.in(), batch.out());
  int cases = 0;
  for (std::size_t i = 0; i < n; ++i, ++cases) {
    auto const isochore = eos.isochore(batch.rho[i]);
    double const T = isochore.temperature_from_energy(batch.e[i], 1);
    // The energy may be a small difference of large terms; so its last digits are the scale of T's.
    double const T_scale = std::abs(batch.e[i]) / isochore.heat_capacity(T);
    double const P_scale = T_scale * isochore.pressure_slope(T) + cold_pressure(eos, batch.rho[i]);
    EXPECT_LT(discrepancy(batch.T[i], T, T_scale), 1e-13);
    EXPECT_LT(discrepancy(batch.P[i], isochore.pressure(T), P_scale), 1e-13);
    EXPECT_NEAR(batch.C[i] / isochore.heat_capacity(T), 1, 1e-12);
  }
  return cases;
}

TEST(EosArray, IsEachStateAlone) {
  int models = 0;
  for (auto const& material : materials()) {
    SCOPED_TRACE(material.name);
    for (std::size_t n : {0, 1, 7, 8, 9, 1003})
      EXPECT_EQ(std::visit([n](auto const& eos) { return check_array(eos, n); }, material.eos), int(n));
    ++models;
  }
  EXPECT_GE(models, 9);
}

TEST(EosArray, RefusesBadStatesByName) {
  int refused = 0;
  for (auto const& material : materials()) {
    SCOPED_TRACE(material.name);
    for (std::size_t at : {0, 5, 20})
      for (bool energy : {true, false}) {
        auto const run = [&](auto const& eos) {
          auto batch = random_batch(eos, 21);
          (energy ? batch.e : batch.rho)[at] = energy ? -1e30 : -1;
          evaluate(eos, batch.in(), batch.out());
        };
        EXPECT_THROW(std::visit(run, material.eos), PhysicsError);
        ++refused;
      }
  }
  EXPECT_EQ(refused, 6 * int(materials().size()));
}

} // namespace
} // namespace mesobridge::fitting::test
