#pragma once
#include "md/box.hpp"
#include <span>
#include <vector>

namespace mesobridge::sdpd {

/// S(k) at one wave vector of the box; k and -k count as one.
struct Scattered {
  double k; ///< length of the vector
  double S; ///< |sum exp(i k q)|^2/N: 1 on average for an ideal gas, N at a crystal's own vectors
};

/// The structure factor (sdpd/README.md, Eq. (S80)) of one instant at all wave vectors of the box with k_min
/// <= k <= k_max; along axes that are not periodic they have no component. The cost goes with the particles
/// times the vectors: as the square of the particles. Throws InputError where no vector is in the range.
std::vector<Scattered> structure_factor(std::span<Vec3 const> q, Box const& box, double k_min, double k_max);

/// The first peak of a structure factor.
struct StructurePeak {
  double shell = 0;   ///< the largest mean over a shell of wave vectors: 2 ... 3 for a dense liquid
  double largest = 0; ///< at a single vector: about ln(vectors) shells for a fluid, N for a crystal
};

/// Of one instant, among 5 <= k l <= 8 with l = (V/N)^(1/3), where the first peaks of dense liquids and of sc
/// (6.28), bcc (7.05) and fcc crystals (6.86) lie; in twelve shells.
StructurePeak structure_peak(std::span<Vec3 const> q, Box const& box);

/// What is left of the simple cubic lattice at which particles start: the largest of S/N at its three
/// shortest vectors, along the axes that are periodic. 1 for the lattice itself, 0.41 with a disorder of
/// 0.15, of the order of 3/N for a fluid.
double lattice_order(std::span<Vec3 const> q, Box const& box);

} // namespace mesobridge::sdpd
