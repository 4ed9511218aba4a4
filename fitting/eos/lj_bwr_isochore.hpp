#pragma once
#include "fitting/eos/bwr_terms.hpp"
#include "fitting/eos/lj_scale.hpp"
#include <cmath>

namespace mesobridge::fitting {

/// The published or a fitted BWR equation of the Lennard-Jones fluid, in Lennard-Jones units.
struct LjBwrSet {
  bwr::Parameters x;
  double gamma;
  double T_low;   ///< below it the heat capacity stays C(rho, T_low)
  double T_max;   ///< states above are refused
  double rho_max; ///< states above are refused
};

/// The BWR equation at one density: the 32 parameters collapse into a few powers of temperature.
/// All arguments and results in the model's units (LjScale); temperatures must be > 0.
/// X is double, std::complex<double> for derivatives by complex steps, or Pack for many states at once.
template <class X>
class BasicLjBwrIsochore {
 public:
  BasicLjBwrIsochore(LjBwrSet const& set, bwr::Matrix const& M, LjScale const& scale, X rho)
      : BasicLjBwrIsochore(set, M, scale, rho, bwr::density_functions(X(rho / scale.density), set.gamma)) {}

  X density() const { return rho_ * scale_.density; }
  /// Residual free energy A_res (no ideal part).
  X residual_free_energy(X T) const { return e_unit() * A_.value(reduced(T)); }
  /// A = e - T s; zero of s: the ideal gas at rho* = T* = 1, i.e. s_ideal/k_B = (3/2) ln T* - ln rho* per
  /// atom.
  X free_energy(X T) const { return energy(T) - T * entropy(T); }
  X energy(X T) const {
    X const t = reduced(T);
    return e_unit() * (1.5 * t + A_.energy(t));
  }
  X entropy(X T) const {
    using std::log, std::sqrt;
    X const t = reduced(T);
    return scale_.specific_entropy() * (log(t * sqrt(t) / rho_) + A_.entropy(t));
  }
  X heat_capacity(X T) const { return scale_.specific_entropy() * (1.5 + A_.heat_capacity(reduced(T))); }
  X heat_capacity_slope(X T) const {
    return scale_.specific_entropy() * A_.heat_capacity_slope(reduced(T)) / scale_.temperature;
  }
  X pressure(X T) const {
    X const t = reduced(T);
    return scale_.pressure * (rho_ * t + P_.value(t));
  }
  X pressure_slope(X T) const {
    return scale_.pressure / scale_.temperature * (rho_ - P_.entropy(reduced(T)));
  }
  /// (dP/drho) at constant T
  X pressure_density_slope(X T) const {
    X const t = reduced(T);
    return e_unit() * (t + P_slope_.value(t));
  }

  /// Guarded Halley iterations from T_guess, two or three when it is near; see the Isochore concept.
  double temperature_from_energy(double e, double T_guess) const {
    double const target = e / e_unit();
    return scale_.temperature *
           solve([&](double t) { return energy_jet(t); }, target, T_guess, Given::energy);
  }
  double temperature_from_entropy(double s, double T_guess) const {
    double const target = s / scale_.specific_entropy();
    return scale_.temperature *
           solve([&](double t) { return entropy_jet(t); }, target, T_guess, Given::entropy);
  }

 private:
  enum class Given { energy, entropy };
  /// An increasing function of T with two derivatives.
  struct Jet {
    double value, slope, curvature;
  };

  BasicLjBwrIsochore(LjBwrSet const& set, bwr::Matrix const& M, LjScale const& scale, X rho,
                     bwr::DensityFunctions<X> const& basis)
      : A_(bwr::gather(M, basis.f), set.T_low), P_(bwr::gather(M, basis.p), set.T_low),
        P_slope_(bwr::gather(M, basis.q), set.T_low), rho_(rho / scale.density), T_max_(set.T_max),
        scale_(scale) {}

  double e_unit() const { return scale_.specific_energy; }
  X reduced(X T) const { return T / scale_.temperature; }

  Jet energy_jet(double t) const {
    return {1.5 * t + A_.energy(t), 1.5 + A_.heat_capacity(t), A_.heat_capacity_slope(t)};
  }
  Jet entropy_jet(double t) const {
    double const c = 1.5 + A_.heat_capacity(t), inverse = 1 / t;
    return {std::log(t * std::sqrt(t) / rho_) + A_.entropy(t), c * inverse,
            (A_.heat_capacity_slope(t) - c * inverse) * inverse};
  }

  template <class F>
  double solve(F&& jet, double target, double T_guess, Given given) const {
    double t = T_guess / scale_.temperature;
    // The error after a Halley step is of third order: a step below 1e-6 t leaves round-off only.
    for (int iteration = 0; iteration < 6 && t >= A_.T_low() && t <= T_max_; ++iteration) {
      Jet const f = jet(t);
      double const newton = (target - f.value) / f.slope;
      double const step = newton / (1 + 0.5 * newton * f.curvature / f.slope);
      t += step;
      if (std::abs(step) <= 1e-6 * t && t >= A_.T_low() && t <= T_max_)
        return t;
    }
    return solve_safely(target, given);
  }
  /// Bracketed solution over the whole domain and the closed form below T_low. Throws PhysicsError.
  double solve_safely(double target, Given given) const;
  double solve_in_bracket(double target, Given given) const;
  [[noreturn]] void refuse(double target, Given given, std::string_view why) const;

  ContinuedSeries<X> A_, P_, P_slope_;
  X rho_;        // reduced
  double T_max_; // reduced
  LjScale scale_;
};

using LjBwrIsochore = BasicLjBwrIsochore<double>;

} // namespace mesobridge::fitting
