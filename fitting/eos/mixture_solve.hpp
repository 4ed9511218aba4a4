#pragma once
#include "fitting/eos/mixture.hpp" // the class itself

// How a Mixture finds its equilibrium: Newton's method, and the search where that fails.

namespace mesobridge::fitting {

template <EquationOfState Reactant, EquationOfState Product>
template <class E>
MixtureState Mixture<Reactant, Product>::pure(E const& eos, Problem const& p) {
  EosState const at = p.given == Given::temperature ? fitting::state_from_temperature(eos, p.rho, p.value)
                      : p.given == Given::energy    ? fitting::state_from_energy(eos, p.rho, p.value)
                                                    : fitting::state_from_entropy(eos, p.rho, p.value);
  return {.split = {at.T, 0},
          .rho_reactant = p.rho,
          .rho_product = p.rho,
          .T = at.T,
          .P = at.P,
          .e = at.e,
          .s = at.s,
          .c_v = at.c_v,
          .sound_speed_squared = at.sound_speed_squared};
}

template <EquationOfState Reactant, EquationOfState Product>
MixtureState Mixture<Reactant, Product>::state_of(At const& at, double r) {
  return {.split = {at.T, r},
          .rho_reactant = at.reactant.rho,
          .rho_product = at.product.rho,
          .T = at.T,
          .P = at.pressure(),
          .e = at.energy(),
          .s = at.entropy(),
          .c_v = at.heat_capacity(),
          .sound_speed_squared = at.sound_speed_squared()};
}

template <EquationOfState Reactant, EquationOfState Product>
MixtureState Mixture<Reactant, Product>::solve(Problem const& p,
                                               std::optional<MixtureSplit> const& guess) const {
  validate(p);
  if (p.lambda == 0)
    return pure(reactant_, p);
  if (p.lambda == 1)
    return pure(product_, p);
  auto const found = guess ? newton(p, *guess) : std::nullopt;
  return found ? *found : search(p);
}

template <EquationOfState Reactant, EquationOfState Product>
MixtureState Mixture<Reactant, Product>::state_from_temperature(double lambda, double rho, double T) const {
  Problem const p{lambda, rho, T, Given::temperature};
  validate(p);
  if (lambda == 0)
    return pure(reactant_, p);
  if (lambda == 1)
    return pure(product_, p);
  auto const found = T > 0 ? balanced(p, T) : std::nullopt;
  if (!found)
    refuse(p, fmt::format("at temperature {} no densities of the parts balance", T));
  double r = found->split.log_density_ratio; // to 1e-9; two steps bring it to round-off
  for (int step = 0; step < 2; ++step) {
    auto const here = at(p, {T, r});
    r -= here.pressure_gap() / here.gap_r();
  }
  return state_of(at(p, {T, r}), r);
}

template <EquationOfState Reactant, EquationOfState Product>
std::optional<MixtureState> Mixture<Reactant, Product>::newton_steps(Problem const& p,
                                                                     MixtureSplit split) const {
  // The error after a step is of second order.
  constexpr double last_step = 1e-8, longest_step = 0.5;
  constexpr int most_steps = 40;
  bool converged = false;
  for (int iteration = 0; iteration < most_steps && split.T > 0; ++iteration) {
    At const here = at(p, split);
    bool const by_entropy = p.given == Given::entropy;
    auto const [dT, dr, slope] =
        here.step(p.value - value(p, here), by_entropy ? here.entropy_r() : here.energy_r(),
                  by_entropy ? here.entropy_T() : here.energy_T());
    if (!(stable(here) && slope > 0))
      return std::nullopt;
    if (converged)
      return here.heat_capacity() > 0 ? std::optional(state_of(here, split.log_density_ratio)) : std::nullopt;
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
  auto const d = mixture_densities(law_, p.lambda, p.rho, split.log_density_ratio);
  bool const reactant_full = d.reactant >= reactant_rho_max_, product_full = d.product >= product_rho_max_;
  if (reactant_full != product_full)
    return {reactant_full ? -infinity : infinity, true};
  try {
    At const here = at(p, split);
    return {here.pressure_gap(), here.reactant.rho_P_rho > 0};
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
    At const here = at(p, split);
    bool const is_balance = stable(here) && std::abs(here.pressure_gap()) < balance * here.gap_r();
    return is_balance ? std::optional(Balanced{split, value(p, here)}) : std::nullopt;
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

/// The solution between two balances whose values lie below and above the given one. Nothing if they jump.
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
    (middle->value < p.value ? below : above) = *middle;
  }
  return std::nullopt;
}

/// The solution between a balance and a temperature at which there is none, found by approaching the edge.
template <EquationOfState Reactant, EquationOfState Product>
std::optional<MixtureState> Mixture<Reactant, Product>::at_edge(Problem const& p, Balanced inside,
                                                                double T_outside) const {
  bool const low = inside.value < p.value;
  constexpr int halvings = 30;
  for (int i = 0; i < halvings; ++i) {
    auto const middle = balanced(p, 0.5 * (inside.split.T + T_outside));
    if (!middle)
      T_outside = 0.5 * (inside.split.T + T_outside);
    else if ((middle->value < p.value) == low)
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
      lowest = std::min(lowest, here->value);
      highest = std::max(highest, here->value);
    }
    if (here && before && before->value < p.value && here->value >= p.value)
      found = between(p, *before, *here);
    else if (here && !before && here->value >= p.value && T > coldest)
      found = at_edge(p, *here, T / ratio);
    else if (!here && before && before->value < p.value)
      found = at_edge(p, *before, T);
    before = here;
  }
  if (found)
    return *found;
  if (!(lowest <= highest))
    refuse(p, "the parts balance at no temperature");
  if (p.value <= lowest)
    refuse(p, fmt::format("the {} lies below {}, that of the coldest parts that balance", p.name(), lowest));
  if (p.value >= highest)
    refuse(p, fmt::format("the parts balance up to the {} {} only; hotter products need a higher pressure "
                          "to balance the reactant",
                          p.name(), highest));
  refuse(p, fmt::format("the {} lies in a gap of those that balanced parts have, {} to {}", p.name(), lowest,
                        highest));
}

} // namespace mesobridge::fitting
