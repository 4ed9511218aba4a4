#include "fitting/internal_energy.hpp"
#include "sdpd/thermodynamics/thermodynamics.hpp"
#include <limits>

namespace mesobridge::sdpd {
namespace {

/// Temperatures and heat capacities of particles that have no density (DPDE), in reduced units with k_B = 1.
template <class Model>
class InternalEnergies final : public Thermodynamics {
 public:
  InternalEnergies(Model model, double T_unit) : model_(std::move(model)), T_unit_(T_unit) {}

  /// Without a density the entropy fixes the energy: at constant entropies nothing changes.
  void from_entropy(Particles&, Range, Failure&) const override {}
  void from_energy(Particles& particles, Range range, Failure& failure) const override {
    for_each(particles, range, failure, [&](std::size_t i) {
      double const T = temperature(particles.eps[i], particles.T[i]);
      particles.caloric[i] = caloric(T);
      particles.T[i] = T;
    });
  }
  void response(Particles& particles, Range range, Failure& failure) const override {
    for_each(particles, range, failure,
             [&](std::size_t i) { particles.caloric[i] = caloric(particles.T[i]); });
  }
  void energy_from_temperature(Particles& particles, Range range, Failure& failure) const override {
    for_each(particles, range, failure,
             [&](std::size_t i) { particles.eps[i] = model_.energy(particles.T[i] * T_unit_) / T_unit_; });
  }

  ThermalState state(Particles const& particles, Index i, double eps) const override {
    double const T = temperature(eps, particles.T[i]);
    return {T, model_.entropy(T * T_unit_), 1 / model_.heat_capacity(T * T_unit_)};
  }
  Caloric caloric(Particles const&, Index, double eps, double T_guess) const override {
    return caloric(temperature(eps, T_guess));
  }
  std::optional<double> constant_heat_capacity() const override {
    if constexpr (Model::has_constant_heat_capacity)
      return model_.heat_capacity(T_unit_);
    else
      return std::nullopt;
  }
  double heat_capacity(Particles const& particles, Index i) const override {
    return model_.heat_capacity(particles.T[i] * T_unit_);
  }

 private:
  template <class F>
  void for_each(Particles const& particles, Range range, Failure& failure, F const& f) const {
    for (std::size_t i = range.begin; i < range.end; ++i) {
      try {
        f(i);
      } catch (std::exception const& error) {
        failure.report(particles.id[i], error.what());
      }
    }
  }
  double temperature(double eps, double T_guess) const {
    return model_.temperature(eps * T_unit_, T_guess * T_unit_) / T_unit_;
  }
  Caloric caloric(double T) const {
    double const C = model_.heat_capacity(T * T_unit_),
                 slope = model_.heat_capacity_slope(T * T_unit_) * T_unit_;
    return {.T_0 = T,
            .inverse_C_0 = 1 / C,
            .curvature = -0.5 * slope / (C * C * C),
            .limit = Model::has_constant_heat_capacity ? std::numeric_limits<double>::infinity()
                                                       : caloric_reach * T};
  }

  Model model_;
  double T_unit_;
};

} // namespace

std::unique_ptr<Thermodynamics const> make_thermodynamics(fitting::AnyInternalEnergy const& any,
                                                          ReducedUnits const& units) {
  return std::visit(
      [&]<class Model>(Model const& model) -> std::unique_ptr<Thermodynamics const> {
        return std::make_unique<InternalEnergies<Model>>(model, units.temperature);
      },
      any);
}

} // namespace mesobridge::sdpd
