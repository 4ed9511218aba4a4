#pragma once
#include "fitting/eos/evaluate.hpp"
#include "fitting/eos/mixture_parts.hpp"
#include "md/error.hpp"
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>

namespace mesobridge::fitting {

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
  double T, P, e, s, c_v;
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
/// Many states at once: mixture_packed.hpp.
template <EquationOfState Reactant, EquationOfState Product>
class Mixture {
  template <class E>
  using IsochoreOf = decltype(std::declval<E const&>().isochore(1.0));

 public:
  using At = MixtureAt<double, IsochoreOf<Reactant>, IsochoreOf<Product>>;

  Mixture(Reactant reactant, Product product, VolumeLaw law = VolumeLaw::additive_volume)
      : reactant_(std::move(reactant)), product_(std::move(product)), law_(law),
        reactant_rho_max_(reactant_.domain().rho_max), product_rho_max_(product_.domain().rho_max),
        T_max_(std::min(reactant_.domain().T_max, product_.domain().T_max)) {}

  /// The state at the progress, density and energy; `guess` is that of a nearby state.
  MixtureState state(double lambda, double rho, double e,
                     std::optional<MixtureSplit> const& guess = std::nullopt) const {
    return solve({lambda, rho, e, Given::energy}, guess);
  }

  /// The same at a given entropy s = (1 - lambda) s_0 + lambda s_1 instead of the energy.
  MixtureState state_from_entropy(double lambda, double rho, double s,
                                  std::optional<MixtureSplit> const& guess = std::nullopt) const {
    return solve({lambda, rho, s, Given::entropy}, guess);
  }

  /// e(T, rho) of the equilibrium, the inverse of the above.
  double energy_from_temperature(double lambda, double rho, double T) const {
    return state_from_temperature(lambda, rho, T).e;
  }
  MixtureState state_from_temperature(double lambda, double rho, double T) const;
  /// Both parts at a split, stable or not, 0 < lambda < 1; for callers that ask for little. Throws
  /// PhysicsError where a part is outside its model.
  At at(double lambda, double rho, MixtureSplit const& split) const {
    auto const d = mixture_densities(law_, lambda, rho, split.log_density_ratio);
    double const T = split.T;
    return {lambda,
            rho,
            T,
            d.share,
            {reactant_.isochore(d.reactant), d.reactant, T},
            {product_.isochore(d.product), d.product, T}};
  }

  Reactant const& reactant() const { return reactant_; }
  Product const& product() const { return product_; }
  VolumeLaw law() const { return law_; }

 private:
  enum class Given { energy, entropy, temperature };
  struct Problem {
    double lambda, rho, value;
    Given given;

    char const* name() const {
      return given == Given::energy ? "energy" : given == Given::entropy ? "entropy" : "temperature";
    }
  };
  /// The energy or the entropy of a trial, whichever is given.
  static double value(Problem const& p, At const& at) {
    return p.given == Given::entropy ? at.entropy() : at.energy();
  }

  static void validate(Problem const& p) {
    if (!(p.lambda >= 0 && p.lambda <= 1))
      throw PhysicsError(fmt::format("mixture: progress lambda = {} must lie in [0, 1]", p.lambda));
    if (!(p.rho > 0 && std::isfinite(p.rho) && std::isfinite(p.value)))
      throw PhysicsError(
          fmt::format("mixture: density {} must be > 0, {} {} finite", p.rho, p.name(), p.value));
  }

  [[noreturn]] static void refuse(Problem const& p, std::string_view why) {
    throw PhysicsError(fmt::format("mixture of progress {} at density {}, {} {}: {}", p.lambda, p.rho,
                                   p.name(), p.value, why));
  }

  At at(Problem const& p, MixtureSplit const& split) const { return at(p.lambda, p.rho, split); }
  static bool stable(At const& at) { return at.reactant.rho_P_rho > 0 && at.product.rho_P_rho > 0; }

  MixtureState solve(Problem const& p, std::optional<MixtureSplit> const& guess) const;
  std::optional<MixtureState> newton(Problem const& p, MixtureSplit const& split) const;
  std::optional<MixtureState> newton_steps(Problem const& p, MixtureSplit split) const;
  static MixtureState state_of(At const& at, double r);
  template <class E>
  static MixtureState pure(E const& eos, Problem const& p);

  /// Mechanical equilibrium at a given temperature: of several, the one with the densest reactant.
  struct Balanced {
    MixtureSplit split;
    double value; ///< energy or entropy
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
