#pragma once
#include "md/lj_piston.hpp"
#include "md/metal_piston.hpp"
#include "md/star_piston.hpp"
#include "sdpd/observe/shock_front.hpp"
#include "workflows/provenance.hpp"
#include "workflows/scene/scene.hpp"

namespace mesobridge::workflows {

/// What a file of slices has to know of its run, in the units of the file.
struct PistonRunInfo {
  std::string description;
  std::int64_t atoms = 0;
  int slices = 0;
  double v_P = 0, spacing = 0, length = 0, rho = 0; ///< rho: ahead of the front
  /// In which LAMMPS tells the slices.
  double unit_time = 1, unit_length = 1, unit_velocity = 1, unit_pressure = 1, unit_temperature = 1;
  UnitSystem units = UnitSystem::SI; ///< of the file
};
PistonRunInfo info_of(md::LjPistonSettings const& settings); ///< for argon
PistonRunInfo info_of(md::MetalPistonSettings const& settings);
PistonRunInfo info_of(md::StarPistonSettings const& settings); ///< in Lennard-Jones units

/// The slices of a piston's run by molecular dynamics as they arrive, in SI: profile/time_s, position_m,
/// velocity_m_s, rho_kg_m3, P_Pa, T_K, number, like the profiles of SDPD's runs. In Lennard-Jones units the
/// names have no ends. Melts have molecules_number, molecules_velocity and molecules_T as well, of the
/// centres, and the energy of all beads. Every row is flushed: what an interrupted run has told stays
/// readable.
class PistonFile {
 public:
  /// Creates the file. Throws EnvironmentError.
  PistonFile(std::filesystem::path const& file, PistonRunInfo const& info, Provenance const& provenance);

  void append(md::PistonSlices const& slices);

  /// Marks the file as complete, or not, and closes it.
  void close(bool complete);

 private:
  Store store_;
  PistonRunInfo info_;
};

/// What such a file holds: what sdpd::steady_shock takes, in the units of the file.
struct PistonData {
  UnitSystem units = UnitSystem::SI;
  std::string description; ///< of the run, for people
  std::int64_t atoms = 0;
  bool complete = false; ///< false: the run was interrupted
  sdpd::ShockScale scale{.position = {}, .v_P = 0, .spacing = 0};
  std::vector<sdpd::ShockFrame> frames;
  /// Of a melt: the molecules in place of the atoms, with the temperature of their centres; empty otherwise.
  std::vector<sdpd::ShockFrame> molecules;
  std::vector<double> energy; ///< of all atoms of a melt, frame by frame
};

/// Throws InputError if the file is missing or holds something else.
PistonData read_piston(std::filesystem::path const& file);

} // namespace mesobridge::workflows
