#pragma once
#include "fitting/eos/evaluate.hpp"
#include "fitting/eos/list.hpp"
#include <memory>

namespace mesobridge::fitting {

/// Any equation of state behind one interface, for work that looks for states by the hundred (shocks, waves,
/// tables) and is compiled once for all models. Loops over particles take the model itself.
class Fluid {
 public:
  template <EquationOfState E>
  explicit Fluid(E eos) : model_(std::make_shared<Model<E> const>(std::move(eos))) {}
  explicit Fluid(AnyEos const& any) : Fluid(std::visit([](auto const& eos) { return Fluid(eos); }, any)) {}

  /// The whole state; each throws PhysicsError outside the model.
  EosState at_temperature(double rho, double T) const { return model_->at_temperature(rho, T); }
  EosState at_energy(double rho, double e) const { return model_->at_energy(rho, e); }
  EosState at_entropy(double rho, double s) const { return model_->at_entropy(rho, s); }
  double pressure(double rho, double e) const { return model_->pressure(rho, e); }
  Domain domain() const { return model_->domain(); }
  /// k_B/m0, the natural unit of heat capacities.
  double gas_constant() const { return model_->gas_constant(); }

  /// The same fluid with a mean field, e + a rho and P + a rho^2 at given rho and T, which leaves entropies
  /// as they are (fitting/README.md, Eq. (F27)). Any sign of a.
  Fluid with_mean_field(double a) const { return Fluid(std::make_shared<MeanField const>(model_, a)); }

 private:
  struct Interface {
    virtual ~Interface() = default;
    virtual EosState at_temperature(double rho, double T) const = 0;
    virtual EosState at_energy(double rho, double e) const = 0;
    virtual EosState at_entropy(double rho, double s) const = 0;
    virtual double pressure(double rho, double e) const = 0;
    virtual Domain domain() const = 0;
    virtual double gas_constant() const = 0;
  };

  template <class E>
  struct Model : Interface {
    explicit Model(E eos) : eos(std::move(eos)) {}
    EosState at_temperature(double rho, double T) const override {
      return state_from_temperature(eos, rho, T);
    }
    EosState at_energy(double rho, double e) const override { return state_from_energy(eos, rho, e); }
    EosState at_entropy(double rho, double s) const override { return state_from_entropy(eos, rho, s); }
    double pressure(double rho, double e) const override { return eos.pressure(e, rho); }
    Domain domain() const override { return eos.domain(); }
    double gas_constant() const override { return eos.boltzmann() / eos.molecular_mass(); }
    E eos;
  };

  struct MeanField : Interface {
    MeanField(std::shared_ptr<Interface const> without, double a) : inner(std::move(without)), a(a) {}
    EosState at_temperature(double rho, double T) const override {
      return add(inner->at_temperature(rho, T));
    }
    EosState at_energy(double rho, double e) const override {
      return add(inner->at_energy(rho, e - a * rho));
    }
    EosState at_entropy(double rho, double s) const override { return add(inner->at_entropy(rho, s)); }
    double pressure(double rho, double e) const override {
      return inner->pressure(rho, e - a * rho) + a * rho * rho;
    }
    Domain domain() const override { return inner->domain(); }
    double gas_constant() const override { return inner->gas_constant(); }
    EosState add(EosState state) const {
      double const e = a * state.rho;
      state.e += e, state.free_energy += e, state.P += e * state.rho;
      state.sound_speed_squared += 2 * e;
      state.sound_speed.reset();
      if (state.sound_speed_squared >= 0)
        state.sound_speed = std::sqrt(state.sound_speed_squared);
      if (state.alpha_r)
        *state.alpha_r += e / (gas_constant() * state.T);
      return state;
    }
    std::shared_ptr<Interface const> inner;
    double a;
  };

  explicit Fluid(std::shared_ptr<Interface const> model) : model_(std::move(model)) {}

  std::shared_ptr<Interface const> model_;
};

} // namespace mesobridge::fitting
