#pragma once
#include "md/error.hpp"
#include "md/vec3.hpp"
#include <string>
#include <vector>

namespace mesobridge::md {

/// A bond k (r - l)^2 / 2 between two atoms of a molecule, counted from 0.
struct HarmonicBond {
  int a = 0, b = 0;
  double k = 0, l = 0;
};

/// An N_b-N_m star: one centre and N_b arms of N_m beads, all of mass 1, in Lennard-Jones units. Every two
/// beads repel each other by the WCA potential, bonded ones too. The bonds are those of the thesis
/// (md/README.md, Eq. (M7)). Atom 0 is the centre; bead j of arm a (from 0) is atom 1 + a N_m + j.
struct StarPolymer {
  int arms = 6;                 ///< N_b, 1 ... 12
  int beads = 3;                ///< N_m, 1 ... 24
  double k = 20;                ///< bond stiffness [epsilon/sigma^2]
  double arm_length = 1.147;    ///< rest length of the bonds inside the arms [sigma]
  double centre_length = 1.615; ///< rest length of the bonds to the centre [sigma]
  bool repulsion = true;        ///< without it and with rest lengths 0 the star is harmonic: S(U) is known

  int atoms() const { return 1 + arms * beads; }
  std::string name() const { return fmt::format("{}-{}", arms, beads); }
  std::vector<HarmonicBond> bonds() const;
  bool operator==(StarPolymer const&) const = default;
};

/// The distance at which the WCA potential ends, 2^(1/6) [sigma].
double wca_cutoff();

/// Reads "6-3". Throws InputError.
StarPolymer star_of_name(std::string const& name);

/// Throws InputError for a star outside the ranges above.
void check(StarPolymer const& star);

/// The distance from the centre to the end of a straight arm of the start [sigma].
double straight_radius(StarPolymer const& star);

/// Straight arms in directions spread over the sphere, the centre at the origin. No two beads of it are
/// nearer than 1 sigma.
std::vector<Vec3> straight_star(StarPolymer const& star);

/// The same, turned at random (uniformly over all rotations) by the numbers u, v, w in [0, 1).
std::vector<Vec3> turned(std::vector<Vec3> atoms, double u, double v, double w);

} // namespace mesobridge::md
