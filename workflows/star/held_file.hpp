#pragma once
#include "workflows/star/blob_file.hpp"

namespace mesobridge::workflows {

/// Molecules held at their centres of mass, configuration after configuration: configurations/R and box, one
/// row each; frames/step, time, energy, configuration (from 0); blobs/F, U_kin, U_pot, Phi, one row a frame.
/// F is the net force on a molecule without what holds it.
class HeldFile {
 public:
  /// `frames` of each configuration.
  HeldFile(std::filesystem::path const& file, BlobFileHead const& head, std::int64_t frames,
           Provenance const& provenance);
  /// Opens the file of a run to be resumed. Throws InputError when its fingerprint is another.
  static HeldFile continue_file(std::filesystem::path const& file, std::string const& fingerprint);

  /// One frame; those that a resumed run makes once more after its checkpoint are left out.
  void append(cg::BlobFrame const& frame);
  /// All that was appended survives the program's death from now on.
  void mark() { store_.mark(); }
  void close() { store_.close(); }

 private:
  explicit HeldFile(Store store) : store_(std::move(store)) {}

  Store store_;
  std::int64_t frames_of_each_ = 0, frames_ = 0;
  std::int64_t last_step_ = std::numeric_limits<std::int64_t>::min(); ///< that was there when it was opened
};

/// All of such a file: number configuration * molecules + molecule, and frame * molecules + molecule.
struct HeldData {
  BlobFileHead head;
  std::size_t frames_of_each = 0; ///< of a whole configuration; the last one may have fewer
  std::vector<std::int64_t> steps;
  std::vector<double> times, energies;
  std::vector<Box> boxes; ///< of the configurations
  std::vector<Vec3> R, F;
  std::vector<double> U_kin, U_pot, Phi;

  std::size_t molecules() const { return std::size_t(head.molecules); }
  std::size_t whole_configurations() const { return steps.size() / frames_of_each; }
};

/// Whether a file holds molecules that were held, or something else. Throws InputError if it is missing.
bool holds_held(std::filesystem::path const& file);

/// Throws InputError if the file is missing, holds something else, columns of different lengths or values
/// that cannot be.
HeldData read_held(std::filesystem::path const& file);

} // namespace mesobridge::workflows
