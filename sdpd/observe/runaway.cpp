#include "sdpd/observe/runaway.hpp"
#include "md/error.hpp"

namespace mesobridge::sdpd {

void refuse_runaway(Observation const& now, double dt) {
  if (!(now.T_kin < runaway_temperature))
    throw PhysicsError(
        fmt::format("step {} (dt = {:.6g} reduced): the kinetic temperature has grown to {:.3g} "
                    "times the set one: the motion is unstable; take a shorter time step",
                    now.step, dt, now.T_kin));
}

} // namespace mesobridge::sdpd
