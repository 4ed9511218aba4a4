#pragma once
#include "fitting/eos/evaluate.hpp"
#include "md/error.hpp"
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>

namespace mesobridge::fitting {

/// How the volumes of the parts make that of the mixture (fitting/README.md, Eq. (F12)).
enum class VolumeLaw {
  additive_volume, ///< 1/rho = (1 - lambda)/rho_0 + lambda/rho_1: the parts lie beside each other
  paper            ///< rho = (1 - lambda) rho_0 + lambda rho_1, thesis (6.7)
};

/// Where the parts of a mixture are: all that its other quantities follow from, and what the next solution
/// of a nearby state starts from.
struct MixtureSplit {
  double T;
  double log_density_ratio; ///< ln(rho_1/rho_0)
};

/// One state of a mixture, per unit mass of it.
struct MixtureState {
  MixtureSplit split;
  double rho_reactant, rho_product;
  double T, P, s, c_v;
  double sound_speed_squared; ///< at constant s and lambda; may be < 0 in tension
};

/// Reactant (0) and product (1) at the progress lambda in [0, 1], in mechanical and thermal equilibrium:
/// equal T and P, e = (1 - lambda) e_0 + lambda e_1 (fitting/README.md, Eq. (F12)). At lambda = 0
/// and 1 the pure equation of state answers.
///
/// With additive volumes T, P and c follow from the one entropy s = (1 - lambda) s_0 + lambda s_1, which is
/// maximal at the equilibrium: T ds = de + P dv holds, and a scheme that relies on it conserves energy. With
/// the paper's law it does not; c^2 is then that of de = -P dv.
///
/// The two equations are solved for T and ln(rho_1/rho_0), so that all densities tried are positive, by
/// Newton's method from the guess; without one, or where that fails, by a bracketed search. The relative
/// error is about 1e-12. An equilibrium must be stable: dP/drho > 0 in either part, c_v > 0. The search takes
/// the reactant for condensed: it does not look beyond its spinodal, where models of condensed matter are
/// thinned out to a gas that they say nothing about (HZ keeps a pressure of GPa at zero density and thousands
/// of K). Of several equilibria it finds the one with the densest reactant; a guess leads to the one nearby.
/// PhysicsError where there is none: hot products of low pressure cannot balance such a reactant.
///
/// No scene and no command reaches it yet: it waits for particles that react.
template <EquationOfState Reactant, EquationOfState Product>
class Mixture {
 public:
  Mixture(Reactant reactant, Product product, VolumeLaw law = VolumeLaw::additive_volume)
      : reactant_(std::move(reactant)), product_(std::move(product)), law_(law),
        reactant_rho_max_(reactant_.domain().rho_max), product_rho_max_(product_.domain().rho_max),
        T_max_(std::min(reactant_.domain().T_max, product_.domain().T_max)) {}

  /// The state at the progress, density and energy; `guess` is that of a nearby state.
  MixtureState state(double lambda, double rho, double e,
                     std::optional<MixtureSplit> const& guess = std::nullopt) const {
    validate(lambda, rho, e);
    if (lambda == 0)
      return pure(reactant_, rho, e);
    if (lambda == 1)
      return pure(product_, rho, e);
    Problem const problem{lambda, rho, e};
    auto const found = guess ? newton(problem, *guess) : std::nullopt;
    return found ? *found : search(problem);
  }

  /// e(T, rho) of the equilibrium, the inverse of the above.
  double energy_from_temperature(double lambda, double rho, double T) const {
    validate(lambda, rho, T);
    if (lambda == 0)
      return reactant_.energy_from_temperature(T, rho);
    if (lambda == 1)
      return product_.energy_from_temperature(T, rho);
    Problem const problem{lambda, rho, 0};
    auto const found = T > 0 ? balanced(problem, T) : std::nullopt;
    if (!found)
      refuse(problem, fmt::format("at temperature {} no densities of the parts balance", T));
    return found->energy;
  }

  Reactant const& reactant() const { return reactant_; }
  Product const& product() const { return product_; }
  VolumeLaw law() const { return law_; }

 private:
  struct Problem {
    double lambda, rho, e;
  };
  struct Densities {
    double reactant, product;
    double share; ///< of the product in the volume (additive) or the density (paper): d ln rho_0/d ln(ratio)
                  ///< = -share
  };

