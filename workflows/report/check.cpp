#include "workflows/report/check.hpp"
#include "workflows/report/number_text.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <gsl/gsl_cdf.h>
#include <limits>
#include <stdexcept>

namespace mesobridge::workflows {
namespace {

constexpr double false_alarms = 1e-3; ///< of a check whose quantities are right

/// What is not a number is farther off than anything.
double distance(Comparison const& comparison) {
  double const size = std::abs(deviation(comparison));
  return std::isnan(size) ? std::numeric_limits<double>::infinity() : size;
}

Comparison const& farthest(std::vector<Comparison> const& comparisons) {
  if (comparisons.empty())
    throw std::logic_error("a check without a comparison");
  return *std::ranges::max_element(comparisons, {}, distance);
}

std::string deviation_text(Comparison const& comparison, std::size_t n) {
  return fmt::format("{:+.1f} se{}", deviation(comparison),
                     n == 1 ? "" : fmt::format(" (the farthest of {})", n));
}

} // namespace

double deviation(Comparison const& c) {
  double const se = std::hypot(c.found.se, c.expected.se), difference = c.found.mean - c.expected.mean;
  return se == 0 && difference == 0 ? 0 : difference / se;
}

double allowed_deviation(std::size_t n) {
  double const of_one = -std::expm1(std::log1p(-false_alarms) / static_cast<double>(n));
  return gsl_cdf_ugaussian_Qinv(of_one / 2);
}

VerdictLine check_line(std::string what, std::vector<Comparison> const& comparisons) {
  auto line = noted_line(std::move(what), comparisons);
  double const allowed = allowed_deviation(comparisons.size());
  bool const within = distance(farthest(comparisons)) <= allowed;
  line.verdict = within ? Verdict::passed : Verdict::failed;
  line.deviation += fmt::format("; allowed {:.1f}", allowed);
  return line;
}

VerdictLine noted_line(std::string what, std::vector<Comparison> const& comparisons) {
  auto const& [of, found, expected] = farthest(comparisons);
  return {.what = std::move(what),
          .found = fmt::format("{} = {}", of, with_error_text(found)),
          .expected = with_error_text(expected),
          .verdict = Verdict::noted,
          .deviation = deviation_text(farthest(comparisons), comparisons.size())};
}

std::string how_checks_are_made() {
  return fmt::format(
      "Each check compares a value ± its standard error (se) with a reference ± what the reference itself "
      "may "
      "be wrong by; the deviation is in the combined standard error. It is passed if the farthest of the "
      "compared values lies within the stated number of standard errors, which right values exceed in {:g} % "
      "of all reports: {:.1f} for one value, {:.1f} for the farthest of ten.",
      100 * false_alarms, allowed_deviation(1), allowed_deviation(10));
}

} // namespace mesobridge::workflows
