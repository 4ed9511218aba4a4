#pragma once
#include "fitting/eos/evaluate.hpp"
#include "fitting/eos/linear_isochore.hpp"
#include "fitting/eos_data.hpp"
#include "fitting/root.hpp"
#include <concepts>

namespace mesobridge::fitting {

/// A model whose e and P are linear in T along every isochore.
template <class Model>
concept FittableModel = EquationOfState<Model> && std::derived_from<Model, LinearEos<Model>>;

/// Where an observation ends up in a model. Velocities are zero for states that no shock made.
struct ReachedState {
  double rho, T, e, P;
  double v_P = 0, v_S = 0;
};

/// The shocks into one state ahead, for models linear in T: on the isochore behind, the Hugoniot's energy is
/// linear too, so that at given density the curve is a closed form, and at given v_P, v_S or P one equation
/// in x = 1 - rho_0/rho remains. Fits ask it millions of times; shock_relations.hpp is the thorough way to a
/// shock: it knows which of them are stable. Energies are the model's own.
template <FittableModel Model>
class LinearHugoniot {
 public:
  LinearHugoniot(Model const& model, double rho_0, double e_0, double P_0)
      : model_(model), rho_0_(rho_0), e_0_(e_0), P_0_(P_0) {}

  ReachedState at_density(double rho) const {
    double const w = volume_change(x_of(rho));
    auto const isochore = model_.isochore(rho);
    // e_0 + (P + P_0) w/2 = E + c_v T with P = P(0) + P_T T
    double const heat = e_0_ + 0.5 * (isochore.pressure(0.0) + P_0_) * w - isochore.energy(0.0);
    double const capacity = isochore.heat_capacity(0.0) - 0.5 * isochore.pressure_slope(0.0) * w;
    double const T = heat / capacity;
    if (!(capacity > 0 && T > 0))
      throw PhysicsError(
          fmt::format("{}: density {} cannot be reached by one shock from {}", Model::name, rho, rho_0_));
    return moving(rho, T, isochore.energy(T), isochore.pressure(T));
  }

  ReachedState at_piston(double v_P) const {
    auto const energy = [&](double x) { return e_0_ + P_0_ * volume_change(x) + 0.5 * v_P * v_P; };
    double const x =
        first_zero([&](double at) { return at * (pressure(at, energy(at)) - P_0_) - rho_0_ * v_P * v_P; }, 0,
                   -rho_0_ * v_P * v_P, "v_P", v_P);
    return with_energy(x, energy(x));
  }

  ReachedState at_speed(double v_S) const {
    double const momentum = rho_0_ * v_S * v_S; // P = P_0 + momentum x
    auto const energy = [&](double x) { return e_0_ + (P_0_ + 0.5 * momentum * x) * volume_change(x); };
    auto const excess = [&](double x) { return (pressure(x, energy(x)) - P_0_) / x - momentum; };
    constexpr double weakest = 1e-6;
    double const f = excess(weakest);
    if (!(f < 0))
      throw PhysicsError(
          fmt::format("{}: v_S = {} is below the sound speed at density {}", Model::name, v_S, rho_0_));
    double const x = first_zero(excess, weakest, f, "v_S", v_S);
    return with_energy(x, energy(x));
  }

  ReachedState at_pressure(double P) const {
    auto const energy = [&](double x) { return e_0_ + 0.5 * (P + P_0_) * volume_change(x); };
    auto const excess = [&](double x) { return pressure(x, energy(x)) - P; };
    double const f = excess(0);
    if (!(f < 0))
      throw PhysicsError(fmt::format("{}: pressure {} is not above that ahead of the shock", Model::name, P));
    double const x = first_zero(excess, 0, f, "P", P);
    return with_energy(x, energy(x));
  }

  /// The sonic point: behind the slowest detonation the products leave at their sound speed.
  ReachedState chapman_jouguet() const {
    auto const excess = [&](double x) {
      auto const state = at_density(rho_of(x));
      double const c_2 = sound_speed_squared(model_.isochore(state.rho), state.T);
      return state.rho * state.rho * c_2 - (state.P - P_0_) / volume_change(x);
    };
    constexpr double weakest = 1e-3; // compression of the products: real ones come near 0.25
    double const f = excess(weakest);
    if (!(f < 0))
      throw PhysicsError(
          fmt::format("{}: no detonation from density {} with energy {}", Model::name, rho_0_, e_0_));
    return at_density(rho_of(first_zero(excess, weakest, f, "the Chapman-Jouguet density above", rho_0_)));
  }

 private:
  double x_of(double rho) const { return 1 - rho_0_ / rho; }
  double rho_of(double x) const { return rho_0_ / (1 - x); }
  double volume_change(double x) const { return x / rho_0_; }
  double pressure(double x, double e) const {
    auto const isochore = model_.isochore(rho_of(x));
    double const T = (e - isochore.energy(0.0)) / isochore.heat_capacity(0.0);
    return isochore.pressure(T);
  }

  ReachedState moving(double rho, double T, double e, double P) const {
    double const w = 1 / rho_0_ - 1 / rho, squared = (P - P_0_) * w;
    if (!(w > 0 && squared > 0))
      throw PhysicsError(fmt::format("{}: from density {} to {} there is no compression by a shock",
                                     Model::name, rho_0_, rho));
    double const v_P = std::sqrt(squared);
    return {rho, T, e, P, v_P, v_P / (w * rho_0_)};
  }

