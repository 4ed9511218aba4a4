#pragma once
#include <vector>

namespace mesobridge::cg {

/// The entropy of a molecule as a function of its intrinsic energy, S/k_B = sum_j theta_j y^j with
/// y = ln((U - U_0)/(U_ref - U_0))/width, j = 1 ... m, where U_0 is about the least energy of the molecule.
/// One term alone is a harmonic molecule, S = (C) ln(U - U_0). Between U_low and U_high it was sampled;
/// beyond, the heat capacity is the border's. k_B = 1. (cg/README.md, Eq. (C15))
class EntropyCurve {
 public:
  struct Basis {
    double U_ref = 1, width = 1;
    std::size_t order = 3;
    double U_0 = 0; ///< below every energy

    double y(double U) const;
    /// y, y^2 ... y^m at U > U_0.
    std::vector<double> functions(double U) const;
    /// Their derivatives to U.
    std::vector<double> slopes(double U) const;
  };

  EntropyCurve(Basis const& basis, std::vector<double> theta, double U_low, double U_high);

  /// S against that at U_ref. Each throws PhysicsError where the continued curve has reached T = 0.
  double S(double U) const;
  double inverse_T(double U) const; ///< dS/dU
  double T(double U) const { return 1 / inverse_T(U); }
  double C(double U) const; ///< dU/dT

  double U_low() const { return U_low_; }
  double U_high() const { return U_high_; }
  /// T = 0 here: the lowest energy that the continued curve knows.
  double U_zero() const { return U_low_ - low_.C * low_.T; }
  Basis const& basis() const { return basis_; }
  std::vector<double> const& theta() const { return theta_; }

 private:
  struct Border {
    double U, S, T, C;
  };
  double inside(double U, int derivative) const;
  Border border(double U) const;
  /// The temperature of the continued curve.
  static double continued_T(Border const& border, double U);

  Basis basis_;
  std::vector<double> theta_;
  double U_low_, U_high_;
  Border low_, high_;
};

} // namespace mesobridge::cg
