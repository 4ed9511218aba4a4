#pragma once
#include "sdpd/neighbours/block_copy.hpp"
#include "sdpd/neighbours/pair_values.hpp"
#include "sdpd/system/system.hpp"

namespace mesobridge::sdpd {

/// The masses of a block's particles by their places in it, where all masses are one: nothing is read.
struct UnitMasses {
  static constexpr bool are_one = true;
  void copy_in(System const&, BlockMembers const&) {}
  double operator[](std::size_t) const { return 1; }
};

/// Where each particle has its own. The masses of the phantom pair are one.
class OwnMasses {
 public:
  static constexpr bool are_one = false;
  void copy_in(System const& system, BlockMembers const& members) {
    mass_.assign(size(members) + 2, 1);
    for_each_member(
        members, [&](std::size_t local, Index i, Vec3 const&) { mass_[local] = system.particles.mass[i]; });
  }
  double operator[](std::size_t local) const { return mass_[local]; }
  double const* data() const { return mass_.data(); }

 private:
  std::vector<double> mass_;
};

/// The masses m_i and m_j of pairs, X numbers or lanes of numbers.
template <class X>
struct PairMasses {
  X i, j;

  X product() const { return i * j; }
  /// m_ij = 2/(1/m_i + 1/m_j) (sdpd/README.md, Equations)
  X reduced() const { return 2 * product() / (i + j); }
};

/// Of eight pairs of a block.
[[gnu::always_inline]] inline PairMasses<Lanes> masses_of(OwnMasses const& masses, LocalPair const* pair) {
  auto const [i, j] = values_of(masses.data(), pair);
  return {i, j};
}

/// Calls f with the weights of neighbours in the sums of densities.
template <class F>
void with_density_weights(System const& system, F const& f) {
  if (system.sums_masses())
    f(OwnMasses{});
  else
    f(UnitMasses{});
}

/// The weight of one neighbour in them.
inline double weight_of(System const& system, Index j) {
  return system.sums_masses() ? system.particles.mass[j] : 1;
}

/// What the pressure of particle i gives to the force f_ij = w_i w_j (g_i + g_j) F r_ij, w the weights of
/// neighbours: P_i/rho_i^2, or P_i/n_i^2 with n_i = rho_i/m_i (sdpd/README.md, Eq. (S44)).
inline double push_of_pressure(System const& system, Index i) {
  auto const& particles = system.particles;
  double const push = particles.P[i] / (particles.rho[i] * particles.rho[i]);
  return particles.mass.empty() || system.density_sum == DensitySum::mass
             ? push
             : push * particles.mass[i] * particles.mass[i];
}

/// Calls f with the kind of masses that the particles have.
template <class F>
void with_masses(System const& system, F const& f) {
  if (system.particles.mass.empty())
    f(UnitMasses{});
  else
    f(OwnMasses{});
}

} // namespace mesobridge::sdpd
