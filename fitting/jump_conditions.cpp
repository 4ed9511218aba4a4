#include "fitting/jump_conditions.hpp"
#include <cmath>
#include <map>
#include <stdexcept>

namespace mesobridge::fitting {
namespace {

using Known = std::map<Quantity, double>;

/// One step towards all four; what is there already stays.
void derive(Known& known, double rho_0, double P_0) {
  auto const has = [&](Quantity quantity) { return known.contains(quantity); };
  auto const put = [&](Quantity quantity, double value) { known.emplace(quantity, value); };
  using enum Quantity;
  if (has(v_P) && has(v_S)) {
    put(P, P_0 + rho_0 * known[v_S] * known[v_P]);
    put(rho, rho_0 * known[v_S] / (known[v_S] - known[v_P]));
  } else if (has(rho) && has(P)) {
    put(v_P, std::sqrt((known[P] - P_0) * (1 / rho_0 - 1 / known[rho])));
    put(v_S, known[v_P] / (1 - rho_0 / known[rho]));
  } else if (has(rho) && has(v_P)) {
    put(v_S, known[v_P] / (1 - rho_0 / known[rho]));
  } else if (has(rho) && has(v_S)) {
    put(v_P, known[v_S] * (1 - rho_0 / known[rho]));
  } else if (has(P) && has(v_P)) {
    put(v_S, (known[P] - P_0) / (rho_0 * known[v_P]));
  } else if (has(P) && has(v_S)) {
    put(v_P, (known[P] - P_0) / (rho_0 * known[v_S]));
  } else {
    throw std::logic_error("two different quantities of a shock are needed");
  }
}

} // namespace

double Jump::of(Quantity quantity) const {
  switch (quantity) {
  case Quantity::rho:
    return rho;
  case Quantity::P:
    return P;
  case Quantity::v_P:
    return v_P;
  case Quantity::v_S:
    return v_S;
  default:
    throw std::logic_error("no quantity of the jump conditions");
  }
}

Jump jump_of(double rho_0, double P_0, Datum const& a, Datum const& b) {
  Known known{{a.quantity, a.value}, {b.quantity, b.value}};
  while (known.size() < 4)
    derive(known, rho_0, P_0);
  using enum Quantity;
  return {known[rho], known[P], known[v_P], known[v_S]};
}

std::optional<Contradiction> contradiction(double rho_0, double P_0, Datum const& a, Datum const& b,
                                           std::vector<Datum> const& others) {
  constexpr double standard_errors = 5, rounding = 5e-3, step = 1e-3;
  for (auto const& other : others) {
    auto const value = [&](double of_a, double of_b) {
      Datum shifted_a = a, shifted_b = b;
      shifted_a.value += of_a * a.se, shifted_b.value += of_b * b.se;
      return jump_of(rho_0, P_0, shifted_a, shifted_b).of(other.quantity);
    };
    double const expected = value(0, 0);
    double const from_a = (value(step, 0) - expected) / step, from_b = (value(0, step) - expected) / step;
    double const se = std::sqrt(other.se * other.se + from_a * from_a + from_b * from_b);
    double const size = other.quantity == Quantity::P ? std::abs(expected - P_0) : std::abs(expected);
    if (!(std::abs(other.value - expected) <= standard_errors * se + rounding * size))
      return Contradiction{other, expected};
  }
  return std::nullopt;
}

} // namespace mesobridge::fitting
