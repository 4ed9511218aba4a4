#include "fitting/isentrope.hpp"
#include "fitting/riemann.hpp"
#include "fitting/shock_relations.hpp"
#include "md/error.hpp"
#include <gtest/gtest.h>

// Every model at states that no one should ask for: it answers with finite numbers, or refuses.

namespace mesobridge::fitting::test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
double const numbers[] = {5e-324, 1e-308, 1e-100, 1e-30, 1e-8, 1e-3, 0.3,   1,     7,       300,     997,
                          1488,   1e4,    1e6,    1e9,   1e15, 1e30, 1e100, 1e300, 1.7e308, infinity};

struct Counts {
  int finite = 0, refused = 0;
};

bool finite(EosState const& s) {
  for (double const x : {s.rho, s.T, s.e, s.P, s.s, s.c_v, s.sound_speed_squared, s.sound_speed.value_or(0),
                         s.gruneisen, s.free_energy, s.alpha_r.value_or(0)})
    if (!std::isfinite(x))
      return false;
  return true;
}

template <class F>
void expect_finite_or_refused(F&& f, Counts& counts) {
  try {
    EXPECT_TRUE(f());
    ++counts.finite;
  } catch (PhysicsError const&) {
    ++counts.refused;
  } catch (InputError const&) {
    ++counts.refused;
  }
}

/// f(fluid, counts) for every built-in material.
template <class F>
void for_each_fluid(F const& f) {
  for (auto const& material : materials()) {
    SCOPED_TRACE(material.name);
    Counts counts;
    f(Fluid(material.eos), counts);
  }
}

TEST(ExtremeStates, AreFiniteOrRefused) {
  for_each_fluid([&](Fluid const& fluid, Counts& counts) {
    for (double const rho : numbers)
      for (double const x : numbers) {
        SCOPED_TRACE(fmt::format("{} {}", rho, x));
        expect_finite_or_refused([&] { return finite(fluid.at_temperature(rho, x)); }, counts);
        for (double const sign : {-1, 1}) {
          expect_finite_or_refused([&] { return finite(fluid.at_energy(rho, sign * x)); }, counts);
          expect_finite_or_refused([&] { return finite(fluid.at_entropy(rho, sign * x)); }, counts);
        }
      }
    for (double const x : {0.0, -1.0, std::nan("")}) {
      expect_finite_or_refused([&] { return finite(fluid.at_temperature(x, 300)); }, counts);
      expect_finite_or_refused([&] { return finite(fluid.at_temperature(1, x)); }, counts);
    }
    EXPECT_GT(counts.finite, 10);
    EXPECT_GT(counts.refused, 500);
    EXPECT_EQ(counts.finite + counts.refused, 21 * 21 * 5 + 6);
  });
}

TEST(ExtremeStates, OfShocksWavesAndReleasesAreFiniteOrRefused) {
  double const few[] = {1e-308, 1e-30, 0.5, 1, 300, 997, 1e30};
  for_each_fluid([&](Fluid const& fluid, Counts& counts) {
    for (double const rho : few)
      for (double const T : few) {
        EosState at_rest;
        try {
          at_rest = fluid.at_temperature(rho, T);
        } catch (PhysicsError const&) {
          continue;
        }
        for (double const x : few) {
          SCOPED_TRACE(fmt::format("{} {} {}", rho, T, x));
          auto const shocked = [&](auto const& find) {
            expect_finite_or_refused(
                [&] {
                  auto const shock = find(Hugoniot(fluid, at_rest));
                  return finite(shock.behind) && std::isfinite(shock.v_P) && std::isfinite(shock.v_S);
                },
                counts);
          };
          shocked([&](Hugoniot const& hugoniot) { return hugoniot.from_piston(x); });
          shocked([&](Hugoniot const& hugoniot) { return hugoniot.from_speed(x); });
          shocked([&](Hugoniot const& hugoniot) { return hugoniot.from_pressure(x); });
          shocked([&](Hugoniot const& hugoniot) { return hugoniot.from_density(x); });
          expect_finite_or_refused([&] { return finite(Isentrope(fluid, at_rest).at_density(x)); }, counts);
        }
      }
    EXPECT_GT(counts.finite, 0);
    EXPECT_GT(counts.refused, 20);
  });
}

} // namespace
} // namespace mesobridge::fitting::test
