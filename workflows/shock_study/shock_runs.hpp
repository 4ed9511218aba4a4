#pragma once
#include "fitting/shock_relations.hpp"
#include "workflows/report/plot.hpp"
#include "workflows/reproduce/list.hpp"
#include "workflows/scene/scene.hpp"

namespace mesobridge::workflows {

/// A piston's run of a study, and by what name its row goes: "SDPD", "MD" ...
struct ShockCase {
  std::string name; ///< of its folder; unique in a study
  std::string model;
  Scene scene;
};

/// What such a run has shown, in SI.
struct ShockRow {
  std::string model;
  double K = 0, eta = 0, dt_reduced = 0, spacing = 0; ///< eta 0, dt_reduced 0: it has none
  std::int64_t particles = 0;
  std::optional<double> Re_l = std::nullopt;
  cg::Estimate v_S, rho, mass_per_volume, P, T, T_kin;
  std::vector<double> depth, profile, profile_se; ///< of the density, at distances from the front, < 0 behind
  std::string failure = "";                       ///< why the run could not go on; then there is nothing else

  bool failed() const { return !failure.empty(); }
};

/// A piston's scene: the fluid at rest before a piston that moves at v_P [m/s], in a box of that lattice
/// whose z faces are walls. The steps are as many as bring the front to the far end, by the equation of
/// state; `dt` is reduced.
struct PistonScene {
  std::string eos;
  double rho, T, v_P, K, eta, dt;
  std::string scheme;
  std::array<std::int64_t, 3> lattice;
  std::int64_t equilibrate; ///< steps
  std::uint64_t seed;
  bool as_in_the_thesis = false; ///< cubic kernel, plain sums, no ramp; argon: bulk equation of state
  std::string density = "auto";  ///< as scenes name it, for others than the thesis's
};
Scene piston_scene(PistonScene const& wanted);

/// Runs all cases, several at a time, each on one thread; a run that cannot go on has its reason for a
/// result. Finished ones are stored under the directory and read back, others go on from their checkpoints.
/// Throws Interrupted.
std::vector<ShockRow> run_shocks(std::string const& title, std::vector<ShockCase> const& cases,
                                 ReproduceOptions const& options, Context const& context);

} // namespace mesobridge::workflows
