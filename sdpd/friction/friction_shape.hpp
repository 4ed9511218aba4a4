#pragma once
#include "md/error.hpp"
#include "sdpd/friction/bath.hpp"
#include "sdpd/potential/uniform_table.hpp"
#include <variant>

namespace mesobridge::sdpd {

/// Friction coefficients gamma_theta (1 - r/r_c)^s of a pair at distance r, zero beyond the cut-off r_c; s =
/// 2 is the customary chi^2 with chi = 1 - r/r_c.
class PowerFriction {
 public:
  PowerFriction(double par, double perp, double cutoff, double exponent)
      : par_(par), perp_(perp), inverse_cutoff_(1 / cutoff), exponent_(exponent) {
    auto coefficient = [](char const* name, double value) {
      require(value >= 0 && std::isfinite(value), name, value, "must be >= 0 and finite");
    };
    coefficient("friction gamma_par", par), coefficient("friction gamma_perp", perp);
    require(cutoff > 0 && std::isfinite(cutoff), "friction cutoff", cutoff, "must be > 0 and finite");
    require(exponent > 0 && exponent <= 20, "friction exponent", exponent, "must be > 0 and <= 20");
  }
  PowerFriction in_units(double length, double friction) const {
    return {par_ / friction, perp_ / friction, 1 / (inverse_cutoff_ * length), exponent_};
  }
  bool has_across() const { return perp_ > 0; }
  double cutoff() const { return 1 / inverse_cutoff_; }

  template <class X>
  [[gnu::always_inline]] PairWeights<X> operator()(X const& r) const {
    X const left = 1.0 - r * constant<X>(inverse_cutoff_), zero = 0.0 * r;
    X const weight = left > constant<X>(0) ? (exponent_ == 2 ? left * left : power(left, exponent_)) : zero;
    return {constant<X>(par_) * weight, constant<X>(perp_) * weight};
  }

 private:
  double par_, perp_, inverse_cutoff_, exponent_;
};

/// Friction coefficients from a table over r: monotone (Steffen) between its points, so never negative;
/// constant below the first point and zero from the last on.
class TabulatedFriction {
 public:
  /// r rising, gamma >= 0; an empty `perp` is friction along the line of centres alone. Throws InputError.
  TabulatedFriction(std::vector<double> const& r, std::vector<double> const& par,
                    std::vector<double> const& perp);
  TabulatedFriction in_units(double length, double friction) const {
    return {has_across_, table_.scaled(1 / length, 1 / friction)};
  }
  bool has_across() const { return has_across_; }
  double cutoff() const { return table_.end(); }

  template <class X>
  [[gnu::always_inline]] PairWeights<X> operator()(X const& r) const {
    X const zero = 0.0 * r;
    auto const [par, par_slope, perp, perp_slope, t] = table_.at(r);
    X const a = par + t * par_slope, b = perp + t * perp_slope;
    X const end = constant<X>(table_.end());
    return {r < end ? a : zero, r < end ? b : zero};
  }

 private:
  TabulatedFriction(bool has_across, UniformTable table)
      : has_across_(has_across), table_(std::move(table)) {}
  bool has_across_;
  UniformTable table_;
};

using AnyWeightFunction = std::variant<PowerFriction, TabulatedFriction>;

inline AnyWeightFunction in_units(AnyWeightFunction const& shape, double length, double friction) {
  return std::visit([&](auto const& of) -> AnyWeightFunction { return of.in_units(length, friction); },
                    shape);
}

} // namespace mesobridge::sdpd
