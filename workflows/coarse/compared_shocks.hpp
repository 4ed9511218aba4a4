#pragma once
#include "fitting/internal_energy.hpp"
#include "workflows/coarse/star_to_dpde.hpp"
#include "workflows/sdpd/shock.hpp"

namespace mesobridge::workflows {

/// A state ahead of a front and behind it, in Lennard-Jones units.
struct ShockedState {
  cg::Estimate rho_0, P_0, T_0, v_S, rho, P;
  cg::Estimate T;        ///< of beads, or of internal energies, behind the front
  cg::Estimate T_motion; ///< of molecules' centres, or of particles, behind the front
  cg::Estimate energy;   ///< that the shock gives a molecule at rest behind it (cg/README.md, Eq. (C44))
  cg::Estimate heat;     ///< what of it is heat by S(U) (Eq. (C45))
};

/// The state of a shock in a fluid whose molecules have that mass and S(U). Throws PhysicsError where no
/// slice is ahead of the front for long enough.
ShockedState shocked_state(ShockOfRun const& shock, double spacing, double mass,
                           fitting::AnyInternalEnergy const& internal_energy);

/// Of both fluids before the same piston; empty where no shock is steady in its box.
struct ComparedShocks {
  std::optional<ShockOfRun> melt, particles;
  std::optional<ShockedState> of_melt, of_particles;

  bool both() const { return of_melt && of_particles; }
};

/// Reads what the stages have written; both are looked at on one scale, the mean distance of beads. Throws
/// InputError where something is missing or damaged.
ComparedShocks read_shocks(StarToDpdePlan const& plan, std::filesystem::path const& directory);

/// v_S, rho, P, T ... of both, with errors and how many standard errors apart.
Json shocks_json(ComparedShocks const& shocks);

/// A table of both side by side, profiles in the frame of the front, and the stages that made them.
Section shocks_section(ComparedShocks const& shocks, double v_P, std::vector<Stage> const& stages);

} // namespace mesobridge::workflows
