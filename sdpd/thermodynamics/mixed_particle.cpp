#include "sdpd/thermodynamics/mixed_particle.hpp"
#include "fitting/eos/mixture_packed.hpp"
#include "sdpd/thermodynamics/particle_eos.hpp"
#include "sdpd/thermodynamics/reacting_part.hpp"

namespace mesobridge::sdpd {
namespace {

using fitting::Pack, fitting::PackMask;
using Mixture = fitting::Mixture<ReactingPart, ReactingPart>;
using PackedMixture = fitting::PackedMixture<ReactingPart, ReactingPart>;

} // namespace

struct MixedParticle::Model {
  Mixture mixture;
  double rho_unit, T_unit, e_unit, s_unit, P_unit, C_min;
  double R; ///< k_B/(K m0) of the centre of mass, which moves by itself; 0 where the bulk's part is kept

  PackedMixture packed() const { return PackedMixture(mixture); }
  fitting::MixtureSplit in_units(Split const& of) const { return {of.T * T_unit, of.log_density_ratio}; }

  /// What the centre of mass takes from the entropy beside its heat capacity.
  template <class X>
  X entropy_of_place(X rho) const {
    using std::log;
    return R * log(rho);
  }
  State state_of(fitting::MixtureState const& at, double rho) const {
    return {
        {at.T / T_unit, at.split.log_density_ratio}, at.e / e_unit, (at.s + entropy_of_place(rho)) / s_unit};
  }

  /// Of mixtures at a split: what they answer, and where that holds.
  struct Responses {
    Pack P, inverse_C, curvature, C;
    PackMask fine;
  };
  Responses responses(Pack lambda, Pack density, fitting::PackedSplit const& split) const {
    constexpr double rise = 1e-3; // relative, over which the heat capacity is seen to change
    auto const here = packed().at(lambda, density, split);
    auto const warmer = packed().at(
        lambda, density, {split.T * (1 + rise), split.log_density_ratio + here.r_T() * rise * split.T});
    Pack const C = here.heat_capacity() / s_unit,
               slope = (warmer.heat_capacity() / s_unit - C) / (rise / T_unit * split.T);
    return {(here.pressure() - density * R * split.T) / P_unit, 1.0 / C, -0.5 * slope / (C * C * C), C,
            packed().covered(here) & (C.v > C_min)};
  }
  Caloric caloric(double T, Responses const& of, int lane) const {
    return {.T_0 = T,
            .inverse_C_0 = of.inverse_C.v[lane],
            .curvature = of.curvature.v[lane],
            .limit = caloric_reach * T};
  }

