#pragma once
#include "fitting/eos/mixture.hpp" // the class itself

// How a Mixture finds its equilibrium: Newton's method, and the search where that fails.

namespace mesobridge::fitting {

template <EquationOfState Reactant, EquationOfState Product>
template <class E>
MixtureState Mixture<Reactant, Product>::pure(E const& eos, double rho, double e) const {
  double const T = eos.temperature(e, rho);
  auto const isochore = eos.isochore(rho);
  return {.split = {T, 0},
          .rho_reactant = rho,
          .rho_product = rho,
          .T = T,
          .P = isochore.pressure(T),
          .s = isochore.entropy(T),
          .c_v = isochore.heat_capacity(T),
          .sound_speed_squared = mesobridge::fitting::sound_speed_squared(isochore, T)};
}

template <EquationOfState Reactant, EquationOfState Product>
MixtureState Mixture<Reactant, Product>::state_of(Problem const& p, Parts const& at, double r) const {
  auto const& [lambda, share, T, reactant, product] = at;
  // How the split follows T and the density of the whole.
  double const r_T = -at.gap_T() / at.gap_r(), r_rho = (reactant.rho_P_rho - product.rho_P_rho) / at.gap_r();
  double const P = (1 - share) * reactant.P + share * product.P;
  double const c_v = at.energy_T() + at.energy_r() * r_T;
  double const P_T = reactant.P_T - share * reactant.rho_P_rho * r_T;
  double const P_log_rho = reactant.rho_P_rho * (1 - share * r_rho);
  double const e_log_rho = (1 - lambda) * reactant.e_log_rho * (1 - share * r_rho) +
                           lambda * product.e_log_rho * (1 + (1 - share) * r_rho);
  return {.split = {T, r},
          .rho_reactant = reactant.rho,
          .rho_product = product.rho,
          .T = T,
          .P = P,
          .s = (1 - lambda) * reactant_.isochore(reactant.rho).entropy(T) +
               lambda * product_.isochore(product.rho).entropy(T),
          .c_v = c_v,
          .sound_speed_squared = (P_log_rho + P_T / c_v * (P / p.rho - e_log_rho)) / p.rho};
}

template <EquationOfState Reactant, EquationOfState Product>
std::optional<MixtureState> Mixture<Reactant, Product>::newton_steps(Problem const& p,
                                                                     MixtureSplit split) const {
  // The error after a step is of second order.
  constexpr double last_step = 1e-7, longest_step = 0.5;
  constexpr int most_steps = 40;
  bool converged = false;
  for (int iteration = 0; iteration < most_steps && split.T > 0; ++iteration) {
    Parts const at = parts(p, split);
    double const gap_r = at.gap_r(), inverse = 1 / gap_r, energy_r = at.energy_r();
    double const r_T = -at.gap_T() * inverse, c_v = at.energy_T() + energy_r * r_T;
    if (!(at.stable() && c_v > 0))
      return std::nullopt;
    if (converged)
      return state_of(p, at, split.log_density_ratio);
    double const r_gap = -at.pressure_gap() * inverse;
    double const dT = (p.e - at.energy() - energy_r * r_gap) / c_v, dr = r_gap + r_T * dT;
    double const longest = std::max(std::abs(dT) / split.T, std::abs(dr));
    if (!(longest < std::numeric_limits<double>::infinity()))
      return std::nullopt;
    double const fraction = longest > longest_step ? longest_step / longest : 1;
    split.T += fraction * dT;
    split.log_density_ratio += fraction * dr;
    converged = longest < last_step;
  }
  return std::nullopt;
}

template <EquationOfState Reactant, EquationOfState Product>
std::optional<MixtureState> Mixture<Reactant, Product>::newton(Problem const& p,
                                                               MixtureSplit const& split) const {
  try {
    return newton_steps(p, split);
  } catch (PhysicsError const&) {
    return std::nullopt; // a step led out of a model
  }
}

/// Beyond the highest density of a part its pressure counts as infinite; outside a model there is no value.
template <EquationOfState Reactant, EquationOfState Product>
auto Mixture<Reactant, Product>::gap(Problem const& p, MixtureSplit const& split) const -> Gap {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  auto const d = densities(p, split.log_density_ratio);
  bool const reactant_full = d.reactant >= reactant_rho_max_, product_full = d.product >= product_rho_max_;
  if (reactant_full != product_full)
    return {reactant_full ? -infinity : infinity, true};
  try {
    Parts const at = parts(p, split);
    return {at.pressure_gap(), at.reactant.rho_P_rho > 0};
  } catch (PhysicsError const&) {
    return {std::numeric_limits<double>::quiet_NaN(), true};
  }
}

template <EquationOfState Reactant, EquationOfState Product>
auto Mixture<Reactant, Product>::balanced_between(Problem const& p, double T, double r_below,
                                                  double r_above) const -> std::optional<Balanced> {
  constexpr double width = 1e-9; // Newton's method does the rest
  while (r_above - r_below > width) {
    double const r = 0.5 * (r_below + r_above);
    (gap(p, {T, r}).value < 0 ? r_below : r_above) = r;
  }
  MixtureSplit const split{T, r_above};
  // A part at the end of its model is no balance.
  constexpr double balance = 1e-6;
  try {
    Parts const at = parts(p, split);
    bool const is_balance = at.stable() && std::abs(at.pressure_gap()) < balance * at.gap_r();
    return is_balance ? std::optional(Balanced{split, at.energy()}) : std::nullopt;
  } catch (PhysicsError const&) {
    return std::nullopt;
  }
}

template <EquationOfState Reactant, EquationOfState Product>
auto Mixture<Reactant, Product>::balanced(Problem const& p, double T) const -> std::optional<Balanced> {
  // ln(rho_1/rho_0), from traces of thin gas beside a condensed reactant to a reactant that is thin itself.
  constexpr double first = -45, last = 18, step = 0.5;
  double before = std::numeric_limits<double>::quiet_NaN();
  for (double r = first; r <= last; r += step) {
    auto const here = gap(p, {T, r});
    if (before < 0 && here.value >= 0)
      if (auto const found = balanced_between(p, T, r - step, r))
        return found;
    if (!here.reactant_stable)
      return std::nullopt;
    before = here.value;
  }
  return std::nullopt;
}

/// The solution between two balances whose energies lie below and above p.e. Nothing if the energy jumps.
template <EquationOfState Reactant, EquationOfState Product>
std::optional<MixtureState> Mixture<Reactant, Product>::between(Problem const& p, Balanced below,
                                                                Balanced above) const {
  for (auto const& end : {above, below})
    if (auto const found = newton(p, end.split))
      return found;
  constexpr double narrowest = 1e-12;
  while (above.split.T - below.split.T > narrowest * above.split.T) {
    auto const middle = balanced(p, std::sqrt(above.split.T * below.split.T));
    if (!middle)
      return std::nullopt;
    if (auto const found = newton(p, middle->split))
      return found;
    (middle->energy < p.e ? below : above) = *middle;
  }
  return std::nullopt;
}

/// The solution between a balance and a temperature at which there is none, found by approaching the edge.
template <EquationOfState Reactant, EquationOfState Product>
std::optional<MixtureState> Mixture<Reactant, Product>::at_edge(Problem const& p, Balanced inside,
                                                                double T_outside) const {
  bool const low = inside.energy < p.e;
  constexpr int halvings = 30;
  for (int i = 0; i < halvings; ++i) {
    auto const middle = balanced(p, 0.5 * (inside.split.T + T_outside));
    if (!middle)
      T_outside = 0.5 * (inside.split.T + T_outside);
    else if ((middle->energy < p.e) == low)
      inside = *middle;
    else
      return low ? between(p, inside, *middle) : between(p, *middle, inside);
  }
  return newton(p, inside.split);
}

template <EquationOfState Reactant, EquationOfState Product>
MixtureState Mixture<Reactant, Product>::search(Problem const& p) const {
  // K, or epsilon/k_B for reduced models
  constexpr double coldest = 1e-3, hottest = 1e6, ratio = 1.25;
  std::optional<Balanced> before;
  std::optional<MixtureState> found;
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  for (double T = coldest; T <= std::min(hottest, T_max_) && !found; T *= ratio) {
    auto const here = balanced(p, T);
    if (here) {
      lowest = std::min(lowest, here->energy);
      highest = std::max(highest, here->energy);
    }
    if (here && before && before->energy < p.e && here->energy >= p.e)
      found = between(p, *before, *here);
    else if (here && !before && here->energy >= p.e && T > coldest)
      found = at_edge(p, *here, T / ratio);
    else if (!here && before && before->energy < p.e)
      found = at_edge(p, *before, T);
    before = here;
  }
  if (found)
    return *found;
  if (!(lowest <= highest))
    refuse(p, "the parts balance at no temperature");
  if (p.e <= lowest)
    refuse(p, fmt::format("the energy lies below {}, that of the coldest parts that balance", lowest));
  if (p.e >= highest)
    refuse(p,
           fmt::format("the parts balance up to the energy {} only; hotter products need a higher pressure "
                       "to balance the reactant",
                       highest));
  refuse(p, fmt::format("the energy lies in a gap of those that balanced parts have, {} to {}", lowest,
                        highest));
}

} // namespace mesobridge::fitting
