#pragma once
#include "cg/viscosity.hpp"
#include "workflows/command.hpp"
#include "workflows/report/report.hpp"

namespace mesobridge::workflows {

/// eta, eta_integral with standard errors, and what each length of waves tells; in the units of the series.
Json viscosity_json(cg::Viscosity const& found);
std::string viscosity_text(cg::Viscosity const& found);

/// The decay of the transverse currents with what fits it, and the viscosities over k^2 with their line.
Section viscosity_section(cg::Viscosity const& found);

} // namespace mesobridge::workflows
