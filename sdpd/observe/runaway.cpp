#include "sdpd/observe/runaway.hpp"
#include "md/error.hpp"
#include <cmath>

namespace mesobridge::sdpd {

void refuse_runaway(Observation const& now, double dt) {
  if (!(now.T_kin < runaway_temperature))
    throw PhysicsError(
        fmt::format("step {} (dt = {:.6g} reduced): the kinetic temperature has grown to {:.3g} "
                    "times the set one: the motion is unstable; take a shorter time step",
                    now.step, dt, now.T_kin));
}

void refuse_not_finite(Observation const& now, double dt) {
  for (auto const& [name, value] : {std::pair("kinetic energy", now.kinetic),
                                    {"internal energy", now.internal},
                                    {"potential energy", now.potential},
                                    {"kinetic temperature", now.T_kin},
                                    {"internal temperature", now.T_int},
                                    {"pressure", now.P},
                                    {"density", now.rho}})
    if (!std::isfinite(value))
      throw PhysicsError(fmt::format("step {} (dt = {:.6g} reduced): the {} of the system is not finite any "
                                     "more: the motion is unstable; take a shorter time step",
                                     now.step, dt, name));
}

} // namespace mesobridge::sdpd
