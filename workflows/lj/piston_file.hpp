#pragma once
#include "md/lj_piston.hpp"
#include "sdpd/observe/shock_front.hpp"
#include "workflows/provenance.hpp"

namespace mesobridge::workflows {

/// The slices of a piston's run by molecular dynamics as they arrive, for argon in SI: profile/time_s,
/// position_m, velocity_m_s, rho_kg_m3, P_Pa, T_K, number, like the profiles of SDPD's runs. Every row is
/// flushed: what an interrupted run has told stays readable.
class LjPistonFile {
 public:
  /// Creates the file. Throws EnvironmentError.
  LjPistonFile(std::filesystem::path const& file, md::LjPistonSettings const& settings,
               Provenance const& provenance);

  void append(md::PistonSlices const& slices);

  /// Marks the file as complete, or not, and closes it.
  void close(bool complete);

 private:
  Store store_;
  md::LjPistonSettings settings_;
};

/// What such a file holds: what sdpd::steady_shock takes, in SI.
struct LjPistonData {
  std::string description; ///< of the run, for people
  std::int64_t atoms = 0;
  bool complete = false; ///< false: the run was interrupted
  sdpd::ShockScale scale;
  std::vector<sdpd::ShockFrame> frames;
};

/// Throws InputError if the file is missing or holds something else.
LjPistonData read_lj_piston(std::filesystem::path const& file);

} // namespace mesobridge::workflows
