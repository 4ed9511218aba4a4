#pragma once
#include "md/error.hpp"

namespace mesobridge::cg {

/// A run does not last long enough for standard errors.
struct TooShort : PhysicsError {
  TooShort(std::string const& what, double needed) : PhysicsError(what), needed_time(needed) {}
  double needed_time; ///< in the time unit of the run
};

} // namespace mesobridge::cg
