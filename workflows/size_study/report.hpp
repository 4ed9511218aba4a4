#pragma once
#include "workflows/report/plot.hpp"
#include "workflows/report/report.hpp"
#include "workflows/size_study/study.hpp"

namespace mesobridge::workflows {

/// All numbers of the study.
Json size_study_json(SizeStudy const& study);

/// What a reader sees of it: targets, tables beside the thesis's, P(K), rho(K), distributions, g(r). The
/// provenance is left to the caller.
Report size_study_report(SizeStudy const& study);

enum class SizeQuantity { pressure, density };

/// Ours against the particle size beside the thesis's Table 5.1.
Plot against_size(SizeStudy const& study, SizeQuantity quantity, std::string const& kernel);

/// Densities or pressures of single particles, free of the centre of mass.
Plot size_distributions(SizeStudy const& study, SizeQuantity quantity, std::string const& kernel);

/// g(r) of the largest particles.
Plot radial_distributions(SizeStudy const& study);

} // namespace mesobridge::workflows
