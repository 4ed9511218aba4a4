#pragma once
#include "cg/entropy.hpp"

namespace mesobridge::cg {

/// Maximum likelihood for the coefficients of an entropy curve from energies sampled at known temperatures:
/// P_k(U) = exp(S(U) - beta_k U)/Z_k on the sampled range. The likelihood is concave and depends on the data
/// only through the means of the basis functions, so it has one solution, found by Newton's method.
class DensityFit {
 public:
  DensityFit(EntropyCurve::Basis const& basis, double U_low, double U_high);

  /// What a block brings: the number of samples and the sums of the basis functions, for each temperature.
  Sums sums(std::span<EnergySamples const> samples, std::size_t block) const;

  /// The coefficients at these inverse temperatures; `start` (may be empty) is a guess. Throws PhysicsError
  /// when there is no solution.
  std::vector<double> solve(Sums const& sums, std::vector<double> const& betas,
                            std::vector<double> start) const;

 private:
  struct Slope {
    double value = 0;
    std::vector<double> gradient, hessian;
  };
  Slope likelihood(Sums const& sums, std::vector<double> const& betas,
                   std::vector<double> const& theta) const;

  EntropyCurve::Basis basis_;
  std::vector<double> U_, weight_;             ///< quadrature
  std::vector<std::vector<double>> functions_; ///< at its points
};

} // namespace mesobridge::cg
