#pragma once
#include "md/metal.hpp"
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

/// v_S_m_s, rho_kg_m3, P_Pa, T_K with _se, and `deviation`, the piston's values less these in their common
/// standard errors: {v_S, rho, P, T}.
Json reference_json(HugoniotReference const& reference, ShockOfRun const& shock);

/// Both beside each other with their differences in standard errors.
Section reference_section(HugoniotReference const& reference, ShockOfRun const& shock);
std::string reference_text(HugoniotReference const& reference, ShockOfRun const& shock);

} // namespace mesobridge::workflows
