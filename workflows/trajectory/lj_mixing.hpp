#pragma once
#include <cmath>

namespace mesobridge::workflows {

struct LennardJones {
  double epsilon, sigma, cutoff;
};

enum class Mix { geometric, arithmetic, sixthpower };

/// Of two unlike types, as LAMMPS's pair_modify mix names the ways.
inline LennardJones mixed(LennardJones const& a, LennardJones const& b, Mix mix) {
  double const energy = std::sqrt(a.epsilon * b.epsilon);
  auto const sixth = [](double x, double y) {
    return std::pow((std::pow(x, 6) + std::pow(y, 6)) / 2, 1.0 / 6);
  };
  if (mix == Mix::arithmetic)
    return {energy, (a.sigma + b.sigma) / 2, (a.cutoff + b.cutoff) / 2};
  if (mix == Mix::geometric)
    return {energy, std::sqrt(a.sigma * b.sigma), std::sqrt(a.cutoff * b.cutoff)};
  double const a3 = std::pow(a.sigma, 3), b3 = std::pow(b.sigma, 3);
  return {2 * energy * a3 * b3 / (a3 * a3 + b3 * b3), sixth(a.sigma, b.sigma), sixth(a.cutoff, b.cutoff)};
}

} // namespace mesobridge::workflows
