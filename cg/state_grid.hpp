#pragma once
#include "cg/estimate.hpp"
#include "md/thermo_sample.hpp"
#include <span>
#include <vector>

namespace mesobridge::cg {

/// What one NVT run tells of its state, in Lennard-Jones units, per atom.
struct StatePoint {
  double rho = 0; ///< set density
  double T = 0;   ///< set temperature
  int atoms = 0;
  Estimate T_kin;    ///< measured kinetic temperature
  Estimate U;        ///< total energy per atom
  Estimate P;        ///< pressure
  Estimate c_v;      ///< heat capacity per atom in k_B, from the fluctuations of U
  double cov_UP = 0; ///< covariance of the two means U and P (they come from one run)
  double tau_U = 0;  ///< integrated autocorrelation time of U, in samples
  double tau_P = 0;
  std::size_t samples = 0;   ///< kept
  std::size_t discarded = 0; ///< cut as equilibration
};

/// The equation-of-state table of one fluid: the input of `fit lj-bwr`.
struct StateGrid {
  std::vector<StatePoint> points;
};

/// Detects and cuts the equilibration, then estimates every quantity of the point with its standard error.
/// The measured kinetic parts of U and P are replaced by the exact ones at the set temperature, which lowers
/// the noise; so the samples must come from the canonical ensemble
/// (cg/README.md, Eq. (C5)). In Lennard-Jones units. Throws InputError for fewer than 40
/// samples or a sample that is not finite, PhysicsError when fewer than 10 independent samples remain.
StatePoint analyse_state(double rho, double T, int atoms, std::span<md::ThermoSample const> samples);

} // namespace mesobridge::cg
