#pragma once
#include "cg/estimate.hpp"
#include "workflows/report/report.hpp"
#include <string>
#include <vector>

namespace mesobridge::workflows {

/// A quantity that was found beside what it should be; each with its own standard error, and in one unit.
struct Comparison {
  std::string of; ///< "P* at rho* = 0.45, T* = 2.75"
  cg::Estimate found;
  cg::Estimate expected; ///< the error is what the reference itself may be wrong by; 0: it is exact
};

/// (found - expected) in their combined standard error; exact and equal ones are 0 apart.
double deviation(Comparison const& comparison);

/// How many standard errors the farthest of n independent quantities may be off: right ones, whose errors are
/// Gaussian, go beyond it in one of a thousand reports.
double allowed_deviation(std::size_t n);

/// The line of the farthest of some comparisons, which passes within allowed_deviation of their number.
/// Throws std::logic_error for none.
VerdictLine check_line(std::string what, std::vector<Comparison> const& comparisons);

/// The same line for a difference that is known, shown and not asked for.
VerdictLine noted_line(std::string what, std::vector<Comparison> const& comparisons);

/// What a criterion by check_line means, for readers.
std::string how_checks_are_made();

} // namespace mesobridge::workflows
