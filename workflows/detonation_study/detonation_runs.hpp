#pragma once
#include "workflows/reproduce/list.hpp"
#include "workflows/sdpd/detonation.hpp"

namespace mesobridge::workflows {

/// Nitromethane of 1104 kg/m^3 and 300 K in a box between two mirrors, in which a detonation is to run along
/// z.
struct DetonationCase {
  std::string name;                     ///< of its folder; unique in a study
  double K = 100, Z = 1e15, eta = 2e-3; ///< SI
  std::array<std::int64_t, 3> lattice;
  std::uint64_t seed = 1;
  /// By a piston at 1764 m/s (thesis, section 6.3.2); else by a layer at the lower end that begins as the
  /// products of the detonation.
  bool piston = false;
  std::optional<double> ramp = {}; ///< of the piston [s]; if not given, the scene's default
};
Scene detonation_scene(DetonationCase const& of);

/// Of the same nitromethane with a rate of 1e15/s.
DetonationTheory nitromethane_theory();

/// The mean distance between the particles at rest [m], and the default ramp of such a piston [s].
double spacing_of(DetonationCase const& of);

/// What such a run has shown, in SI.
struct DetonationRow {
  double K = 0, Z = 0, eta = 0, ramp = 0, spacing = 0;
  std::int64_t particles = 0;
  bool piston = false;
  cg::Estimate D, change_of_D, zone;
  double D_theory = 0, zone_theory = 0;
  std::vector<double> times, fronts;            ///< of all frames that have a front
  std::vector<double> depth, P, P_se, progress; ///< in the frame of the steady front
  std::vector<double> slice_rho, slice_P;       ///< behind the front at the last instant
  std::string failure = "";                     ///< why there is nothing else

  bool failed() const { return !failure.empty(); }
  /// When the steady front would have left z = 0: the thesis's time to detonation, with the error of D.
  cg::Estimate time_to_detonation() const;
};

/// Runs all cases, several at a time, each on one thread; see run_study. Throws Interrupted.
std::vector<DetonationRow> run_detonations(std::string const& title, std::vector<DetonationCase> const& cases,
                                           ReproduceOptions const& options, Context const& context);

/// model "SDPD", K, Z_per_s, D_m_s, zone_m ... with _se, or `failure`.
Json row_json(DetonationRow const& row);

/// All rows as JSON, and a report that begins with the given section.
Reproduced reproduced(std::string const& title, std::string const& lead,
                      std::vector<DetonationRow> const& rows, Section first);

} // namespace mesobridge::workflows
