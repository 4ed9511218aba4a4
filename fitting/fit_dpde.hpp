#pragma once
#include "cg/entropy.hpp"
#include "fitting/internal_energy.hpp"
#include <vector>

namespace mesobridge::fitting {

/// Where the heat capacity of a blob is told, in reduced units. Beyond the sampled energies it stays what it
/// is at their border.
struct DpdeRange {
  double T_min = 0.05, T_max = 10; ///< must hold the sampled temperatures
  std::size_t points = 33;         ///< in the sampled range
};

/// C(T) of a DPDE particle made of an entropy curve, in reduced units, k_B = 1.
struct DpdeFit {
  std::vector<double> T_table, C_table;        ///< the model: C between them is interpolated
  double eps_min = 0;                          ///< internal energy at the first T
  std::vector<double> T;                       ///< temperatures of the table inside the sampled range
  std::vector<cg::Estimate> C, eps;            ///< heat capacity and energy at them, with their errors
  std::vector<std::vector<double>> covariance; ///< of the heat capacities at T, by the jackknife
  double T_sampled_low = 0, T_sampled_high = 0;
};

/// Tables C(T) of a curve so that it is positive everywhere (a PhysicsError says where it is not). Throws
/// InputError for a range that does not hold the sampled temperatures.
DpdeFit fit_dpde(cg::EntropyFit const& fit, DpdeRange const& range);

/// The internal energy of a DPDE particle with the fit's C(T).
TabulatedHeatCapacity internal_energy_of(DpdeFit const& fit);

} // namespace mesobridge::fitting
