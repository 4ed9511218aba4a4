#pragma once
#include "md/lj_grid.hpp"
#include "sdpd/observe/equilibrium.hpp"
#include "sdpd/setup/calibrate_density.hpp"
#include "workflows/command.hpp"

namespace mesobridge::workflows {

/// The state of all fluids of the study, of argon.
inline constexpr double state_rho = 1150, state_T = 1000; // kg/m^3, K

/// How the densities and the centres of mass of the particles are treated.
enum class Treatment {
  plain,     ///< the thesis: rho_i = sum_j m_j W_ij, each particle with the bulk's equation of state
  corrected, ///< with calibrated constants of the densities
  free       ///< and with the centre of mass taken out of the particles' equation of state
};
inline constexpr std::array treatments{Treatment::plain, Treatment::corrected, Treatment::free};
std::string label_of(Treatment treatment);

/// One fluid at equilibrium, in units of the equation of state at its density and temperature (but for the
/// distributions).
struct FluidRun {
  std::string kernel;
  double K;
  Treatment treatment;
  sdpd::DensityCorrection constants;
  cg::Estimate P, rho, T_kin, T_int;
  double energy;          ///< kinetic and internal, per mass
  double energy_expected; ///< the same that the invariant measure gives at the densities that were met
  std::vector<double> rho_i, P_i; ///< of single particles: kg/m^3, GPa
};

/// The constants of one kernel and size.
struct SizeCalibration {
  std::string kernel;
  double K;
  sdpd::DensityCalibration found;
};

/// Structure of large particles.
struct Structure {
  std::string kernel;
  std::vector<double> r, g; ///< r in mean spacings
  double pairs;             ///< share of the particles with a neighbour nearer than half a spacing
};

/// Constants where they were not found: at another state, or another size.
struct Elsewhere {
  std::string what;
  FluidRun run;
};

struct SizeStudy {
  double P_eos; ///< [Pa] at the thesis's state
  std::vector<double> sizes;
  std::vector<SizeCalibration> calibrations;
  std::vector<FluidRun> runs;
  std::vector<Structure> structures;
  std::vector<Elsewhere> elsewhere;
  std::size_t particles;
};

/// Argon at 1000 K and 1150 kg/m^3 (thesis, section 5.1.2) by SDPD at sizes K = 5 ... 25000 with two kernels
/// in three treatments. Each run takes one thread; results do not depend on how many there are. Finished
/// parts are stored in the directory, which exists, and read back instead of being made again.
SizeStudy run_size_study(md::Preset preset, std::uint64_t seed, int threads,
                         std::filesystem::path const& directory, Context const& context);

} // namespace mesobridge::workflows
