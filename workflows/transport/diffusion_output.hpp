#pragma once
#include "cg/diffusion.hpp"
#include "cg/viscosity.hpp"
#include "workflows/command.hpp"
#include "workflows/report/report.hpp"

namespace mesobridge::workflows {

/// D, D_earlier, D_velocity, temperature, decay of the velocities, with standard errors, and the curves; in
/// the units of the blobs.
Json diffusion_json(cg::Diffusion const& found);
std::string diffusion_text(cg::Diffusion const& found);

/// Displacements over time, which level off at D, the correlation of the velocities, and the viscosity where
/// there is one.
Report transport_report(cg::Diffusion const& found, std::optional<cg::Viscosity> const& viscosity,
                        std::string const& name, std::string const& units);

} // namespace mesobridge::workflows
