#pragma once
#include "sdpd/method/settings.hpp"
#include <functional>

namespace mesobridge::sdpd {

/// Mean internal energy of an SDPD particle of density rho under the invariant measure at the set
/// temperature, exp(S/k_B - eps/k_BT)/T deps (sdpd/README.md, Eq. (S17)), by quadrature. The mean of T under
/// it is the set temperature exactly; the energy is not that of the equation of state, because C changes
/// with T: the difference is about (dC/dT) k_B T^2/2C, some hundredths of k_BT whatever the size. Both in the
/// reduced units of the settings. Throws PhysicsError where the model has no such density, InputError for
/// several species.
class CanonicalEnergy {
 public:
  explicit CanonicalEnergy(SimulationSettings const& settings);
  double operator()(double rho) const { return mean_(rho); }

 private:
  std::function<double(double)> mean_;
};

} // namespace mesobridge::sdpd
