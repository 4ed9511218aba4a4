#pragma once
#include "fitting/eos/linear_isochore.hpp"
#include "fitting/eos/monotone_root.hpp"
#include <optional>
#include <utility>

namespace mesobridge::fitting {

/// An isochore less the part of an ideal gas of particles: r = k_B/(K m0).
template <class Inner, class X>
class CentreOfMassFreeIsochore {
 public:
  CentreOfMassFreeIsochore(Inner const& inner, double r, double T_min, double T_max)
      : inner_(inner), r_(r), T_min_(T_min), T_max_(T_max) {}

  X density() const { return inner_.density(); }
  X energy(X T) const { return inner_.energy(T) - 1.5 * r_ * T; }
  X entropy(X T) const {
    using std::log;
    return inner_.entropy(T) - r_ * (1.5 * log(T) - log(inner_.density()));
  }
  X pressure(X T) const { return inner_.pressure(T) - inner_.density() * r_ * T; }
  X heat_capacity(X T) const { return inner_.heat_capacity(T) - 1.5 * r_; }
  X heat_capacity_slope(X T) const { return inner_.heat_capacity_slope(T); }
  X pressure_slope(X T) const { return inner_.pressure_slope(T) - inner_.density() * r_; }
  X pressure_density_slope(X T) const { return inner_.pressure_density_slope(T) - r_ * T; }

  double temperature_from_energy(double e, double T_guess) const {
    return solve("energy", e, T_guess, [&](double T) {
      return Jet{energy(T), heat_capacity(T), heat_capacity_slope(T)};
    });
  }
  double temperature_from_entropy(double s, double T_guess) const {
    return solve("entropy", s, T_guess, [&](double T) {
      double const c = heat_capacity(T);
      return Jet{entropy(T), c / T, (heat_capacity_slope(T) - c / T) / T};
    });
  }

 private:
  template <class F>
  double solve(std::string_view quantity, double target, double T_guess, F&& jet) const {
    double T_min = T_min_;
    if constexpr (requires { inner_.T_min(); })
      T_min = inner_.T_min();
    auto const T = solve_increasing(jet, target, T_min, T_max_, T_guess);
    if (!T)
      throw PhysicsError(fmt::format("centre-of-mass-free model at density {}: {} {} has no temperature "
                                     "between {} and {}",
                                     density(), quantity, target, T_min, T_max_));
    return *T;
  }

  Inner inner_;
  double r_, T_min_, T_max_;
};

/// The bulk whose particles of K atoms lose the part of their centre of mass.
template <EquationOfState E>
class BulkOfParticles {
 public:
  Domain domain() const { return bulk_.domain(); }
  double molecular_mass() const { return bulk_.molecular_mass(); }
  double boltzmann() const { return bulk_.boltzmann(); }
  E const& bulk() const { return bulk_; }
  double K() const { return K_; }

 protected:
  /// K >= 1; throws InputError.
  BulkOfParticles(E bulk, double K) : bulk_(std::move(bulk)), K_(K) {
    require(K >= 1 && std::isfinite(K), "particle size K", K, "must be >= 1 and finite");
    r_ = bulk_.boltzmann() / (K * bulk_.molecular_mass());
  }

  E bulk_;
  double K_, r_; ///< r = k_B/(K m0)
};

/// The equation of state of the inner degrees of freedom of a particle of K atoms (fitting/README.md,
/// Eq. (F13)). The particle's centre of mass, which moves in the simulation, carries (3/2) k_B T and the
/// pressure k_B T/V already; here they are taken from the bulk's, so that totals do not depend on K. Per unit
/// mass, m0 the mass of one atom:
///   f_K(rho, T) = f(rho, T) - (k_B/(K m0)) T (ln rho - 3/2 ln T).
/// The ideal gas becomes the law of K - 1 atoms. Needs c_v > 3/2 k_B/(K m0).
template <EquationOfState E>
class CentreOfMassFree : public FromIsochore<CentreOfMassFree<E>>, public BulkOfParticles<E> {
  using Base = BulkOfParticles<E>;
  using Base::bulk_, Base::r_;

 public:
  static constexpr std::string_view name = "centre-of-mass-free model";

  /// K >= 1; throws InputError.
  CentreOfMassFree(E bulk, double K) : Base(std::move(bulk), K) {
    auto const domain = bulk_.domain();
    T_max_ = domain.T_max;
    T_min_ = std::max(domain.T_min, coldest * domain.T_max);
  }

  template <class X>
  auto isochore(X rho) const {
    using Inner = decltype(bulk_.isochore(rho));
    return CentreOfMassFreeIsochore<Inner, X>(bulk_.isochore(rho), r_, T_min_, T_max_);
  }
  /// As those of the bulk, where it has them.
  auto packed_isochore(Pack rho) const requires requires(E const& bulk) { bulk.packed_isochore(rho); }
  {
    using Inner = decltype(bulk_.packed_isochore(rho));
    return CentreOfMassFreeIsochore<Inner, Pack>(bulk_.packed_isochore(rho), r_, T_min_, T_max_);
  }
  PackMask covers(Pack rho, Pack T) const { return bulk_.covers(rho, T); }
  void require_temperature(double T, double rho) const { bulk_.energy_from_temperature(T, rho); }
  double temperature_guess() const { return std::max(T_min_, 0.05 * T_max_); }

 private:
  /// Inversions of models that reach down to T = 0 stop here, in units of their highest temperature.
  static constexpr double coldest = 1e-12;

  double T_min_, T_max_;
};

/// The same in closed form for models whose isochores are linear: they stay linear.
template <EquationOfState E>
requires LinearModel<E>
class CentreOfMassFree<E> : public LinearEos<CentreOfMassFree<E>>, public BulkOfParticles<E> {
  using Base = BulkOfParticles<E>;
  using Base::bulk_, Base::r_;

 public:
  static constexpr std::string_view name = "centre-of-mass-free model";

  /// K >= 1 with c_v > 3/2 k_B/(K m0); throws InputError.
  CentreOfMassFree(E bulk, double K) : Base(std::move(bulk), K) {
    require(c_v() > 0, "particle size K", K, "the heat capacity must exceed that of the centre of mass");
  }

  template <class X>
  LinearLaw<X> law(X rho) const {
    using std::log;
    auto law = bulk_.law(rho);
    double const ratio = bulk_.c_v() / c_v(), part = r_ / c_v();
    law.Gamma = ratio * law.Gamma - part;
    law.rho_Gamma_slope = ratio * law.rho_Gamma_slope - part;
    law.phi = ratio * law.phi - part * log(rho);
    return law;
  }

  double c_v() const { return bulk_.c_v() - 1.5 * r_; }
  double rho_max() const { return bulk_.rho_max(); }
};

} // namespace mesobridge::fitting
