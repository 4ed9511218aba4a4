#pragma once
#include "cg/blob_series.hpp"
#include "cg/estimate.hpp"
#include <string>
#include <vector>

namespace mesobridge::cg {

/// A quantity along an axis, one estimate a bin.
struct Profile {
  std::vector<double> x; ///< centres of the bins
  std::vector<Estimate> y;
};

/// The relative error |P(K,U) - P(K)P(U)|/P(K,U) on a grid of bins; signed here, so that noise can average
/// out.
struct RelativeErrorMap {
  std::vector<double> K, U;      ///< centres of the bins
  std::vector<Estimate> error;   ///< number k * U.size() + u: 1 - P(K)P(U)/P(K,U)
  std::vector<bool> computed;    ///< false: too few samples
  double typical = 0;            ///< root of the mean square over the computed bins, weighted by P(K,U)
  double typical_from_noise = 0; ///< what independent K and U would give with as many samples
};

/// One test of the key approximation: how far from it, in size and in standard errors.
struct KeyTest {
  std::string name;
  Estimate deviation;    ///< from what the key approximation says, which is 0
  double in_se = 0;      ///< the deviation in standard errors
  std::string statement; ///< for people
};

struct CorrelationSettings {
  double h = 10;          ///< range of the Lucy density
  double bin_width = 0.2; ///< of g(r), u(r)
  std::size_t density_bins = 12;
  std::size_t map_bins = 12;   ///< along each axis
  std::size_t pair_stride = 1; ///< frames between those whose pairs are looked at
};

/// All tests of the key approximation for a melt (cg/README.md, Eq. (C8)-(C11)). Means are over all molecules
/// and frames, errors by the jackknife over blocks in time.
struct Correlations {
  MemoryTime tau_P, tau_U, tau_rho; ///< of momentum, intrinsic energy and local density
  double tau_R = 0;                 ///< time in which a centre diffuses by the mean distance of molecules
  Estimate D;                       ///< diffusion coefficient of the centres, from tau_P
  std::size_t blocks = 0;
  double block_time = 0;

  Estimate beta;     ///< of the Maxwellian of P_x
  Estimate kurtosis; ///< <P_x^4>/(3 <P_x^2>^2) - 1: 0 for a Maxwellian
  Estimate U_mean, U_variance, K_mean;
  Estimate C_KU, C_UD, density_mean, density_variance;
  double C_KU_expected = 0; ///< what a fixed total energy makes of independent K and U
  Profile P_x, P_U;         ///< probability densities
  RelativeErrorMap map;
  Profile g, u;            ///< radial distribution of the centres and its energy-weighted twin
  Profile u_minus_g;       ///< their difference, whose error is far below those of the two
  Profile pair_energy;     ///< <U1 U2>^r/<U>^2
  double contact = 0;      ///< where g(r) first reaches 1/2: nearer pairs are in contact
  Estimate contact_energy; ///< <U1 U2>/<U>^2 of all pairs in contact
  Profile U_of_density;    ///< <U>^rho / <U> - 1 against rho
  /// The same by configurational energies W = U - U_kin + <U_kin>. In equilibrium the momenta do not depend
  /// on the positions, so that <W1 W2>^r = <U1 U2>^r and <W>^rho = <U>^rho, with far less noise.
  struct Configurational {
    Profile u_minus_g, pair_energy, U_of_density;
    Estimate contact_energy, C_UD;
  } configurational;
  /// One instant of all molecules: translational energy, intrinsic energy, local density.
  std::vector<double> K_snapshot, U_snapshot, density_snapshot;
  std::vector<KeyTest> tests;

  /// The test of that name, which must be there.
  KeyTest const& test(std::string const& name) const;
};

/// Throws InputError for a series of fewer than two molecules or without a box, TooShort when the run is
/// shorter than 8 blocks of 6 autocorrelation times.
Correlations correlations(BlobSeries const& series, CorrelationSettings const& settings);

/// Lucy's kernel of range h in three dimensions (sdpd/README.md, Eq. (S3)).
double lucy(double r, double h);

} // namespace mesobridge::cg