  /// One part at its density and the common temperature.
  struct Part {
    double rho, e, P, c_v, P_T;
    double rho_P_rho, e_log_rho; ///< dP/d ln rho and de/d ln rho at constant T
  };
  template <class E>
  static Part part(E const& eos, double rho, double T) {
    auto const isochore = eos.isochore(rho);
    double const P = isochore.pressure(T), P_T = isochore.pressure_slope(T);
    return {.rho = rho,
            .e = isochore.energy(T),
            .P = P,
            .c_v = isochore.heat_capacity(T),
            .P_T = P_T,
            .rho_P_rho = rho * isochore.pressure_density_slope(T),
            .e_log_rho = (P - T * P_T) / rho};
  }

  /// Both parts at a trial split, with the two conditions of equilibrium and their derivatives.
  struct Parts {
    double lambda, share, T;
    Part reactant, product;

    double energy() const { return (1 - lambda) * reactant.e + lambda * product.e; }
    bool stable() const { return reactant.rho_P_rho > 0 && product.rho_P_rho > 0; }
    double pressure_gap() const { return product.P - reactant.P; }
    // Derivatives by r = ln(rho_1/rho_0) at constant T and total density, and by T at constant r.
    double gap_r() const { return (1 - share) * product.rho_P_rho + share * reactant.rho_P_rho; }
    double gap_T() const { return product.P_T - reactant.P_T; }
    double energy_r() const {
      return lambda * (1 - share) * product.e_log_rho - (1 - lambda) * share * reactant.e_log_rho;
    }
    double energy_T() const { return (1 - lambda) * reactant.c_v + lambda * product.c_v; }
  };

  static void validate(double lambda, double rho, double e) {
    if (!(lambda >= 0 && lambda <= 1))
      throw PhysicsError(fmt::format("mixture: progress lambda = {} must lie in [0, 1]", lambda));
    if (!(rho > 0 && std::isfinite(rho) && std::isfinite(e)))
      throw PhysicsError(
          fmt::format("mixture: density {} must be > 0, energy or temperature {} finite", rho, e));
  }

  [[noreturn]] static void refuse(Problem const& p, std::string_view why) {
    throw PhysicsError(
        fmt::format("mixture of progress {} at density {}, energy {}: {}", p.lambda, p.rho, p.e, why));
  }

  Densities densities(Problem const& p, double r) const {
    bool const additive = law_ == VolumeLaw::additive_volume;
    double const ratio = std::exp(r), product_weight = additive ? p.lambda / ratio : p.lambda * ratio;
    double const sum = 1 - p.lambda + product_weight, reactant = additive ? p.rho * sum : p.rho / sum;
    return {reactant, reactant * ratio, product_weight / sum};
  }

  /// Throws PhysicsError where a part is outside its model.
  Parts parts(Problem const& p, MixtureSplit const& split) const {
    auto const d = densities(p, split.log_density_ratio);
    return {p.lambda, d.share, split.T, part(reactant_, d.reactant, split.T),
            part(product_, d.product, split.T)};
  }

  std::optional<MixtureState> newton(Problem const& p, MixtureSplit const& split) const;
  std::optional<MixtureState> newton_steps(Problem const& p, MixtureSplit split) const;
  MixtureState state_of(Problem const& p, Parts const& parts, double r) const;
  template <class E>
  MixtureState pure(E const& eos, double rho, double e) const;

  /// Mechanical equilibrium at a given temperature: of several, the one with the densest reactant.
  struct Balanced {
    MixtureSplit split;
    double energy;
  };
  std::optional<Balanced> balanced(Problem const& p, double T) const;
  /// P_1 - P_0, which turns from negative to positive at a balance.
  struct Gap {
    double value;
    bool reactant_stable;
  };
  Gap gap(Problem const& p, MixtureSplit const& split) const;
  std::optional<Balanced> balanced_between(Problem const& p, double T, double r_below, double r_above) const;
  MixtureState search(Problem const& p) const;
  std::optional<MixtureState> between(Problem const& p, Balanced below, Balanced above) const;
  std::optional<MixtureState> at_edge(Problem const& p, Balanced inside, double T_outside) const;

  Reactant reactant_;
  Product product_;
  VolumeLaw law_;
  double reactant_rho_max_, product_rho_max_, T_max_;
};

} // namespace mesobridge::fitting

#include "fitting/eos/mixture_solve.hpp"
