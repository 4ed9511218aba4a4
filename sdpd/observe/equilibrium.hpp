#pragma once
#include "cg/estimate.hpp"
#include "sdpd/observe/observation.hpp"
#include "sdpd/state/snapshot.hpp"
#include <span>

namespace mesobridge::sdpd {

/// The rate alpha at which the relative energy error (E - E_0)/E_0 grows, per reduced unit of time.
struct Drift {
  double rate = 0, se = 0;
};

/// Slope of E/E_0 - 1 by least squares; its standard error from the scatter of the slopes of eight equal
/// segments, so that the memory of the series does not matter. Throws InputError for fewer than 32 samples.
Drift energy_drift(std::span<double const> times, std::span<double const> energies);

/// How many of the samples, from the first on, belong to the temperature at which they begin: those before
/// the energy is first further than `heat` from energies[0].
std::size_t samples_before_heating(std::span<double const> energies, double heat);

/// Mean and variance over the particles of one quantity, each averaged over instants.
struct ParticleMoments {
  cg::Estimate mean, variance;
};

/// What a run at equilibrium says, in reduced units.
struct Equilibrium {
  cg::Estimate T_kin, T_int, P;
  ParticleMoments eps, rho, P_i;
  cg::Estimate pairing; ///< see pairing.hpp; SDPD
  cg::Estimate crystal; ///< see bond_order.hpp; SDPD
  Drift drift;
};

/// Means and variances over the particles at one instant.
struct InstantMoments {
  double eps_mean, eps_variance, rho_mean, rho_variance, P_mean, P_variance;
  double pairing = 0; ///< see pairing.hpp
  double crystal = 0; ///< see bond_order.hpp
};
/// But for pairing and crystal, which the lists of neighbours tell.
InstantMoments moments(Snapshot const& now);

/// Collects samples of a run at equilibrium. Scalars may be sampled often; moments of the particles now and
/// then.
class EquilibriumSampler {
 public:
  explicit EquilibriumSampler(Features features = {}) : features_(features) {}

  void sample(double time, double energy, double T_kin, double T_int, double P);
  void sample(Observation const& now, double time) {
    sample(time, now.energy(), now.T_kin, now.T_int, now.P);
  }
  void sample(InstantMoments const& now) { moments_.push_back(now); }

  /// Throws InputError for fewer than 32 samples or, where particles have energies, 16 instants.
  Equilibrium result() const;

  std::span<double const> times() const { return times_; }
  std::span<double const> energies() const { return energies_; }
  std::span<double const> T_kin() const { return T_kin_; }
  std::span<double const> T_int() const { return T_int_; }
  std::span<double const> P() const { return P_; }
  std::vector<double> at_instants(double InstantMoments::*quantity) const;

 private:
  cg::Estimate internal_temperature() const;
  ParticleMoments estimate(double InstantMoments::*mean, double InstantMoments::*variance) const;

  Features features_;
  std::vector<double> times_, energies_, T_kin_, T_int_, P_;
  std::vector<InstantMoments> moments_;
};

} // namespace mesobridge::sdpd
