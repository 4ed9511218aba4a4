#pragma once
#include "md/lj_piston.hpp"
#include "md/metal_piston.hpp"
#include "md/star_piston.hpp"
#include "workflows/command.hpp"
#include <variant>

namespace mesobridge::workflows {

/// A piston's run by molecular dynamics to be made.
struct PistonJob {
  std::variant<md::LjPistonSettings, md::MetalPistonSettings, md::StarPistonSettings> settings;
  std::int64_t steps = 0;          ///< while the piston moves
  std::filesystem::path directory; ///< exists; gets piston-shock.h5 and LAMMPS's log

  std::filesystem::path file() const { return directory / "piston-shock.h5"; }
};

/// The settings of argon at rho0 [kg/m^3], T0 [K] before a piston at v_P [m/s].
md::LjPistonSettings argon_piston(md::Preset preset, double rho0, double T0, double v_P);

/// Samples into job.file() as the slices arrive, on the ranks that run already, with progress. Returns on
/// every rank. Throws Interrupted on rank 0 when the user stopped it (what was sampled is in the file), and
/// as md::sample_lj_piston.
void sample_piston(PistonJob const& job, Context const& context);

} // namespace mesobridge::workflows
