#pragma once
#include "sdpd/observe/measurement.hpp"

namespace mesobridge::sdpd {

/// All measurements; those of every run first, in the order of their columns.
std::vector<Measurement> const& measurements();

} // namespace mesobridge::sdpd
