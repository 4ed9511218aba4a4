#pragma once
#include "md/box.hpp"
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace mesobridge::sdpd {

/// The soft fluid of DPD, energy (a/2)(1 - r)^2 up to r = 1, at k_BT = 1 in a periodic cube, by Metropolis
/// moves of single particles: samples the canonical measure exactly, without a time step. Written apart from
/// the engine, with cells of its own, as the reference of its pressure.
class SoftFluidMonteCarlo {
 public:
  /// side^3 particles on a cubic lattice; the edge of the cube, side/density^(1/3), must be >= 3.
  SoftFluidMonteCarlo(double a, double density, std::uint32_t side, std::uint64_t seed)
      : a_(a), density_(density), box_{Vec3{1, 1, 1} * (side / std::cbrt(density))},
        cells_(static_cast<int>(box_.edge.x)), random_(seed) {
    members_.resize(static_cast<std::size_t>(cells_ * cells_ * cells_));
    double const spacing = box_.edge.x / side;
    for (std::uint32_t x = 0; x < side; ++x)
      for (std::uint32_t y = 0; y < side; ++y)
        for (std::uint32_t z = 0; z < side; ++z)
          q_.push_back({(x + 0.5) * spacing, (y + 0.5) * spacing, (z + 0.5) * spacing});
    for (std::size_t i = 0; i < q_.size(); ++i)
      members_[cell(q_[i])].push_back(i);
  }

  /// Tries as many moves as there are particles; returns the share that was accepted.
  double sweep() {
    std::size_t accepted = 0;
    for (std::size_t k = 0; k < q_.size(); ++k)
      accepted += try_move(random_() % q_.size());
    return static_cast<double>(accepted) / static_cast<double>(q_.size());
  }

  /// rho k_BT + (1/3V) sum over pairs of f r.
  double pressure() const {
    double twice = 0;
    for (std::size_t i = 0; i < q_.size(); ++i)
      for_each_neighbour(i, q_[i], [&](double r) { twice += a_ * (1 - r) * r; });
    return density_ + twice / (6 * box_.volume());
  }

 private:
  static constexpr double longest_move = 0.3; // along each axis; accepts about half at a = 25, density 3

  double uniform() { return static_cast<double>(random_() >> 11) * 0x1p-53; }

  int layer(double x) const { return std::min(static_cast<int>(x / box_.edge.x * cells_), cells_ - 1); }
  std::size_t cell(int x, int y, int z) const {
    auto wrap = [&](int k) { return (k + cells_) % cells_; };
    return static_cast<std::size_t>((wrap(x) * cells_ + wrap(y)) * cells_ + wrap(z));
  }
  std::size_t cell(Vec3 const& q) const { return cell(layer(q.x), layer(q.y), layer(q.z)); }

  /// f(distance) for every other particle nearer than 1 to particle i, were it at q.
  template <class F>
  void for_each_neighbour(std::size_t i, Vec3 const& q, F&& f) const {
    int const x = layer(q.x), y = layer(q.y), z = layer(q.z);
    for (int dx = -1; dx <= 1; ++dx)
      for (int dy = -1; dy <= 1; ++dy)
        for (int dz = -1; dz <= 1; ++dz)
          for (std::size_t const j : members_[cell(x + dx, y + dy, z + dz)])
            if (double const r2 = norm2(box_.minimum_image(q - q_[j])); r2 < 1 && j != i)
              f(std::sqrt(r2));
  }
  double energy(std::size_t i, Vec3 const& q) const {
    double sum = 0;
    for_each_neighbour(i, q, [&](double r) { sum += 0.5 * a_ * (1 - r) * (1 - r); });
    return sum;
  }

  bool try_move(std::size_t i) {
    auto step = [&] { return longest_move * (2 * uniform() - 1); };
    Vec3 const there = box_.wrap(q_[i] + Vec3{step(), step(), step()});
    if (!(uniform() < std::exp(energy(i, q_[i]) - energy(i, there))))
      return false;
    std::erase(members_[cell(q_[i])], i);
    q_[i] = there;
    members_[cell(there)].push_back(i);
    return true;
  }

  double a_, density_;
  Box box_;
  int cells_; ///< along an edge, each at least 1 wide
  std::mt19937_64 random_;
  std::vector<Vec3> q_;
  std::vector<std::vector<std::size_t>> members_; ///< of the cells
};

} // namespace mesobridge::sdpd
