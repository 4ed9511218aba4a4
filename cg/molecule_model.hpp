#pragma once
#include "cg/bond_law.hpp"
#include "md/box.hpp"
#include "md/equal_molecules.hpp"
#include "md/star_polymer.hpp"
#include <span>
#include <vector>

namespace mesobridge::cg {

/// A Lennard-Jones pair potential, cut at `cutoff` (0: none); shifted, it is zero there.
class PairLaw {
 public:
  PairLaw(double epsilon, double sigma, double cutoff, bool shifted)
      : epsilon_(epsilon), sigma_2_(sigma * sigma), cutoff_2_(cutoff * cutoff) {
    if (shifted && cutoff > 0)
      shift_ = unshifted(cutoff_2_);
  }

  /// At the squared distance r2 > 0; 0 beyond the cut-off.
  double energy(double r2) const { return r2 < cutoff_2_ ? unshifted(r2) - shift_ : 0; }
  /// -dV/dr/r at the squared distance r2 > 0.
  double force_over_r(double r2) const {
    if (r2 >= cutoff_2_)
      return 0;
    double const s2 = sigma_2_ / r2, s6 = s2 * s2 * s2;
    return 24 * epsilon_ * (2 * s6 * s6 - s6) / r2;
  }
  double cutoff() const { return std::sqrt(cutoff_2_); }

 private:
  double unshifted(double r2) const {
    double const s2 = sigma_2_ / r2, s6 = s2 * s2 * s2;
    return 4 * epsilon_ * (s6 * s6 - s6);
  }

  double epsilon_, sigma_2_, cutoff_2_, shift_ = 0;
};

/// What holds one kind of molecule together: the part of the force field inside it.
struct MoleculeModel {
  std::vector<double> masses; ///< of its atoms, in order
  std::vector<int> types;     ///< of its atoms, from 0
  std::vector<PairLaw> pairs; ///< types x types
  int type_count = 1;
  std::vector<Bond> bonds;
  /// Pairs of atoms that do not interact by the pair law (bonded ones in many force fields), a < b.
  std::vector<std::pair<int, int>> excluded;

  int atoms() const { return int(masses.size()); }
  double mass() const;
  double longest_cutoff() const; ///< of the pairs' laws; 0 without
  PairLaw const& law(int type_a, int type_b) const {
    return pairs[std::size_t(type_a * type_count + type_b)];
  }
};

MoleculeModel model_of(md::StarPolymer const& star);

/// Masses, each times `energy_of_mv2`, and bonds without energy, which join the atoms: of molecules whose
/// energies MD tells itself.
MoleculeModel model_of(md::MoleculeKind const& kind, double energy_of_mv2);

/// Steps along bonds from atom 0 that reach every atom; an atom without a bond to the rest is reached from
/// atom 0 itself. Each step goes from an atom that was reached before.
std::vector<std::pair<int, int>> spanning_steps(MoleculeModel const& model);

/// Whether bonds lead from every atom to every other.
bool joined_by_bonds(MoleculeModel const& model);

} // namespace mesobridge::cg
