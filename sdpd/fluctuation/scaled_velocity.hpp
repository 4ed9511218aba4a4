#pragma once
#include "sdpd/conduction/heat_conduction.hpp"
#include "sdpd/friction/list.hpp"
#include "sdpd/system/masses.hpp"

/// A pair of masses m_i and m_j takes the step of a pair of unit masses (sdpd/README.md, Eq. (S22) to (S24))
/// in the scaled relative velocity w = m_ij^1/2 (p_i/m_i - p_j/m_j) with the friction gamma/m_ij: the heat is
/// -(w'^2 - w^2)/8 for each of the two, the momentum that the first one gains m_ij^1/2 (w' - w)/2, and the
/// densities of the step there and back have the same ratio.
namespace mesobridge::sdpd {

/// m_ij^1/2 and w from the momenta of a pair; X is a number or lanes of numbers.
template <class X>
struct VelocityScale {
  X root, over_i, over_j;

  [[gnu::always_inline]] explicit VelocityScale(PairMasses<X> const& mass)
      : root(square_root(mass.reduced())), over_i(root / mass.i), over_j(root / mass.j) {}
  template <class P>
  [[gnu::always_inline]] P velocity(P const& p_i, P const& p_j) const {
    return p_i * over_i - p_j * over_j;
  }
  /// The momentum that belongs to a change of w.
  template <class P>
  [[gnu::always_inline]] P momentum(P const& change) const {
    return change * root;
  }
};

/// Where all masses are one, w is the relative velocity.
struct UnitScale {
  template <class P>
  [[gnu::always_inline]] static P velocity(P const& p_i, P const& p_j) {
    return p_i - p_j;
  }
  template <class P>
  [[gnu::always_inline]] static P momentum(P const& change) {
    return change;
  }
};

/// Of eight pairs of a block.
[[gnu::always_inline]] inline UnitScale scale_of(UnitMasses const&, LocalPair const*) {
  return {};
}
[[gnu::always_inline]] inline VelocityScale<Lanes> scale_of(OwnMasses const& masses, LocalPair const* pair) {
  return VelocityScale<Lanes>(masses_of(masses, pair));
}
/// Of one of them.
inline UnitScale scale_of(UnitMasses const&, LocalPair) {
  return {};
}
inline VelocityScale<double> scale_of(OwnMasses const& mass, LocalPair pair) {
  return VelocityScale<double>({mass[pair.i], mass[pair.j]});
}

/// What the weight of a pair of unit masses is multiplied by: friction goes by gamma/m_ij, and SDPD's chi has
/// the factor m_i m_j (Eq. (S14)).
inline double weight_factor(SdpdLaw const&, PairMasses<double> const& mass) {
  return mass.product() / mass.reduced();
}
template <Transverse across>
double weight_factor(DpdeLaw<across> const&, PairMasses<double> const& mass) {
  return 1 / mass.reduced();
}
template <Transverse across>
double weight_factor(DpdLaw<across> const&, PairMasses<double> const& mass) {
  return 1 / mass.reduced();
}
/// Heat does not ask for velocities.
inline double weight_factor(SdpdConduction const&, PairMasses<double> const& mass) {
  return mass.product();
}
inline double weight_factor(DpdeConduction const&, PairMasses<double> const&) {
  return 1;
}

} // namespace mesobridge::sdpd
