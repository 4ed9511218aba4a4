#pragma once
#include "sdpd/system/system.hpp"
#include <array>

namespace mesobridge::sdpd {

/// How the neighbours of particles are ordered (sdpd/README.md, Eqs. (S81), (S82)).
struct BondOrder {
  double local = 0;   ///< q6, the mean over the particles: fcc 0.575, bcc 0.511, simple cubic 0.354
  double global = 0;  ///< Q6 of all bonds: these values for one crystal, about N_bonds^(-1/2) for a fluid
  double crystal = 0; ///< share of the particles whose neighbours are ordered as their own neighbours are
};

/// Bonds are shorter than this, in mean distances between particles (V/N)^(1/3): with it a particle of an fcc
/// crystal has 12, of a bcc one 14, of a simple cubic one 6; or as long as the interaction reaches, if that
/// is less.
inline constexpr double bond_length = 1.35;

/// Reads the pairs in range of the last evaluation of the densities or forces; no images behind walls.
BondOrder bond_order(System const& system);

/// The thirteen real spherical harmonics of degree 6 of a unit vector, of which those of two vectors have the
/// product P6(cos of their angle).
std::array<double, 13> sixth_harmonics(Vec3 const& e);

} // namespace mesobridge::sdpd
