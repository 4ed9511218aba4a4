#include "fitting/isentrope.hpp"
#include "fitting/riemann.hpp"
#include "fitting/shock_relations.hpp"
#include <array>
#include <gtest/gtest.h>

namespace mesobridge::fitting::test {
namespace {

RiemannSide air(double rho, double u, double P) {
  Fluid const gas(IdealGas::from_gamma(1, 1.4, 1));
  return {gas, gas.at_energy(rho, P / (0.4 * rho)), u};
}

RiemannSide side(std::string const& name, double rho, double T, double u) {
  Fluid const fluid(material(name).eos);
  return {fluid, fluid.at_temperature(rho, T), u};
}

TEST(Riemann, SolvesSodsTube) {
  RiemannSolution const sod(air(1, 0, 1), air(0.125, 0, 0.1));
  EXPECT_NEAR(sod.P(), 0.30313017805, 1e-9);
  EXPECT_NEAR(sod.u(), 0.92745262005, 1e-9);
  EXPECT_NEAR(sod.left_of_contact().rho, 0.42631942818, 1e-9);
  EXPECT_NEAR(sod.right_of_contact().rho, 0.26557371171, 1e-9);
  EXPECT_NEAR(sod.right_wave().head, 1.7521557320, 1e-9);
  EXPECT_TRUE(sod.right_shock());
  EXPECT_FALSE(sod.left_shock());
  // Inside the fan, u = 2 (c_L + xi)/(gamma + 1).
  double const c_L = std::sqrt(1.4);
  EXPECT_NEAR(sod.left_wave().head, -c_L, 1e-12);
  int points = 0;
  for (double const xi : {-1.1, -0.7, -0.2}) {
    auto const flow = sod.at(xi);
    EXPECT_NEAR(flow.u, (c_L + xi) / 1.2, 1e-10);
    EXPECT_NEAR(flow.state.rho, std::pow((c_L - 0.2 * flow.u) / c_L, 5), 1e-10);
    ++points;
  }
  EXPECT_EQ(points, 3);
}

TEST(Riemann, SolvesTorosTests) {
  // Toro, 3rd edition, table 4.3
  struct Case {
    RiemannSide left, right;
    double P, u, rho_left, rho_right;
  };
  std::vector<Case> const cases{
      {air(1, -2, 0.4), air(1, 2, 0.4), 0.00189, 0.0, 0.02185, 0.02185},
      {air(1, 0, 1000), air(1, 0, 0.01), 460.894, 19.5975, 0.57506, 5.99924},
      {air(1, 0, 0.01), air(1, 0, 100), 46.0950, -6.19633, 5.99242, 0.57511},
      {air(5.99924, 19.5975, 460.894), air(5.99242, -6.19633, 46.0950), 1691.64, 8.68975, 14.2823, 31.0426},
  };
  int ran = 0;
  for (auto const& c : cases) {
    RiemannSolution const solution(c.left, c.right);
    EXPECT_NEAR(solution.P(), c.P, std::max(5e-6 * c.P, 5e-6)) << ran;
    EXPECT_NEAR(solution.u(), c.u, 6e-6 * std::max(1.0, std::abs(c.u))) << ran;
    EXPECT_NEAR(solution.left_of_contact().rho, c.rho_left, 5e-5) << ran;
    EXPECT_NEAR(solution.right_of_contact().rho, c.rho_right, 5e-5) << ran;
    ++ran;
  }
  EXPECT_EQ(ran, 4);
}

using Balance = std::array<double, 3>;

Balance densities(FlowState const& f) {
  double const rho = f.state.rho;
  return {rho, rho * f.u, rho * (f.state.e + 0.5 * f.u * f.u)};
}
Balance fluxes(RiemannSide const& s) {
  double const rho = s.state.rho;
  return {rho * s.u, rho * s.u * s.u + s.state.P, s.u * (rho * (s.state.e + 0.5 * s.u * s.u) + s.state.P)};
}

/// What lies between -1 and 1 (in units of `edge`) at time 1, by Gauss's rule between the edges of the waves:
/// the similarity solution knows nothing of this balance.
Balance content(RiemannSolution const& solution, double edge) {
  constexpr std::array<double, 5> node{-0.9061798459386640, -0.5384693101056831, 0, 0.5384693101056831,
                                       0.9061798459386640};
  constexpr std::array<double, 5> weight{0.2369268850561891, 0.4786286704993665, 0.5688888888888889,
                                         0.4786286704993665, 0.2369268850561891};
  std::vector<double> const edges{-edge,        solution.left_wave().head,  solution.left_wave().tail,
                                  solution.u(), solution.right_wave().tail, solution.right_wave().head,
                                  edge};
  Balance sum{};
  for (std::size_t piece = 0; piece + 1 < edges.size(); ++piece)
    for (int part = 0; part < 4; ++part) {
      double const h = (edges[piece + 1] - edges[piece]) / 4, a = edges[piece] + part * h;
      if (h <= 0)
        continue;
      for (std::size_t i = 0; i < node.size(); ++i) {
        auto const values = densities(solution.at(a + 0.5 * h * (1 + node[i])));
        for (std::size_t k = 0; k < sum.size(); ++k)
          sum[k] += 0.5 * h * weight[i] * values[k];
      }
    }
  return sum;
}

TEST(Riemann, ConservesMassMomentumAndEnergyInEveryModel) {
  struct Case {
    RiemannSide left, right;
  };
  std::vector<Case> const cases{
      {air(1, 0, 1), air(0.125, 0, 0.1)},
      {side("argon", 1400, 1000, 0), side("argon", 1150, 500, 0)},
      {side("argon", 1150, 500, 300), side("argon", 1150, 500, -300)},
      {side("tin", 7600, 1000, 0), side("argon", 1150, 500, 0)},
      {side("nitromethane-products", 1600, 4000, 0), side("nitromethane", 1160, 300, 0)},
      {side("nitromethane-products", 1600, 4000, 0), side("water", 1000, 300, 0)},
      {side("water", 1100, 300, 0), side("ideal-gas", 100, 300, 0)},
  };
  int ran = 0;
  double worst = 0;
  for (auto const& [left, right] : cases) {
    SCOPED_TRACE(ran);
    RiemannSolution const solution(left, right);
    EXPECT_NEAR(solution.left_of_contact().P / solution.P(), 1, 1e-8);
    EXPECT_NEAR(solution.right_of_contact().P / solution.P(), 1, 1e-8);
    double const edge = 1.1 * std::max(-solution.left_wave().head, solution.right_wave().head);
    auto const found = content(solution, edge), f_left = fluxes(left), f_right = fluxes(right);
    auto const at_left = densities({left.state, left.u}), at_right = densities({right.state, right.u});
    for (std::size_t k = 0; k < found.size(); ++k) {
      double const expected = edge * (at_left[k] + at_right[k]) + f_left[k] - f_right[k];
      double const c = *left.state.sound_speed, rho = left.state.rho;
      double const scale = edge * std::array{rho, rho * c, rho * c * c}[k] + std::abs(expected);
      worst = std::max(worst, std::abs(found[k] - expected) / scale);
    }
    ++ran;
  }
  std::printf("%d tubes; largest violation of a balance %.1e\n", ran, worst);
  EXPECT_EQ(ran, 7);
  EXPECT_LT(worst, 1e-8);
}

TEST(Riemann, AgreesWithHugoniotsAndIsentropes) {
  // Equal halves that collide: each is shocked as by a piston.
  for (auto const* name : {"nitromethane-products", "argon", "water"}) {
    SCOPED_TRACE(name);
    double const v = 400;
    auto const left = side(name, 1200, 600, v), right = side(name, 1200, 600, -v);
    RiemannSolution const solution(left, right);
    auto const shock = Hugoniot(left.fluid, left.state).from_piston(v);
    EXPECT_NEAR(solution.u(), 0, 1e-6);
    EXPECT_NEAR(solution.P() / shock.behind.P, 1, 1e-9);
    EXPECT_NEAR(solution.right_wave().head / (shock.v_S - v), 1, 1e-8);
    // Parting ones: each is rarefied along its isentrope.
    RiemannSolution const parting(side(name, 1200, 600, -20), side(name, 1200, 600, 20));
    auto const state = Isentrope(left.fluid, left.state).at_pressure(parting.P());
    EXPECT_NEAR(Isentrope(left.fluid, left.state).velocity_change(state.rho, 1200), 20, 1e-7);
    EXPECT_NEAR(parting.left_of_contact().s / left.state.s, 1, 1e-10);
  }
}

TEST(Riemann, RefusesAVacuum) {
  // An ideal gas follows up to 2 c/(gamma - 1) on each side.
  double const escape = 2 * std::sqrt(1.4 * 0.4) / 0.4;
  EXPECT_NO_THROW(RiemannSolution(air(1, -0.95 * escape, 0.4), air(1, 0.95 * escape, 0.4)));
  EXPECT_THROW(RiemannSolution(air(1, -1.01 * escape, 0.4), air(1, 1.01 * escape, 0.4)), PhysicsError);
  EXPECT_THROW(RiemannSolution(side("tin", 7775, 300, -2000), side("tin", 7775, 300, 2000)), PhysicsError);
  EXPECT_THROW(RiemannSolution(air(1, double(NAN), 1), air(1, 0, 1)), InputError);
}

} // namespace
} // namespace mesobridge::fitting::test
