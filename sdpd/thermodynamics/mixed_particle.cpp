#include "sdpd/thermodynamics/mixed_particle.hpp"
#include "fitting/eos/mixture.hpp"
#include "sdpd/thermodynamics/particle_eos.hpp"
#include "sdpd/thermodynamics/reacting_part.hpp"

namespace mesobridge::sdpd {
namespace {

using Mixture = fitting::Mixture<ReactingPart, ReactingPart>;
using Split = MixedParticle::Split;

/// Of a trace of product in the reactant: ln(rho_1/rho_0) at which the product has the reactant's pressure.
std::optional<double> trace_in(ReactingPart const& reactant, ReactingPart const& product, double rho,
                               double T) {
  double const P = reactant.isochore(rho).pressure(T);
  auto const gap = [&](double r) { return product.isochore(rho * std::exp(r)).pressure(T) - P; };
  double below = -3, above = 1;
  if (!(gap(below) < 0 && gap(above) > 0))
    return std::nullopt;
  for (int halving = 0; halving < 40; ++halving) {
    double const r = 0.5 * (below + above);
    (gap(r) < 0 ? below : above) = r;
  }
  return above;
}

} // namespace

struct MixedParticle::Model {
  Mixture mixture;
  double rho_unit, T_unit, e_unit, s_unit, P_unit, C_min;
  double R; ///< k_B/(K m0) of the centre of mass, which moves by itself; 0 where the bulk's part is kept

  /// Nothing where nobody knows: then a search begins.
  std::optional<fitting::MixtureSplit> guess(double lambda, double rho, Split const& from) const {
    constexpr double trace = 0.01;
    double const T = from.T * T_unit;
    if (from.log_density_ratio != 0)
      return fitting::MixtureSplit{T, from.log_density_ratio};
    if (lambda > trace)
      return std::nullopt;
    auto const r = trace_in(mixture.reactant(), mixture.product(), rho, T);
    return r ? std::optional(fitting::MixtureSplit{T, *r}) : std::nullopt;
  }
  /// What the centre of mass takes from the entropy beside its heat capacity.
  double entropy_of_place(double rho) const { return R * std::log(rho); }

  State state_of(fitting::MixtureState const& at, double rho, double eps) const {
    return {{at.T / T_unit, at.split.log_density_ratio}, eps, (at.s + entropy_of_place(rho)) / s_unit};
  }
};

MixedParticle::MixedParticle(ReactingModels const& models, ReducedUnits const& units,
                             CentreOfMass centre_of_mass) {
  double const R = centre_of_mass == CentreOfMass::free ? units.boltzmann / units.mass() : 0;
  model_ = std::make_unique<Model const>(
      Mixture(ReactingPart(models.reactant, R), ReactingPart(models.product, R),
              models.additive_volumes ? fitting::VolumeLaw::additive_volume : fitting::VolumeLaw::paper),
      units.density, units.temperature, units.specific_energy(), units.specific_entropy(), units.pressure(),
      least_heat_capacity / units.K, R);
}
MixedParticle::~MixedParticle() = default;
MixedParticle::MixedParticle(MixedParticle&&) noexcept = default;

auto MixedParticle::from_energy(double lambda, double rho, double eps, Split const& guess) const -> State {
  auto const& of = *model_;
  double const density = rho * of.rho_unit;
  return of.state_of(of.mixture.state(lambda, density, eps * of.e_unit, of.guess(lambda, density, guess)),
                     density, eps);
}

/// Halley's steps in the energy: ds/de = 1/T and dT/de = 1/c_v.
auto MixedParticle::from_entropy(double lambda, double rho, double S, double eps_guess,
                                 Split const& guess) const -> State {
  constexpr double round_off = 2e-13, longest = 0.3; // of the entropy, in the heat capacity
  constexpr int most_steps = 60;
  auto const& of = *model_;
  double const density = rho * of.rho_unit, s = S * of.s_unit - of.entropy_of_place(density);
  double e = eps_guess * of.e_unit;
  auto near = of.guess(lambda, density, guess);
  for (int k = 0; k < most_steps; ++k) {
    auto const at = of.mixture.state(lambda, density, e, near);
    double const missing = std::clamp((s - at.s) / at.c_v, -longest, longest);
    near = at.split;
    if (std::abs(missing) < round_off) {
      auto state = of.state_of(at, density, e / of.e_unit);
      state.S = S;
      return state;
    }
    e += at.c_v * at.T * missing * (1 + 0.5 * missing);
  }
  throw PhysicsError(fmt::format("mixture of progress {} at density {}: no energy was found for entropy {}",
                                 lambda, density, s));
}

double MixedParticle::energy_from_temperature(double lambda, double rho, double T) const {
  auto const& of = *model_;
  return of.mixture.energy_from_temperature(lambda, rho * of.rho_unit, T * of.T_unit) / of.e_unit;
}

auto MixedParticle::response(double lambda, double rho, Split const& split) const -> Response {
  constexpr double rise = 1e-3; // relative, over which the heat capacity is seen to change
  auto const& of = *model_;
  double const density = rho * of.rho_unit, T = split.T * of.T_unit;
  auto const here = of.mixture.at(lambda, density, {T, split.log_density_ratio});
  auto const warmer =
      of.mixture.at(lambda, density, {T * (1 + rise), split.log_density_ratio + here.r_T() * rise * T});
  double const C = here.heat_capacity() / of.s_unit,
               slope = (warmer.heat_capacity() / of.s_unit - C) / (rise * split.T);
  if (!(C > of.C_min))
    throw PhysicsError(
        fmt::format("its heat capacity as a mixture of progress {} is {:.4g} k_B, not above {} "
                    "k_B; take larger particles",
                    lambda, least_heat_capacity * C / of.C_min, least_heat_capacity));
  return {(here.pressure() - density * of.R * T) / of.P_unit,
          {.T_0 = split.T,
           .inverse_C_0 = 1 / C,
           .curvature = -0.5 * slope / (C * C * C),
           .limit = caloric_reach * split.T}};
}

auto MixedParticle::stiffness(double lambda, double rho, Split const& split) const -> Stiffness {
  auto const& of = *model_;
  auto const at = of.mixture.at(lambda, rho * of.rho_unit, {split.T * of.T_unit, split.log_density_ratio});
  return {at.reactant.rho_P_rho / at.reactant.P, at.product.rho_P_rho / at.product.P};
}

} // namespace mesobridge::sdpd
