#pragma once
#include "sdpd/observe/list.hpp"
#include "workflows/sdpd/settings.hpp"

namespace mesobridge::workflows {

/// How a measurement and its components are called in files: "momentum_x_kg_m_s" ...
std::string dataset_name(sdpd::Measurement const& of, OutputUnits const& units);
std::vector<std::string> columns_of(sdpd::Measurement const& of, OutputUnits const& units);

/// The measurements that every run of a method makes, in the order of their columns.
std::vector<sdpd::Measurement> measured_in_every_run(sdpd::Features const& features);

} // namespace mesobridge::workflows
