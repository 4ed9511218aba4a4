#pragma once
#include "cg/entropy_curve.hpp"
#include "cg/estimate.hpp"
#include "cg/jackknife.hpp"
#include <functional>
#include <span>
#include <vector>

namespace mesobridge::cg {

/// Intrinsic energies of molecules at one inverse temperature (or at none), with their kinetic parts, block
/// by block; the blocks are independent. k_B = 1.
struct EnergySamples {
  double beta = 0;
  std::vector<std::vector<double>> U, U_kin; ///< [block][sample]
  /// Where beta was measured on the same blocks: what it is without each. Empty: it is exact.
  std::vector<double> beta_without;

  std::size_t count() const;
};

/// The routes from samples to S(U) (cg/README.md, Eq. (C12)-(C14)), all to the coefficients of one curve.
enum class EntropyRoute {
  density, ///< ln P(U) + beta U, by maximum likelihood; several temperatures together (as WHAM does)
  kinetic, ///< 1/T = (n/2 - 1)<1/E_kin>^U with n = 3N - 3, exact for a molecule of fixed momentum
};

/// A curve and how it came about.
struct EntropyFit {
  EntropyCurve curve;
  std::vector<EntropyCurve> without; ///< the curve without each block: for the errors of whatever comes of it
  std::size_t samples = 0;

  /// T or C or any number of the curve, with its jackknife error.
  Estimate estimate(std::function<double(EntropyCurve const&)> const& number) const;
};

/// How the curve is made.
struct EntropySettings {
  std::size_t order = 3; ///< terms of the curve
  double tail = 1e-3;    ///< the part of the samples on each side that lies beyond U_low ... U_high
};

/// S(U) by one route. `atoms` of a molecule. Density: the samples may have different temperatures; the others
/// put all samples together. Throws InputError for fewer than 4 blocks, PhysicsError when the fit has no
/// solution with T, C > 0.
EntropyFit fit_entropy(std::span<EnergySamples const> samples, EntropyRoute route, int atoms,
                       EntropySettings const& settings);

/// The thesis's estimator (cg/README.md, Eq. (C13)): T(U) = 2<E_kin>^U/(3N), as a parabola through the
/// samples. At fixed momentum it is low by about 1/N.
class Equipartition {
 public:
  Equipartition(std::span<EnergySamples const> samples, int atoms);

  Estimate T(double U) const;
  Estimate C(double U) const; ///< dU/dT
  /// The straight line's dU/dT, as the thesis takes it.
  Estimate slope_C() const;

 private:
  double U_ref_ = 0, width_ = 1;
  std::vector<std::vector<double>> coefficients_; ///< without each block; the last one with all
  std::vector<std::vector<double>> lines_;        ///< the same of a straight line
};

/// The same as binned WHAM finds it without any assumption on its form: S on equal bins, up to a constant,
/// with jackknife errors against the bin with the most samples. Bins with fewer than 20 samples are left out.
struct WhamEntropy {
  std::vector<double> U;
  std::vector<Estimate> S; ///< against S at U_reference
  double U_reference = 0;
  int iterations = 0;
};
WhamEntropy wham(std::span<EnergySamples const> samples, std::size_t bins);

/// T(U) on bins by a kinetic route, without any assumption on its form.
struct KineticTemperature {
  std::vector<double> U;                 ///< mean energy of the samples in the bin
  std::vector<Estimate> T_exact;         ///< 1/((n/2 - 1)<1/E_kin>)
  std::vector<Estimate> T_equipartition; ///< 2<E_kin>/(3N)
};
KineticTemperature kinetic_temperature(std::span<EnergySamples const> samples, int atoms, std::size_t bins);

} // namespace mesobridge::cg