  ReachedState with_energy(double x, double e) const {
    auto const isochore = model_.isochore(rho_of(x));
    double const T = isochore.temperature_from_energy(e, 1);
    return moving(rho_of(x), T, e, isochore.pressure(T));
  }

  /// Steps of growing compression from x = a, f(a) < 0, until f > 0; then bracketed.
  template <class F>
  double first_zero(F&& f, double a, double f_a, char const* what, double value) const {
    constexpr double step = 0.08, densest = 0.95;
    double const x_max = std::min(densest, 1 - rho_0_ / model_.rho_max());
    for (double x = std::max(2 * a, step);; x += step) {
      double const b = x < x_max ? x : x_max * (1 - 1e-9);
      double const f_b = f(b);
      if (f_b >= 0)
        return bracketed_zero(f, a, f_a, b, f_b);
      if (x >= x_max)
        throw PhysicsError(fmt::format("{}: {} = {} is not reached from density {} at any compression",
                                       Model::name, what, value, rho_0_));
      a = b, f_a = f_b;
    }
  }

  Model const& model_;
  double rho_0_, e_0_, P_0_;
};

/// Temperature at which an isochore has the pressure P. Throws PhysicsError if none > 0.
template <FittableModel Model>
double temperature_from_pressure(Model const& model, double P, double rho) {
  auto const isochore = model.isochore(rho);
  double const T = (P - isochore.pressure(0.0)) / isochore.pressure_slope(0.0);
  if (!(T > 0 && std::isfinite(T)))
    throw PhysicsError(
        fmt::format("{} at density {}: no temperature > 0 has pressure {}", Model::name, rho, P));
  return T;
}

/// `energy_offset`: an energy of the data minus that of the model at the same state.
template <FittableModel Model>
ReachedState start_of(Model const& model, StartState const& start, double energy_offset) {
  if (start.e && start.P)
    return {.rho = start.rho, .T = 0, .e = *start.e - energy_offset, .P = *start.P};
  auto const isochore = model.isochore(start.rho);
  double const T = start.T   ? *start.T
                   : start.e ? isochore.temperature_from_energy(*start.e - energy_offset, 1)
                             : temperature_from_pressure(model, *start.P, start.rho);
  return {.rho = start.rho, .T = T, .e = isochore.energy(T), .P = isochore.pressure(T)};
}

/// Where the observation ends up in the model. Throws PhysicsError when it is out of the model's reach.
template <FittableModel Model>
ReachedState reach(Model const& model, Observation const& observation, double energy_offset) {
  auto const given = [&](Quantity quantity) -> double const* {
    for (auto const& datum : observation.given)
      if (datum.quantity == quantity)
        return &datum.value;
    return nullptr;
  };
  if (observation.path == DataPath::state) {
    double const rho = *given(Quantity::rho);
    auto const isochore = model.isochore(rho);
    auto const* const temperature = given(Quantity::T);
    double const T =
        temperature ? *temperature : isochore.temperature_from_energy(*given(Quantity::e) - energy_offset, 1);
    return {.rho = rho, .T = T, .e = isochore.energy(T), .P = isochore.pressure(T)};
  }
  auto const start = start_of(model, *observation.start, energy_offset);
  if (observation.path == DataPath::isentrope) {
    double const rho = *given(Quantity::rho);
    auto const isochore = model.isochore(rho);
    double const T = isochore.temperature_from_entropy(model.isochore(start.rho).entropy(start.T), 1);
    return {.rho = rho, .T = T, .e = isochore.energy(T), .P = isochore.pressure(T)};
  }
  LinearHugoniot<Model> const shocks(model, start.rho, start.e, start.P);
  if (observation.path == DataPath::cj)
    return shocks.chapman_jouguet();
  if (auto const* const rho = given(Quantity::rho))
    return shocks.at_density(*rho);
  if (auto const* const v_P = given(Quantity::v_P))
    return shocks.at_piston(*v_P);
  if (auto const* const v_S = given(Quantity::v_S))
    return shocks.at_speed(*v_S);
  return shocks.at_pressure(*given(Quantity::P));
}

/// What would be measured there.
template <FittableModel Model>
double quantity_of(Model const& model, ReachedState const& state, Quantity quantity, double energy_offset) {
  switch (quantity) {
  case Quantity::rho:
    return state.rho;
  case Quantity::T:
    return state.T;
  case Quantity::e:
    return state.e + energy_offset;
  case Quantity::P:
    return state.P;
  case Quantity::v_P:
    return state.v_P;
  case Quantity::v_S:
    return state.v_S;
  case Quantity::c_v:
    return model.isochore(state.rho).heat_capacity(state.T);
  case Quantity::sound_speed: {
    double const c_2 = sound_speed_squared(model.isochore(state.rho), state.T);
    if (!(c_2 >= 0))
      throw PhysicsError(fmt::format("{} at density {}, temperature {}: no sound speed, its square is {}",
                                     Model::name, state.rho, state.T, c_2));
    return std::sqrt(c_2);
  }
  }
  throw std::logic_error("an unknown quantity");
}

} // namespace mesobridge::fitting
