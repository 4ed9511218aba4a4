#pragma once
#include "cg/estimate.hpp"
#include <string>

namespace mesobridge::workflows {

/// "0.6814 ± 0.0003": the error with two significant digits, the value to the same decimal.
std::string with_error_text(cg::Estimate const& estimate);

/// A number with that many significant digits: "1150", "6.814e+08".
std::string number_text(double value, int digits = 5);

} // namespace mesobridge::workflows
