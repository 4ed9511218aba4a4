#include "fitting/znd.hpp"
#include "fitting/quadrature.hpp"
#include "fitting/root.hpp"
#include <algorithm>

namespace mesobridge::fitting {
namespace {

// The Chapman-Jouguet velocity is known to round-off; one asked for by its printed digits is not.
constexpr double speed_tolerance = 1e-9;

/// Throws PhysicsError.
double require_detonation(ReactiveFluid const& fluid, double D) {
  double const D_CJ = fluid.crussard().chapman_jouguet().v_S;
  if (!(D >= D_CJ * (1 - speed_tolerance)))
    throw PhysicsError(fmt::format("no steady detonation runs at D = {}: the slowest, that of Chapman and "
                                   "Jouguet, runs at {}",
                                   D, D_CJ));
  return D;
}

} // namespace

ReactionZone::ReactionZone(ReactiveFluid fluid, double D)
    : fluid_(std::move(fluid)), D_(require_detonation(fluid_, D)),
      von_neumann_(fluid_.hugoniot().from_speed(D)) {}

ReactionZone::Trial ReactionZone::trial(double lambda, double rho,
                                        std::optional<MixtureSplit> const& split) const {
  auto const& rest = fluid_.at_rest;
  double const flux = rest.rho * D_, dv = 1 / rest.rho - 1 / rho, P = rest.P + flux * flux * dv;
  // Along the line de = -P dv, so that c^2 tells how the mixture's pressure follows.
  double const e = rest.e + 0.5 * (P + rest.P) * dv;
  auto const state = fluid_.exploded(rho, e, lambda, split);
  double const w = flow(rho);
  return {{rho, state}, state.P - P, state.sound_speed_squared - w * w};
}

std::optional<ZoneState> ReactionZone::newton(double lambda, ZoneState const& guess) const {
  constexpr int most_steps = 30;
  constexpr double last_step = 1e-9, longest_step = 0.1;
  double rho = guess.rho;
  auto split = guess.state.split;
  bool converged = false;
  for (int step = 0; step <= most_steps; ++step) {
    auto const here = trial(lambda, rho, split);
    if (!(here.slope > 0))
      return std::nullopt;
    if (converged)
      return here.at;
    double const change = std::clamp(-here.excess / here.slope / rho, -longest_step, longest_step);
    rho *= 1 + change;
    split = here.at.state.split;
    converged = std::abs(change) < last_step;
  }
  return std::nullopt;
}

/// From the shocked density down to where the flow would be sonic, or up where the reaction takes volume.
ZoneState ReactionZone::search(double lambda) const {
  double const first = von_neumann_.behind.rho;
  std::optional<MixtureSplit> split;
  auto const at = [&](double rho) {
    auto const found = trial(lambda, rho, split);
    split = found.at.state.split;
    return found;
  };
  constexpr double step_ratio = 1.02, widest = 4;
  if (at(first).excess < 0) {
    double const limit = std::min(widest * first, fluid_.mixture.reactant().domain().rho_max);
    if (auto const rho = first_rising_zero([&](double x) { return at(x).excess; }, first, limit, step_ratio))
      return at(*rho).at;
    throw PhysicsError(
        fmt::format("at D = {} no state of progress {} lies on the Rayleigh line", D_, lambda));
  }
  auto const sonic =
      first_rising_zero([&](double rho) { return -at(rho).slope; }, first, fluid_.at_rest.rho, step_ratio);
  double const last = sonic.value_or(fluid_.at_rest.rho);
  double const lowest = at(last).excess;
  if (!(lowest < 0))
    throw PhysicsError(
        fmt::format("the flow behind a front of D = {} becomes sonic before the reaction has come to "
                    "{}: the detonation is a pathological one, which runs faster (heat is released faster "
                    "than the molecules' volume, or their number, falls)",
                    D_, lambda));
  auto const rho =
      bracketed_zero([&](double x) { return at(x).excess; }, last, lowest, first, at(first).excess);
  return at(rho).at;
}

ZoneState ReactionZone::at(double lambda, std::optional<ZoneState> const& guess) const {
  require(lambda >= 0 && lambda < 1, "progress", lambda, "must lie in 0 <= lambda < 1");
  if (lambda == 0)
    return trial(0, von_neumann_.behind.rho, std::nullopt).at;
  if (guess)
    try {
      if (auto const found = newton(lambda, *guess))
        return *found;
    } catch (PhysicsError const&) { // a step led out of a model
    }
  return search(lambda);
}

std::vector<ZonePoint> reaction_profile(ReactionZone const& zone, Kinetics const& kinetics,
                                        std::vector<double> const& progress) {
  kinetics.validate();
  auto near = zone.at(0);
  auto const at = [&](double lambda) -> ZoneState const& { return near = zone.at(lambda, near); };
  auto const duration = [&](double lambda) {
    auto const& here = at(lambda);
    return 1 / kinetics.positive_rate(lambda, here.rho, here.state.T);
  };
  auto const length = [&](double lambda) {
    auto const& here = at(lambda);
    return zone.flow(here.rho) / kinetics.positive_rate(lambda, here.rho, here.state.T);
  };
  std::vector<ZonePoint> points;
  double before = 0, x = 0, t = 0;
  for (double const lambda : progress) {
    t += integral(duration, before, lambda);
    x += integral(length, before, lambda);
    before = lambda;
    auto const& here = at(lambda);
    points.push_back({lambda, x, t, here.rho, zone.velocity(here.rho), here.state});
  }
  return points;
}

ZoneExtent zone_extent(std::vector<ZonePoint> const& points) {
  auto const at = [&](double lambda) -> ZonePoint const& {
    return *std::ranges::min_element(points, {}, [&](auto const& p) { return std::abs(p.lambda - lambda); });
  };
  auto const &begin = at(zone_begin), &end = at(zone_end);
  return {end.x - begin.x, end.t - begin.t};
}

std::vector<double> progress_to_draw(double last) {
  require(last > zone_end && last < 1, "last progress of the profile", last,
          fmt::format("must lie between {} and 1", zone_end));
  std::vector<double> progress;
  constexpr int parts = 200;
  for (int i = 0; i <= std::lround(zone_end * parts); ++i)
    progress.push_back(double(i) / parts);
  constexpr double ratio = 0.9; // of what is left, from there on
  for (double left = ratio * (1 - zone_end); left > (1 - last) / ratio; left *= ratio)
    progress.push_back(1 - left);
  progress.push_back(last);
  return progress;
}

} // namespace mesobridge::fitting
