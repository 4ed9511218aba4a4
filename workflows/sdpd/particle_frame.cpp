#include "workflows/sdpd/particle_frame.hpp"
#include "md/error.hpp"
#include <cmath>

namespace mesobridge::workflows {
namespace {

void check_number(double value, std::string const& name, std::int64_t step) {
  if (!std::isfinite(value))
    throw PhysicsError(fmt::format("{} holds a {} at step {}: the frame is not written", name, value, step));
}

} // namespace

void ParticleFrame::check() const {
  for (auto const& [name, vectors] : {std::pair{"position", &positions}, std::pair{"velocity", &velocities}})
    for (Vec3 const& v : *vectors)
      check_number(norm2(v), name, step);
  for (auto const& [name, values] : scalars)
    for (double const value : values)
      check_number(value, name, step);
}

} // namespace mesobridge::workflows
