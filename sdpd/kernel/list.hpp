#pragma once
#include "sdpd/kernel/cubic.hpp"
#include "sdpd/kernel/lucy.hpp"
#include <variant>

namespace mesobridge::sdpd {

/// Every kernel; the passes over the pairs choose once, outside their loops.
using AnyKernel = std::variant<CubicKernel, LucyKernel>;

} // namespace mesobridge::sdpd
