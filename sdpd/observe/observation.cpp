#include "sdpd/observe/observation.hpp"

namespace mesobridge::sdpd {

Observation observe(Particles const& particles, Box const& box, double virial, double boltzmann,
                    std::uint64_t step) {
  std::size_t const n = particles.size();
  std::vector<Index> place(n);
  for (std::size_t i = 0; i < n; ++i)
    place[particles.id[i]] = static_cast<Index>(i);
  Observation sum;
  sum.step = step;
  for (Index const i : place) {
    sum.kinetic += 0.5 * norm2(particles.p[i]);
    sum.internal += particles.eps[i];
    sum.T_int += particles.T[i];
    sum.rho += particles.rho[i];
    sum.momentum += particles.p[i];
  }
  double const count = static_cast<double>(n);
  double const thermal = sum.kinetic - 0.5 * norm2(sum.momentum) / count; // without the motion of the whole
  sum.T_kin = 2 * thermal / (3 * (count - 1) * boltzmann);
  sum.T_int /= count;
  sum.rho /= count;
  sum.P = count * boltzmann * sum.T_kin / box.volume() + virial / (3 * box.volume());
  return sum;
}

} // namespace mesobridge::sdpd
