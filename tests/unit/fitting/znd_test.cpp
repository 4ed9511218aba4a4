#include "fitting/induction.hpp"
#include "fitting/znd.hpp"
#include "unit/fitting/built_in.hpp"
#include <gtest/gtest.h>

// Numbers of an independent code: nitromethane (HZ) to its products (JWL) from 1104 kg/m^3, 300 K.

namespace mesobridge::fitting::test {
namespace {

constexpr double q_nitromethane = 4.78e-19 / (61.04 * atomic_mass);

ReactiveFluid explosive(double q = q_nitromethane, VolumeLaw law = VolumeLaw::additive_volume) {
  auto const rest = Fluid(nitromethane()).at_temperature(1104, 300);
  return {nitromethane(), products(), law, rest, q};
}

Kinetics kinetics(double Z, NeighbourSum sum) {
  return {.arrhenius = {.Z = Z, .E_a = 3e-19}, .sum = sum, .rho_bar = 1104, .self_weight = 2.54648 / 15.625};
}

double zone_length(std::vector<ZonePoint> const& points) {
  return points[1].x - points[0].x;
}

TEST(Znd, TheNeumannStateIsThatOfAnIndependentSolver) {
  auto const fluid = explosive();
  auto const cj = fluid.crussard().chapman_jouguet();
  ReactionZone const zone(fluid, cj.v_S);
  auto const& spike = zone.von_neumann();
  EXPECT_NEAR(zone.D(), 6766.8, 0.05);
  EXPECT_NEAR(spike.behind.P, 21.163e9, 0.5e6);
  EXPECT_NEAR(spike.behind.rho, 1902.0, 0.05);
  EXPECT_NEAR(spike.behind.T, 2957.6, 0.05);
  EXPECT_NEAR(spike.v_P, 2839.0, 0.05);
  auto const first = zone.at(0), last = zone.at(1 - 1e-7);
  EXPECT_NEAR(first.state.P / spike.behind.P, 1, 1e-12);
  EXPECT_NEAR(last.state.P / cj.behind.P, 1, 1e-3); // as the square root of what is left
  struct Known {
    double lambda, T, P;
  };
  int cases = 0;
  std::optional<ZoneState> near = first;
  for (auto const& k :
       {Known{0.1, 3399.8, 21.156e9}, Known{0.25, 3893.6, 21.035e9}, Known{0.5, 4440.3, 20.549e9},
        Known{0.75, 4779.1, 19.529e9}, Known{0.9, 4903.4, 18.261e9}}) {
    auto const alone = zone.at(k.lambda);
    near = zone.at(k.lambda, near);
    EXPECT_NEAR(alone.state.T, k.T, 0.06);
    EXPECT_NEAR(alone.state.P, k.P, 0.6e6);
    EXPECT_NEAR(near->state.P / alone.state.P, 1, 1e-11);
    // The state obeys the conservation laws across the zone, and the flow is subsonic.
    double const w = zone.flow(alone.rho), w_0 = zone.D(), dv = 1 / 1104.0 - 1 / alone.rho;
    EXPECT_NEAR((alone.state.P + alone.rho * w * w) / (fluid.at_rest.P + 1104 * w_0 * w_0), 1, 1e-12);
    EXPECT_NEAR(alone.state.e,
                fluid.at_rest.e + fluid.q * k.lambda + 0.5 * (alone.state.P + fluid.at_rest.P) * dv, 1e-2);
    EXPECT_LT(w * w, alone.state.sound_speed_squared);
    ++cases;
  }
  EXPECT_EQ(cases, 5);
}

TEST(Znd, TheLengthsOfTheZoneAreThoseOfAnIndependentSolver) {
  struct Known {
    double q;
    NeighbourSum sum;
    double nm; // at Z = 1e15
  };
  int cases = 0;
  for (auto const& k :
       {Known{q_nitromethane, NeighbourSum::density, 12.25},
        Known{q_nitromethane, NeighbourSum::density_minus_self, 13.70},
        Known{q_nitromethane, NeighbourSum::unit, 18.90}, Known{3.52e6, NeighbourSum::density, 19.4},
        Known{3.52e6, NeighbourSum::density_minus_self, 21.7}, Known{3.52e6, NeighbourSum::unit, 29.7}}) {
    auto const fluid = explosive(k.q);
    ReactionZone const zone(fluid, fluid.crussard().chapman_jouguet().v_S);
    for (double const Z : {5e14, 1e15, 2e15, 4e15}) {
      auto const points = reaction_profile(zone, kinetics(Z, k.sum), {zone_begin, zone_end});
      EXPECT_NEAR(1e9 * zone_length(points) * Z / 1e15, k.nm, k.nm < 19 ? 0.006 : 0.06);
      ++cases;
    }
  }
  EXPECT_EQ(cases, 24);
}

TEST(Znd, TimesAndLengthsFollowTheFlow) {
  auto const fluid = explosive();
  ReactionZone const zone(fluid, fluid.crussard().chapman_jouguet().v_S);
  auto const law = kinetics(1e15, NeighbourSum::density);
  auto const ends = reaction_profile(zone, law, {zone_begin, zone_end});
  EXPECT_NEAR(1e12 * (ends[1].t - ends[0].t), 2.79, 0.006);
  auto const points = reaction_profile(zone, law, progress_to_draw(0.999));
  ASSERT_GT(points.size(), 200u);
  EXPECT_EQ(points.front().x, 0);
  EXPECT_EQ(points.back().lambda, 0.999);
  int compared = 0;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    auto const &a = points[i - 1], &b = points[i], &c = points[i + 1];
    ASSERT_GT(b.x, a.x);
    // dlambda/dt and dx/dt by differences in lambda, whose steps are equal up to the end of the zone
    if (c.lambda > 0.8)
      break;
    double const t_slope = (c.t - a.t) / (c.lambda - a.lambda);
    EXPECT_NEAR(t_slope * law.rate(b.lambda, b.rho, b.state.T), 1, 1e-3);
    EXPECT_NEAR((c.x - a.x) / (c.t - a.t) / (zone.D() - b.u), 1, 1e-3);
    ++compared;
  }
  EXPECT_GT(compared, 150);
}

TEST(Znd, ThePapersVolumesChangeTheZoneByHalfAPercent) {
  auto const length = [](VolumeLaw law) {
    auto const fluid = explosive(q_nitromethane, law);
    ReactionZone const zone(fluid, fluid.crussard().chapman_jouguet().v_S);
    return zone_length(reaction_profile(zone, kinetics(1e15, NeighbourSum::density), {zone_begin, zone_end}));
  };
  double const change = length(VolumeLaw::paper) / length(VolumeLaw::additive_volume) - 1;
  EXPECT_GT(std::abs(change), 1e-3);
  EXPECT_LT(std::abs(change), 1e-2);
}

TEST(Znd, AStateIsBalancedByThePureModels) {
  int cases = 0;
  for (auto const law : {VolumeLaw::additive_volume, VolumeLaw::paper}) {
    auto const fluid = explosive(q_nitromethane, law);
    ReactionZone const zone(fluid, 7000);
    for (double const lambda : {0.1, 0.6, 0.97}) {
      auto const [rho, state] = zone.at(lambda);
      double const rho_0 = state.rho_reactant, rho_1 = state.rho_product, left = 1 - lambda;
      EXPECT_NEAR(rho * (left / rho_0 + lambda / rho_1), 1, law == VolumeLaw::paper ? 0.05 : 1e-12);
      EXPECT_NEAR((left * rho_0 + lambda * rho_1) / rho, 1, law == VolumeLaw::paper ? 1e-12 : 0.05);
      double const P = fluid.at_rest.P + 1104 * 7000 * zone.velocity(rho); // momentum
      EXPECT_NEAR(nitromethane().isochore(rho_0).pressure(state.T) / P, 1, 1e-10);
      EXPECT_NEAR(products().isochore(rho_1).pressure(state.T) / P, 1, 1e-10);
      double const e = left * nitromethane().isochore(rho_0).energy(state.T) +
                       lambda * products().isochore(rho_1).energy(state.T);
      double const by_shock =
          fluid.at_rest.e + lambda * fluid.q + 0.5 * (P + fluid.at_rest.P) * (1 / 1104.0 - 1 / rho);
      EXPECT_NEAR(e / by_shock, 1, 1e-10);
      ++cases;
    }
  }
  EXPECT_EQ(cases, 6);
}

TEST(Znd, FirstOrderOfIdealGasesIsExact) {
  // One gas before and after, gamma = 1.4: the strong detonation's state of progress lambda is a closed form,
  //   w = (gamma M^2 + 1 -+ sqrt((M^2 - 1)^2 - 2 (gamma^2 - 1) lambda q M^2/(gamma R T_0)))/((gamma + 1) M^2)
  //   D.
  IdealGas const gas = IdealGas::from_gamma(5e-26, 1.4);
  double const R = k_B / 5e-26, T_0 = 300, rho_0 = 1.2, q = 2e6, gamma = 1.4,
               c_0 = std::sqrt(gamma * R * T_0);
  ReactiveFluid const fluid(gas, gas, VolumeLaw::additive_volume, Fluid(gas).at_temperature(rho_0, T_0), q);
  double const H = (gamma * gamma - 1) * q / (2 * gamma * R * T_0);
  double const M_CJ = std::sqrt(H + 1) + std::sqrt(H), D_CJ = M_CJ * c_0;
  EXPECT_NEAR(fluid.crussard().chapman_jouguet().v_S / D_CJ, 1, 1e-9);
  int cases = 0;
  for (double const overdrive : {1.0000001, 1.1, 1.5}) {
    double const D = overdrive * D_CJ, M_2 = D * D / (c_0 * c_0);
    ReactionZone const zone(fluid, D);
    auto const flow = [&](double lambda) {
      return (gamma * M_2 + 1 - std::sqrt((M_2 - 1) * (M_2 - 1) - 4 * H * lambda * M_2)) /
             ((gamma + 1) * M_2) * D;
    };
    for (double const lambda : {0.0, 0.3, 0.9, 0.99}) {
      EXPECT_NEAR(zone.flow(zone.at(lambda).rho) / flow(lambda), 1, 1e-7) << overdrive << " " << lambda;
      ++cases;
    }
    // Without activation energy the progress of first order is 1 - exp(-Z t).
    Kinetics const law{.arrhenius = {.Z = 1e9, .E_a = 0}, .order = Kinetics::Order::first};
    for (auto const& point : reaction_profile(zone, law, {0.1, 0.5, 0.98}))
      EXPECT_NEAR(point.t * 1e9, -std::log1p(-point.lambda), 1e-9);
  }
  EXPECT_EQ(cases, 12);
}

TEST(Znd, RefusesSlowAndPathologicalDetonations) {
  auto const fluid = explosive();
  EXPECT_THROW(ReactionZone(fluid, 6700), PhysicsError);
  // Half as many molecules after the reaction: the heat is out before their number has fallen. The flow of
  // the Chapman-Jouguet velocity of the products chokes on the way.
  IdealGas const before(3e-26, 5), after(6e-26, 10);
  auto const rest = Fluid(before).at_temperature(1.2, 300);
  ReactiveFluid const falling(before, after, VolumeLaw::additive_volume, rest, 1e6);
  ReactionZone const zone(falling, falling.crussard().chapman_jouguet().v_S);
  std::optional<ZoneState> near = zone.at(0);
  double choked = 0;
  std::string why;
  for (int i = 1; i < 100 && why.empty(); ++i)
    try {
      near = zone.at(0.01 * i, near);
    } catch (PhysicsError const& error) {
      choked = 0.01 * i;
      why = error.what();
    }
  EXPECT_GT(choked, 0.1);
  EXPECT_LT(choked, 1);
  EXPECT_NE(why.find("pathological"), std::string::npos) << why;
}

/// The time until nine tenths have reacted, by Runge and Kutta's method in time with small steps.
double explosion_time(ReactiveFluid const& fluid, EosState const& shocked, Kinetics const& law) {
  auto const rate = [&](double lambda) {
    auto const state =
        fluid.mixture.state(lambda, shocked.rho, shocked.e + fluid.q * lambda, MixtureSplit{2500, 0});
    return law.rate(lambda, shocked.rho, state.T);
  };
  double lambda = 0, t = 0, dt = 0;
  while (lambda < ThermalExplosion::exploded) {
    dt = 1e-3 / rate(lambda);
    double const k_1 = rate(lambda), k_2 = rate(lambda + 0.5 * dt * k_1), k_3 = rate(lambda + 0.5 * dt * k_2),
                 k_4 = rate(lambda + dt * k_3);
    double const change = dt * (k_1 + 2 * k_2 + 2 * k_3 + k_4) / 6;
    if (lambda + change > ThermalExplosion::exploded)
      return t + dt * (ThermalExplosion::exploded - lambda) / change;
    lambda += change, t += dt;
  }
  return t;
}

TEST(Induction, IsThatOfIndependentSolvers) {
  struct Known {
    NeighbourSum sum;
    double ps;
  };
  int cases = 0;
  for (auto const& k : {Known{NeighbourSum::density, 189}, Known{NeighbourSum::density_minus_self, 210},
                        Known{NeighbourSum::unit, 303}}) {
    auto const law = kinetics(1e15, k.sum);
    auto const fluid = explosive();
    auto const found = shock_to_detonation(fluid, 1764, law);
    EXPECT_NEAR(1e12 * found.explosion.time / k.ps, 1, 4e-3);
    EXPECT_NEAR(found.explosion.time / explosion_time(fluid, found.shock.behind, law), 1, 1e-5);
    EXPECT_NEAR(found.shock.v_S, 4683.9, 0.06);
    EXPECT_NEAR(found.shock.behind.T, 1278.8, 0.06);
    EXPECT_NEAR(found.super_detonation, 9102, 0.6);
    if (k.sum == NeighbourSum::density) {
      EXPECT_NEAR(1e12 * found.explosion.frank_kamenetskii, 289, 0.6);
      EXPECT_NEAR(1e12 * found.time / 314, 1, 4e-3);
      EXPECT_NEAR(1e9 * found.place / 1471, 1, 4e-3);
    }
    ++cases;
  }
  EXPECT_EQ(cases, 3);
}

TEST(Induction, OfABimolecularReactionWithoutHeatIsExact) {
  IdealGas const gas(5e-26);
  auto const rest = Fluid(gas).at_temperature(1.2, 300);
  ReactiveFluid const fluid(gas, gas, VolumeLaw::additive_volume, rest, 0);
  // dlambda/dt = Z (1 - lambda)^2: 1/(1 - lambda) = 1 + Z t
  Kinetics const law{.arrhenius = {.Z = 2e9, .E_a = 0}, .sum = NeighbourSum::unit};
  EXPECT_NEAR(thermal_explosion(fluid, rest.rho, rest.e, law).time, 9 / 2e9, 1e-18);
  Kinetics const first{.arrhenius = {.Z = 2e9, .E_a = 0}, .order = Kinetics::Order::first};
  EXPECT_NEAR(thermal_explosion(fluid, rest.rho, rest.e, first).time, std::log(10) / 2e9, 1e-18);
  Kinetics const frozen{.arrhenius = {.Z = 2e9, .E_a = 1e-15}};
  EXPECT_THROW(thermal_explosion(fluid, rest.rho, rest.e, frozen), PhysicsError);
}

TEST(Induction, EndsInTheStateOfTheCrussardCurve) {
  int cases = 0;
  for (auto const law : {VolumeLaw::additive_volume, VolumeLaw::paper}) {
    auto const fluid = explosive(q_nitromethane, law);
    auto const end = fluid.exploded(1104, fluid.at_rest.e, 1);
    auto const known = fluid.crussard().constant_volume_state();
    EXPECT_NEAR(end.T / known.T, 1, 1e-12);
    EXPECT_NEAR(end.P / known.P, 1, 1e-12);
    ++cases;
  }
  EXPECT_EQ(cases, 2);
}

} // namespace
} // namespace mesobridge::fitting::test
