#pragma once
#include "cg/molecule_model.hpp"
#include <cstdint>

namespace mesobridge::cg {

/// What the other molecules do to each molecule: half of the pair energies, and the force.
struct Intermolecular {
  std::vector<double> Phi;
  std::vector<Vec3> F;
};

/// Over all pairs of atoms of different molecules within the cut-offs, by cells. The atoms of a molecule
/// stand together. Throws InputError when the box is narrower than two cut-offs.
Intermolecular intermolecular(MoleculeModel const& model, std::span<Vec3 const> q, Box const& box);

} // namespace mesobridge::cg
