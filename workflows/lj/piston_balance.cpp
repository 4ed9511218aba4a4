#include "workflows/lj/piston_balance.hpp"
#include <algorithm>
#include <numeric>

namespace mesobridge::workflows {

std::optional<PistonBalance> balance_of(PistonData const& data) {
  if (data.energy.size() < 2 || data.energy.size() != data.frames.size())
    return std::nullopt;
  auto const &first = data.frames.front(), &last = data.frames.back();
  double const width = data.scale.position[1] - data.scale.position[0], time = last.time - first.time;
  double const area = double(data.atoms) / (width * std::accumulate(first.rho.begin(), first.rho.end(), 0.0));
  auto const momentum = [&](sdpd::ShockFrame const& of) { // per area
    return width * std::inner_product(of.rho.begin(), of.rho.end(), of.velocity.begin(), 0.0);
  };
  // Few, for the run ends when the front is eight slices from the end.
  auto const far = static_cast<std::ptrdiff_t>(std::clamp<std::size_t>(first.P.size() / 10, 1, 4));
  double P_0 = 0;
  for (auto const& frame : data.frames)
    P_0 +=
        std::accumulate(frame.P.end() - far, frame.P.end(), 0.0) / double(far) / double(data.frames.size());
  return PistonBalance{(data.energy.back() - data.energy.front()) / (area * data.scale.v_P * time),
                       (momentum(last) - momentum(first)) / time + P_0};
}

} // namespace mesobridge::workflows
