#pragma once
#include "cg/pair_friction.hpp"
#include "workflows/command.hpp"
#include "workflows/report/report.hpp"
#include "workflows/star/held_file.hpp"

namespace mesobridge::workflows {

/// The whole configurations of a file as the analysis takes them. Throws InputError when frames are not at
/// equal intervals.
std::vector<cg::HeldConfiguration> configurations_of(HeldData const& data);
/// Of the frames of a configuration. Throws InputError when there are fewer than two.
double interval_of(HeldData const& data);

/// Columns r, gamma_par, gamma_perp, as scenes read them (friction.file).
std::string friction_csv(cg::FrictionTable const& table);

Json friction_json(cg::PairFriction const& found);
std::string friction_text(cg::PairFriction const& found);

/// What makes the plateau none; empty where it is one.
std::string plateau_warning(cg::PairFriction const& found);

/// Running integrals with their plateau, frictions over distance beside the tables, and their sums.
Report friction_report(cg::PairFriction const& found, std::string const& name, std::string const& units);

} // namespace mesobridge::workflows