  struct Loaded {
    Pack lambda, density;
    fitting::PackedSplit split;
  };
  Loaded load(Particles const& of, PackedPlaces const& places) const {
    return {places.load(of.progress),
            places.load(of.rho) * rho_unit,
            {places.load(of.T) * T_unit, places.load(of.log_density_ratio)}};
  }
  void store(PackedMixture::Solution const& found, PackedPlaces const& places, Particles& of) const {
    places.store(found.split.T / T_unit, found.solved, of.T);
    places.store(found.split.log_density_ratio, found.solved, of.log_density_ratio);
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
  auto state = of.state_of(of.mixture.state(lambda, density, eps * of.e_unit, of.in_units(guess)), density);
  state.eps = eps;
  return state;
}

auto MixedParticle::from_entropy(double lambda, double rho, double S, Split const& guess) const -> State {
  auto const& of = *model_;
  double const density = rho * of.rho_unit, s = S * of.s_unit - of.entropy_of_place(density);
  auto state = of.state_of(of.mixture.state_from_entropy(lambda, density, s, of.in_units(guess)), density);
  state.S = S;
  return state;
}

double MixedParticle::energy_from_temperature(double lambda, double rho, double T) const {
  auto const& of = *model_;
  return of.mixture.energy_from_temperature(lambda, rho * of.rho_unit, T * of.T_unit) / of.e_unit;
}

auto MixedParticle::response(double lambda, double rho, Split const& split) const -> Response {
  auto const& of = *model_;
  auto const found = of.responses(lambda, rho * of.rho_unit, {split.T * of.T_unit, split.log_density_ratio});
  double const C = found.C.v[0];
  if (!(C > of.C_min))
    throw PhysicsError(
        fmt::format("its heat capacity as a mixture of progress {} is {:.4g} k_B, not above {} "
                    "k_B; take larger particles",
                    lambda, least_heat_capacity * C / of.C_min, least_heat_capacity));
  if (!found.fine[0])
    throw PhysicsError(
        fmt::format("a mixture of progress {} at density {:.6g} is not stable", lambda, rho * of.rho_unit));
  return {found.P.v[0], of.caloric(split.T, found, 0)};
}

auto MixedParticle::stiffness(double lambda, double rho, Split const& split) const -> Stiffness {
  auto const& of = *model_;
  auto const at = of.packed().at(lambda, rho * of.rho_unit, {split.T * of.T_unit, split.log_density_ratio});
  return {(at.reactant.rho_P_rho / at.reactant.P).v[0], (at.product.rho_P_rho / at.product.P).v[0]};
}

auto MixedParticle::stiffnesses(Particles const& of, std::span<Index const> places) const -> Stiffnesses {
  auto const& model = *model_;
  auto const load = [&](std::vector<double> const& from) {
    Pack some = from[places.back()];
    for (std::size_t lane = 0; lane < places.size(); ++lane)
      some.v[static_cast<int>(lane)] = from[places[lane]];
    return some;
  };
  auto const at = model.packed().at(load(of.progress), load(of.rho) * model.rho_unit,
                                    {load(of.T) * model.T_unit, load(of.log_density_ratio)});
  Pack const reactant = at.reactant.rho_P_rho / at.reactant.P, product = at.product.rho_P_rho / at.product.P;
  Stiffnesses found;
  for (std::size_t lane = 0; lane < places.size(); ++lane)
    found[lane] = {reactant.v[static_cast<int>(lane)], product.v[static_cast<int>(lane)]};
  return found;
}

std::optional<double> MixedParticle::last_density(double lambda, double eps, double S, Split const& split,
                                                  double nearby) const try {
  constexpr int most_steps = 30;
  constexpr double longest_step = 0.1, last_step = 1e-9, same = 1e-9; // of ln rho; of heat capacity times T
  auto const& of = *model_;
  double log_rho = std::log(nearby * of.rho_unit), change = longest_step;
  for (int step = 0; step < most_steps; ++step) {
    double const density = std::exp(log_rho);
    auto const at = of.mixture.at(lambda, density, of.in_units(split));
    if (std::abs(change) < last_step) {
      bool const left_here = std::abs(at.energy() - eps * of.e_unit) < same * at.heat_capacity() * at.T;
      return left_here ? std::optional(density / of.rho_unit) : std::nullopt;
    }
    double const slope =
        (1 - lambda) * at.reactant.entropy_slope() + lambda * at.product.entropy_slope() + of.R;
    double const missing = S * of.s_unit - of.entropy_of_place(density) - at.entropy();
    change = std::clamp(missing / slope, -longest_step, longest_step);
    log_rho += change;
  }
  return std::nullopt;
} catch (PhysicsError const&) {
  return std::nullopt; // a step led out of a model
}

PackMask MixedParticle::from_energy(Particles& of, PackedPlaces const& places) const {
  auto const& model = *model_;
  auto const [lambda, density, guess] = model.load(of, places);
  auto const found = model.packed().from_energy(lambda, density, places.load(of.eps) * model.e_unit, guess);
  model.store(found, places, of);
  places.store((found.other + model.entropy_of_place(density)) / model.s_unit, found.solved, of.S);
  return found.solved;
}

PackMask MixedParticle::from_entropy(Particles& of, PackedPlaces const& places) const {
  auto const& model = *model_;
  auto const [lambda, density, guess] = model.load(of, places);
  Pack const s = places.load(of.S) * model.s_unit - model.entropy_of_place(density);
  auto const found = model.packed().from_entropy(lambda, density, s, guess);
  model.store(found, places, of);
  places.store(found.other / model.e_unit, found.solved, of.eps);
  return found.solved;
}

/// Not inlined: a restart must find the bits of the stopped run, and only the same machine code rounds alike.
[[gnu::noinline]] PackMask MixedParticle::response(Particles& of, PackedPlaces const& places) const {
  auto const& model = *model_;
  auto const [lambda, density, split] = model.load(of, places);
  auto const found = model.responses(lambda, density, split);
  places.store(found.P, found.fine, of.P);
  for (int lane = 0; lane < places.count; ++lane)
    if (found.fine[lane]) {
      auto const i = places.first + static_cast<std::size_t>(lane);
      of.caloric[i] = model.caloric(of.T[i], found, lane);
    }
  return found.fine;
}

} // namespace mesobridge::sdpd
