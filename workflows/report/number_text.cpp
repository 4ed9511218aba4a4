#include "workflows/report/number_text.hpp"
#include "md/error.hpp"

namespace mesobridge::workflows {

std::string with_error_text(cg::Estimate const& estimate) {
  if (!(estimate.se > 0) || !std::isfinite(estimate.mean))
    return number_text(estimate.mean);
  // A power of ten is split off where plain decimals would be long.
  double const size = std::max(std::abs(estimate.mean), estimate.se);
  int const exponent = static_cast<int>(std::floor(std::log10(size)));
  bool const scientific = exponent >= 6 || exponent < -4;
  double const scale = scientific ? std::pow(10.0, -exponent) : 1;
  int const error_exponent = static_cast<int>(std::floor(std::log10(estimate.se * scale)));
  int const decimals = std::max(0, 1 - error_exponent);
  auto const text =
      fmt::format("{:.{}f} ± {:.{}f}", estimate.mean * scale, decimals, estimate.se * scale, decimals);
  return scientific ? fmt::format("({})e{}", text, exponent) : text;
}

std::string number_text(double value, int digits) {
  return fmt::format("{:.{}g}", value, digits);
}

} // namespace mesobridge::workflows
