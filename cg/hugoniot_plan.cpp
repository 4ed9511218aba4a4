#include "cg/hugoniot_plan.hpp"
#include "md/error.hpp"
#include <algorithm>
#include <array>
#include <cmath>

namespace mesobridge::cg {

namespace {

/// Temperatures of the first states, in units of the estimate, and of further ones, in units of the solution
/// so far.
constexpr std::array first_temperatures{0.87, 1.0, 1.13};
constexpr std::array further_temperatures{0.94, 1.06};
/// States that are further away than this part of the solution's temperature do not count.
constexpr double widest = 0.3;
constexpr int most_states = 9;

using Points = std::vector<MetalPoint>;

/// States to be sampled have round numbers, so that a plan made anew asks for the same ones: a static energy
/// comes with other last digits when another was computed before it.
double round_density(double rho) {
  constexpr double unit = 0.1; // kg/m^3
  return std::round(rho / unit) * unit;
}
double round_temperature(double T) {
  return std::round(T); // K
}

std::vector<md::MetalState> states_about(double rho, double T, std::span<double const> parts) {
  std::vector<md::MetalState> states;
  for (double part : parts)
    states.push_back({.rho = rho, .T = round_temperature(part * T)});
  return states;
}

Points at(std::span<MetalPoint const> known, md::MetalState state) {
  Points found;
  std::copy_if(known.begin(), known.end(), std::back_inserter(found),
               [&](auto const& p) { return p.state == state; });
  return found;
}

/// Those of the states that are not known yet are missing; returns the points of the others.
Points known_or_missing(std::span<md::MetalState const> states, std::span<MetalPoint const> known,
                        std::vector<md::MetalState>& missing) {
  Points points;
  for (auto const& state : states) {
    auto const found = at(known, state);
    if (found.empty())
      missing.push_back(state);
    else
      points.push_back(found.front());
  }
  return points;
}

/// The density of zero pressure at T0, from three densities about its estimate, and about the result where
/// that lies outside of them (a liquid's does). Nothing while they are missing.
std::optional<Estimate> find_rho0(HugoniotRequest const& request, md::QuasiharmonicMetal& metal,
                                  std::span<MetalPoint const> known, std::vector<md::MetalState>& missing) {
  if (request.rho0)
    return Estimate{*request.rho0, 0, 0};
  constexpr double reach = 0.01;
  constexpr int rounds = 6;
  double centre = metal.zero_pressure_density(request.T0);
  for (int round = 0; round < rounds; ++round) {
    std::vector<md::MetalState> states;
    for (double part : {1 - reach, 1.0, 1 + reach})
      states.push_back({.rho = round_density(part * centre), .T = request.T0});
    auto const points = known_or_missing(states, known, missing);
    if (!missing.empty())
      return std::nullopt;
    auto const found = zero_pressure_density(points);
    if (std::abs(found.mean / centre - 1) < reach)
      return found;
    centre = found.mean;
  }
  throw PhysicsError(
      fmt::format("no density of zero pressure was found at {} K (the last estimate was {:.1f} kg/m^3): "
                  "give --rho0",
                  request.T0, centre));
}

struct Solution {
  std::optional<HugoniotPoint> point;
  bool enclosed = false; ///< by the temperatures of the states that it was found from
  std::string trouble;
};

/// The solution from states of one phase, the far ones left out.
Solution solve(MetalPoint const& initial, Points points, Phase phase) {
  std::erase_if(points, [&](auto const& p) { return p.phase != phase; });
  if (points.size() < 2)
    return {.point = {},
            .enclosed = false,
            .trouble = fmt::format("{} states are {}", points.size(), name_of(phase))};
  try {
    auto point = solve_hugoniot(initial, points);
    auto near = points;
    std::erase_if(near, [&](auto const& p) { return std::abs(p.state.T / point.T.mean - 1) > widest; });
    if (near.size() >= 2 && near.size() < points.size())
      point = solve_hugoniot(initial, near);
    auto const colder = [](auto const& a, auto const& b) { return a.state.T < b.state.T; };
    auto const [low, high] = std::minmax_element(points.begin(), points.end(), colder);
    return {.point = point,
            .enclosed = low->state.T < point.T.mean && point.T.mean < high->state.T,
            .trouble = ""};
  } catch (PhysicsError const& error) {
    return {.point = {}, .enclosed = false, .trouble = error.what()};
  }
}

/// One compression: its point, or what to sample for it, or why there is none.
void solve_compression(MetalPoint const& initial, double rho, md::QuasiharmonicMetal& metal, Phase start,
                       std::span<MetalPoint const> known, HugoniotCurve& curve) {
  auto const first = states_about(rho, metal.shocked(initial.state, rho).T, first_temperatures);
  std::vector<md::MetalState> missing;
  known_or_missing(first, known, missing);
  curve.missing.insert(curve.missing.end(), missing.begin(), missing.end());
  if (!missing.empty())
    return;
  Points points;
  std::copy_if(known.begin(), known.end(), std::back_inserter(points),
               [&](auto const& p) { return p.state.rho == rho; });
  auto const other = start == Phase::solid ? Phase::liquid : Phase::solid;
  auto best = solve(initial, points, start);
  if (!best.enclosed)
    if (auto const second = solve(initial, points, other); second.enclosed || !best.point)
      best = second.point ? second : best;
  if (best.enclosed)
    return curve.points.push_back(*best.point);
  bool const hopeless = !best.point || int(points.size()) >= most_states || !(best.point->T.mean > 0);
  if (!hopeless) {
    missing.clear();
    known_or_missing(states_about(rho, best.point->T.mean, further_temperatures), known, missing);
    curve.missing.insert(curve.missing.end(), missing.begin(), missing.end());
  }
  if (missing.empty())
    curve.unsolved.push_back(
        fmt::format("{:.1f} kg/m^3: {}", rho,
                    best.point ? "the states at its solution change their phase" : best.trouble));
}

std::vector<double> densities_of(HugoniotRequest const& request, md::QuasiharmonicMetal& metal,
                                 md::MetalState initial) {
  std::vector<double> densities;
  for (double compression : request.compressions)
    densities.push_back(round_density(compression * initial.rho));
  for (double v_P : request.v_P)
    densities.push_back(round_density(metal.compression(initial, v_P) * initial.rho));
  std::sort(densities.begin(), densities.end());
  return densities;
}

} // namespace

HugoniotCurve plan_hugoniot(HugoniotRequest const& request, md::QuasiharmonicMetal& metal, Phase start,
                            std::span<MetalPoint const> known) {
  HugoniotCurve curve;
  auto const rho0 = find_rho0(request, metal, known, curve.missing);
  if (!rho0)
    return curve;
  curve.rho0 = *rho0;
  md::MetalState const initial{.rho = request.rho0 ? *request.rho0 : round_density(rho0->mean),
                               .T = request.T0};
  curve.initial = initial;
  auto const found = known_or_missing(std::array{initial}, known, curve.missing);
  for (double rho : densities_of(request, metal, initial)) {
    if (!found.empty()) {
      solve_compression(found.front(), rho, metal, start, known, curve);
      continue;
    }
    // Sampled together with the initial state.
    auto const first = states_about(rho, metal.shocked(initial, rho).T, first_temperatures);
    known_or_missing(first, known, curve.missing);
  }
  return curve;
}

} // namespace mesobridge::cg
