#pragma once
#include "md/metal_piston.hpp"
#include "workflows/report/report.hpp"
#include "workflows/sdpd/shock.hpp"

namespace mesobridge::workflows {

/// The state behind a shock of one v_P by states of equilibrium (`md hugoniot`), linear between the two of
/// its points that lie about v_P; in SI.
struct HugoniotReference {
  cg::Estimate v_S, rho, P, T;
};

/// Reads hugoniot.csv; v_P [m/s]. Throws InputError that names the file when it is no such table, when v_P
/// does not lie between its points, or when the two about it begin in a density or temperature that is
/// another than that ahead of the piston by more than 0.5 %.
HugoniotReference read_hugoniot_reference(std::filesystem::path const& file, md::MetalState const& ahead,
                                          double v_P);

/// The same of the piston's crystal where it stays one that is squeezed along z alone: shifted by what
/// quasi-harmonic estimates of both differ by (md/README.md, Eqs. (M9), (M15)). LAMMPS, which is asked for
/// static crystals, appends to the settings' log file. Throws InputError, PhysicsError where an estimate has
/// no such shock, LammpsError.
HugoniotReference squeezed_along_z(HugoniotReference reference, md::MetalPistonSettings const& settings);

/// v_S_m_s, rho_kg_m3, P_Pa, T_K with _se, and `deviation`, the piston's values less these in their common
/// standard errors: {v_S, rho, P, T}.
Json reference_json(HugoniotReference const& reference, ShockOfRun const& shock);

/// Both beside the piston's shock, with the differences in standard errors: into the summary (`hugoniot`, and
/// `hugoniot_along_z` where there is an estimate; a warning says why there is none), as a section of the
/// report and as the lines that it returns.
std::string put_references(HugoniotReference const& reference, md::MetalPistonSettings const& settings,
                           ShockOfRun const& shock, Json& summary, Report& report);

} // namespace mesobridge::workflows
