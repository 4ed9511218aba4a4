#pragma once
#include "cg/blobs.hpp"
#include "workflows/provenance.hpp"
#include "workflows/store/store.hpp"
#include <limits>

namespace mesobridge::workflows {

/// What a file of blobs says about itself.
struct BlobFileHead {
  std::string kind;        ///< "melt", "vacuum canonical", "vacuum microcanonical", "trajectory", "held"
  std::string name;        ///< of the molecules, "6-3"
  std::string fingerprint; ///< of the settings that decide the run
  int molecules = 0;
  int atoms = 0; ///< of a molecule
  double mass = 0;
  double rho = 0;            ///< atoms per volume; 0: isolated molecules
  double T = 0;              ///< of the thermostat; 0: none or several
  std::vector<double> set{}; ///< vacuum: the temperature (or the energy) set for each molecule
  std::string units = "lj";  ///< LAMMPS's unit style; masses are consistent ones (see UnitStyle)
  std::string walls{};       ///< the axes, "z" say, along which the box is not periodic
  bool may_tilt = false;     ///< frames/tilt says xy, xz, yz of each box
  std::string time_unit{};   ///< "steps" where the trajectory says no time; otherwise that of the unit style
};

/// What a file says about itself goes into the group "settings" and comes from there.
void write_head(Store& store, BlobFileHead const& head);
BlobFileHead read_head(Store const& store);
/// Throws InputError when a file that is to be continued was made by other settings.
void refuse_other_settings(Store const& store, std::string const& fingerprint);

/// Vectors of blobs from a row of a file.
std::vector<Vec3> vectors_of(std::vector<double> const& flat);
/// A row of a file: one number of each blob, or the components of one vector.
std::vector<double> row_of(cg::BlobFrame const& frame, double cg::Blob::*member);
std::vector<double> row_of(cg::BlobFrame const& frame, Vec3 cg::Blob::*member);

/// A time series of blobs: frames/step, time, box, energy, pressure (and tilt of
/// boxes that may be tilted); blobs/R, P, F, U_kin, U_pot, Phi, one
/// row a frame.
class BlobFile {
 public:
  BlobFile(std::filesystem::path const& file, BlobFileHead const& head, Provenance const& provenance);
  /// Opens the file of a run to be resumed. Throws InputError when its fingerprint is another, or a version
  /// without marks was killed while it wrote there.
  static BlobFile continue_file(std::filesystem::path const& file, std::string const& fingerprint);

  /// Appends the frames, but for those that a resumed run makes once more after its checkpoint. From then on
  /// they survive the program's death; what a death in between leaves of them is undone when the file is
  /// opened again.
  void append(std::span<cg::BlobFrame const> frames);
  void close();

 private:
  explicit BlobFile(Store store) : store_(std::move(store)) {}

  Store store_;
  bool may_tilt_ = false;
  std::int64_t last_step_ = std::numeric_limits<std::int64_t>::min(); ///< that was there when it was opened
};

/// All blobs of a file, column by column: number frame * molecules + molecule.
struct BlobData {
  BlobFileHead head;
  std::vector<std::int64_t> steps;
  std::vector<double> times, energies, pressures;
  std::vector<Box> boxes;
  std::vector<Vec3> R, P;
  std::vector<double> U_kin, U_pot, Phi;

  std::size_t frames() const { return times.size(); }
  double U(std::size_t k) const { return U_kin[k] + U_pot[k]; }
};

/// What a file says about itself. Throws as read_blobs.
BlobFileHead read_blob_head(std::filesystem::path const& file);

/// Refuses blobs between walls where the analysis, `what`, wants a periodic box.
void refuse_walls(BlobFileHead const& head, std::filesystem::path const& file, std::string const& what);

/// "reduced Lennard-Jones", or the units of LAMMPS's style.
std::string units_text(BlobFileHead const& head);

/// Throws InputError if the file is missing, holds something else, columns of different lengths or values
/// that cannot be.
BlobData read_blobs(std::filesystem::path const& file);

/// The net forces on the blobs of such a file. Throws InputError if it has none.
std::vector<Vec3> read_blob_forces(std::filesystem::path const& file);

} // namespace mesobridge::workflows
