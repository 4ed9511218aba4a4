#pragma once
#include "fitting/fit_eos.hpp"
#include "workflows/report/report.hpp"

namespace mesobridge::workflows {

/// The fit as an HTML report: parameters, correlations, curves with the fit's uncertainty, data with error
/// bars, residuals in standard errors.
std::string eos_fit_report(fitting::EosFit const& fit, std::vector<std::string> const& notes,
                           Provenance const& provenance);

} // namespace mesobridge::workflows
