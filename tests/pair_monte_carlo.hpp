#pragma once
#include "md/box.hpp"
#include <cmath>
#include <cstdint>
#include <functional>
#include <random>
#include <span>
#include <vector>

namespace mesobridge::tests {

/// Energy and force of a pair at a distance.
struct PairLaw {
  double cutoff;
  std::function<double(double)> u, f;
};

inline PairLaw soft(double a) {
  return {1, [=](double r) { return 0.5 * a * (1 - r) * (1 - r); }, [=](double r) { return a * (1 - r); }};
}

/// Lennard-Jones's with the force shifted to 0 at 2.5.
inline PairLaw lennard_jones() {
  constexpr double end = 2.5;
  auto const f = [](double r) { return 24 * (2 * std::pow(r, -13) - std::pow(r, -7)); };
  auto const u = [](double r) { return 4 * (std::pow(r, -12) - std::pow(r, -6)); };
  double const f_end = f(end), u_end = u(end);
  return {end, [=](double r) { return u(r) - u_end + (r - end) * f_end; },
          [=](double r) { return f(r) - f_end; }};
}

/// Positions of particles at k_BT = 1 by Metropolis moves, all pairs looked at.
class PairMonteCarlo {
 public:
  PairMonteCarlo(PairLaw law, int side, double density, double longest, std::uint64_t seed)
      : law_(std::move(law)), box_{Vec3{1, 1, 1} * (side / std::cbrt(density))}, longest_(longest),
        bits_(seed) {
    double const spacing = box_.edge.x / side;
    for (int k = 0; k < side * side * side; ++k)
      q_.push_back(spacing * Vec3{k % side + 0.5, k / side % side + 0.5, k / side / side + 0.5});
  }

  void sweep() {
    for (std::size_t k = 0; k < q_.size(); ++k) {
      std::size_t const i = bits_() % q_.size();
      auto const step = [&] { return longest_ * (2 * uniform_(bits_) - 1); };
      Vec3 const there = box_.wrap(q_[i] + Vec3{step(), step(), step()});
      if (uniform_(bits_) < std::exp(energy(i, q_[i]) - energy(i, there)))
        q_[i] = there;
    }
  }
  Box const& box() const { return box_; }
  std::vector<Vec3> const& positions() const { return q_; }

 private:
  double energy(std::size_t i, Vec3 const& q) const {
    double sum = 0;
    for (std::size_t j = 0; j < q_.size(); ++j)
      if (double const r2 = norm2(box_.minimum_image(q - q_[j])); j != i && r2 < law_.cutoff * law_.cutoff)
        sum += law_.u(std::sqrt(r2));
    return sum;
  }

  PairLaw law_;
  Box box_;
  double longest_;
  std::mt19937_64 bits_;
  std::uniform_real_distribution<double> uniform_;
  std::vector<Vec3> q_;
};

/// The forces that the law gives all particles.
inline std::vector<Vec3> forces_of(PairLaw const& law, std::span<Vec3 const> R, Box const& box) {
  std::vector<Vec3> all;
  for (auto const& a : R) {
    Vec3 F;
    for (auto const& b : R)
      if (Vec3 const apart = box.minimum_image(a - b);
          norm2(apart) > 0 && norm2(apart) < law.cutoff * law.cutoff)
        F += law.f(norm(apart)) / norm(apart) * apart;
    all.push_back(F);
  }
  return all;
}

} // namespace mesobridge::tests
