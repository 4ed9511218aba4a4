#include "cg/entropy_curve.hpp"
#include "md/error.hpp"

namespace mesobridge::cg {

double EntropyCurve::Basis::y(double U) const {
  return std::log((U - U_0) / (U_ref - U_0)) / width;
}

std::vector<double> EntropyCurve::Basis::functions(double U) const {
  std::vector<double> result(order);
  double const at = y(U);
  double power = 1;
  for (double& value : result)
    value = power *= at;
  return result;
}

std::vector<double> EntropyCurve::Basis::slopes(double U) const {
  std::vector<double> result(order);
  double const at = y(U), y_slope = 1 / ((U - U_0) * width);
  double power = 1;
  for (std::size_t j = 0; j < order; ++j, power *= at)
    result[j] = double(j + 1) * power * y_slope;
  return result;
}

EntropyCurve::EntropyCurve(Basis const& basis, std::vector<double> theta, double U_low, double U_high)
    : basis_(basis), theta_(std::move(theta)), U_low_(U_low), U_high_(U_high), low_(border(U_low)),
      high_(border(U_high)) {
  require(theta_.size() == basis.order, "coefficients of an entropy curve", theta_.size(),
          "must be as many as its order");
}

double EntropyCurve::inside(double U, int derivative) const {
  double const y = basis_.y(U);
  double S = 0, S_y = 0, S_yy = 0;
  double power = 1; // y^(j-1)
  for (std::size_t j = 1; j <= theta_.size(); ++j, power *= y) {
    double const term = theta_[j - 1] * power, order = double(j);
    S += term * y;
    S_y += order * term;
    S_yy += y != 0 ? order * (order - 1) * term / y : (j == 2 ? 2 * theta_[1] : 0);
  }
  double const above = U - basis_.U_0, y_U = 1 / (above * basis_.width);
  if (derivative == 0)
    return S;
  if (derivative == 1)
    return S_y * y_U;
  return y_U * (S_yy * y_U - S_y / above);
}

EntropyCurve::Border EntropyCurve::border(double U) const {
  double const inverse_T = inside(U, 1), curvature = inside(U, 2);
  if (!(inverse_T > 0) || !(curvature < 0))
    throw PhysicsError(
        fmt::format("the entropy curve has 1/T = {:.4g} and d^2S/dU^2 = {:.4g} at U = {:.4g}, the "
                    "border of what was sampled: T and C must be positive. Lower the order, or "
                    "sample more",
                    inverse_T, curvature, U));
  return {U, inside(U, 0), 1 / inverse_T, -inverse_T * inverse_T / curvature};
}

double EntropyCurve::continued_T(Border const& border, double U) {
  double const T = border.T + (U - border.U) / border.C;
  if (!(T > 0))
    throw PhysicsError(fmt::format("U = {:.6g} is below {:.6g}, where the entropy curve has reached T = 0", U,
                                   border.U - border.C * border.T));
  return T;
}

double EntropyCurve::S(double U) const {
  if (U >= U_low_ && U <= U_high_)
    return inside(U, 0);
  Border const& border = U < U_low_ ? low_ : high_;
  return border.S + border.C * std::log(continued_T(border, U) / border.T);
}

double EntropyCurve::inverse_T(double U) const {
  if (U >= U_low_ && U <= U_high_)
    return inside(U, 1);
  return 1 / continued_T(U < U_low_ ? low_ : high_, U);
}

double EntropyCurve::C(double U) const {
  if (U >= U_low_ && U <= U_high_) {
    double const inverse_T = inside(U, 1);
    return -inverse_T * inverse_T / inside(U, 2);
  }
  return U < U_low_ ? low_.C : high_.C;
}

} // namespace mesobridge::cg
