#pragma once
#include "cg/molecule_model.hpp"
#include "md/molecule_atoms.hpp"
#include "md/mpi_world.hpp"
#include <optional>

namespace mesobridge::cg {

/// One molecule as a blob, in the units of the run (cg/README.md, Eq. (C7)).
struct Blob {
  Vec3 R;           ///< centre of mass, inside the box
  Vec3 P;           ///< momentum
  Vec3 F;           ///< net force: the sum of the forces on its atoms
  double U_kin = 0; ///< kinetic energy relative to the centre of mass
  double U_pot = 0; ///< potential energy inside the molecule: pairs and bonds
  double Phi = 0;   ///< half of the potential energy with the other molecules
  double width =
      0; ///< the largest of its extents across the box's faces: along x, y and z if it is not tilted

  double U() const { return U_kin + U_pot; }
  double internal_energy() const { return U() + Phi; }
};

/// All blobs of one instant.
struct BlobFrame {
  std::int64_t step = 0;
  double time = 0;
  Box box;
  double energy = 0;   ///< total energy of the system as the MD program says it
  double pressure = 0; ///< likewise
  std::vector<Blob> blobs;
};

/// The potential energy inside a molecule where MD tells it, and how far its pairs of atoms see each other.
struct ToldInside {
  double energy = 0, reach = 0;
};

/// Turns the atoms of equal molecules into blobs. An atom's positions are joined along the bonds, so the
/// molecules may lie across the borders of the box. Phi is what the atoms' potential energies (each half of
/// the pairs and bonds that an atom takes part in) leave when those inside the molecule are taken away.
class BlobMaker {
 public:
  explicit BlobMaker(MoleculeModel model);

  /// One molecule; the spans have one entry an atom. Throws PhysicsError when it is so wide that its atoms
  /// are within the cut-off of its own images or, if bonds do not join it whole, that nearest images do not
  /// tell where its parts are. What is told of the energy inside takes the place of the model's.
  Blob blob(std::span<Vec3 const> q, std::span<Vec3 const> v, std::span<Vec3 const> f,
            std::span<double const> potential, Box const& box, std::optional<ToldInside> inside = {});

  /// All molecules of this rank. With an empty `potential` in the frame Phi stays 0.
  std::vector<Blob> blobs(md::MoleculeFrame const& frame);

  MoleculeModel const& model() const { return model_; }

 private:
  void join(std::span<Vec3 const> q, Box const& box);
  Vec3 extents(Box const& box) const; ///< across its faces
  double width_in(Box const& box, double reach) const;
  double energy_inside() const;

  MoleculeModel model_;
  std::vector<std::pair<int, int>> steps_;
  bool whole_;                    ///< joined by bonds
  double cutoff_;                 ///< the longest of the pair laws
  std::vector<double> x_, y_, z_; ///< of one molecule, joined
  double mass_;
};

/// Throws PhysicsError when the molecules are wider than half the box on average: such a box is no melt.
void refuse_large_molecules(BlobFrame const& frame);

/// The blobs of all ranks, on rank 0; no blobs elsewhere. All ranks must call it. Throws as
/// refuse_large_molecules.
BlobFrame gather_blobs(md::MpiWorld const& world, md::MoleculeFrame const& frame,
                       std::span<Blob const> of_this_rank);

/// sum of U + Phi + P^2/2M over the blobs, in the order of their numbers.
double total_energy(std::span<Blob const> blobs, double mass);

} // namespace mesobridge::cg
