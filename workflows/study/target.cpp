#include "workflows/study/target.hpp"
#include "workflows/scene/tolerance.hpp"

namespace mesobridge::workflows {

Target parse_target(std::optional<std::string> const& drift, std::optional<std::string> const& bias,
                    std::optional<std::string> const& dynamics, UnitSystem units, double time) {
  Target target;
  if (drift)
    target.drift = parse_rate(*drift, units) * time;
  if (bias)
    target.bias = parse_share(*bias);
  if (dynamics)
    target.dynamics = parse_share(*dynamics);
  return target;
}

} // namespace mesobridge::workflows
