#include "sdpd/thermodynamics/reacting.hpp"

namespace mesobridge::sdpd {
namespace {

enum class Kind { reactant, mixed, product };

Kind kind_of(Particles const& of, std::size_t i) {
  double const progress = of.progress[i];
  return progress < pure_below                   ? Kind::reactant
         : progress > pure_above                 ? Kind::product
         : of.log_density_ratio[i] == no_product ? Kind::reactant
                                                 : Kind::mixed;
}

double molecular_mass(fitting::AnyEos const& any) {
  return std::visit([](auto const& eos) { return eos.molecular_mass(); }, any);
}

/// Particles of mass 1 of the product, however many of its molecules that is.
std::unique_ptr<Thermodynamics const> product_of(ReactingModels const& models, ReducedUnits const& units,
                                                 CentreOfMass centre_of_mass) {
  return make_thermodynamics(models.product, units, centre_of_mass,
                             {.K = units.mass() / molecular_mass(models.product), .mass = 1});
}

/// Hands pure particles on to the models of reactant and product, neighbours in memory of the same kind
/// together, and solves the mixtures of the others.
class Reacting final : public Thermodynamics {
 public:
  Reacting(ReactingModels const& models, ReducedUnits const& units, CentreOfMass centre_of_mass)
      : reactant_(make_thermodynamics(models.reactant, units, centre_of_mass)),
        product_(product_of(models, units, centre_of_mass)), mixed_(models, units, centre_of_mass) {}

  void from_entropy(Particles& of, Range range, Failure& failure) const override {
    renew(
        of, range, failure, [&](auto const& pure, Range run) { pure.from_entropy(of, run, failure); },
        [&](PackedPlaces const& places) { return mixed_.from_entropy(of, places); },
        [&](std::size_t i) { from_entropy(of, i, failure); });
  }
  void from_energy(Particles& of, Range range, Failure& failure) const override {
    renew(
        of, range, failure, [&](auto const& pure, Range run) { pure.from_energy(of, run, failure); },
        [&](PackedPlaces const& places) { return mixed_.from_energy(of, places); },
        [&](std::size_t i) { from_energy(of, i, failure); });
  }
  void temperature_from_energy(Particles& of, Range range, Failure& failure) const override {
    for_each_run(
        of, range, [&](auto const& pure, Range run) { pure.temperature_from_energy(of, run, failure); },
        [&](Range run) {
          solve(
              of, run, failure, [&](PackedPlaces const& places) { return mixed_.from_energy(of, places); },
              [&](std::size_t i) { from_energy(of, i, failure); }, [](PackedPlaces const&) {});
        });
  }
  void response(Particles& of, Range range, Failure& failure) const override {
    renew(
        of, range, failure, [&](auto const& pure, Range run) { pure.response(of, run, failure); },
        [](PackedPlaces const&) { return ~fitting::PackMask{}; }, [](std::size_t) {});
  }
  void energy_from_temperature(Particles& of, Range range, Failure& failure) const override {
    for_each_run(
        of, range, [&](auto const& pure, Range run) { pure.energy_from_temperature(of, run, failure); },
        [&](Range run) {
          for (std::size_t i = run.begin; i < run.end; ++i)
            reported(of, i, failure,
                     [&] { of.eps[i] = mixed_.energy_from_temperature(of.progress[i], of.rho[i], of.T[i]); });
        });
  }

  ThermalState state(Particles const& of, Index i, double eps) const override {
    if (auto const* const pure = pure_of(of, i))
      return pure->state(of, i, eps);
    auto const state = mixed_.from_energy(of.progress[i], of.rho[i], eps, split(of, i));
    return {state.split.T, state.S,
            mixed_.response(of.progress[i], of.rho[i], state.split).caloric.inverse_C_0};
  }
  Caloric caloric(Particles const& of, Index i, double eps, double T_guess) const override {
    if (auto const* const pure = pure_of(of, i))
      return pure->caloric(of, i, eps, T_guess);
    auto const state = mixed_.from_energy(of.progress[i], of.rho[i], eps, {T_guess, of.log_density_ratio[i]});
    return mixed_.response(of.progress[i], of.rho[i], state.split).caloric;
  }
  std::optional<double> constant_heat_capacity() const override { return std::nullopt; }
  double heat_capacity(Particles const& of, Index i) const override {
    if (auto const* const pure = pure_of(of, i))
      return pure->heat_capacity(of, i);
    return 1 / mixed_.response(of.progress[i], of.rho[i], split(of, i)).caloric.inverse_C_0;
  }
  MixtureFate fate(Particles const& of, Index i) const override {
    if (!may_end(of, i))
      return fate_of_others(of, i);
    return judged(of.progress[i], mixed_.stiffness(of.progress[i], of.rho[i], split(of, i)));
  }
  void fates(Particles const& of, Range range, std::span<MixtureFate> of_each) const override {
    std::array<Index, fitting::Pack::size> some;
    std::size_t count = 0;
    auto const judge = [&] {
      auto const found = mixed_.stiffnesses(of, std::span(some).first(count));
      for (std::size_t k = 0; k < count; ++k)
        of_each[some[k] - range.begin] = judged(of.progress[some[k]], found[k]);
      count = 0;
    };
    for (std::size_t i = range.begin; i < range.end; ++i) {
      if (may_end(of, i))
        some[count++] = static_cast<Index>(i);
      else
        of_each[i - range.begin] = fate_of_others(of, i);
      if (count == some.size())
        judge();
    }
    if (count > 0)
      judge();
  }

 private:
  /// A part whose bulk modulus is so many times the pressure, or less, is about to end; one that begins again
  /// is stiffer.
  static constexpr double weak = 1, stiff = 1.5;

  /// Whether a particle is a mixture of a progress at which its balance may come to an end.
  static bool may_end(Particles const& of, std::size_t i) {
    double const progress = of.progress[i];
    return kind_of(of, i) == Kind::mixed && (progress >= nearly_burnt || progress < hardly_burnt) &&
           of.log_density_ratio[i] != 0; // 0: it becomes a mixture only now
  }
  static MixtureFate judged(double progress, MixedParticle::Stiffness const& stiffness) {
    if (progress >= nearly_burnt && !(stiffness.reactant > weak))
      return MixtureFate::burns_up;
    return progress < hardly_burnt && !(stiffness.product > weak) ? MixtureFate::counts_as_reactant
                                                                  : MixtureFate::goes_on;
  }
  MixtureFate fate_of_others(Particles const& of, std::size_t i) const {
    double const progress = of.progress[i];
    bool const waits =
        progress >= pure_below && progress <= pure_above && of.log_density_ratio[i] == no_product;
    return waits && (progress >= hardly_burnt || mixes(of, i)) ? MixtureFate::mixes_again
                                                               : MixtureFate::goes_on;
  }
  /// Whether a particle that counts as reactant could be a mixture for some time.
  bool mixes(Particles const& of, std::size_t i) const {
    try {
      auto const state = mixed_.from_energy(of.progress[i], of.rho[i], of.eps[i], {of.T[i], 0});
      return mixed_.stiffness(of.progress[i], of.rho[i], state.split).product > stiff;
    } catch (PhysicsError const&) {
      return false;
    }
  }
  Thermodynamics const* pure_of(Particles const& of, std::size_t i) const {
    auto const kind = kind_of(of, i);
    return kind == Kind::mixed ? nullptr : kind == Kind::reactant ? reactant_.get() : product_.get();
  }
  static MixedParticle::Split split(Particles const& of, std::size_t i) {
    return {of.T[i], of.log_density_ratio[i]};
  }
  static void take(Particles& of, std::size_t i, MixedParticle::Split const& split) {
    of.T[i] = split.T, of.log_density_ratio[i] = split.log_density_ratio;
  }
  /// One that has no mixture, or none from near its last state.
  void from_energy(Particles& of, std::size_t i, Failure& failure) const {
    try {
      auto const state = mixed_.from_energy(of.progress[i], of.rho[i], of.eps[i], split(of, i));
      of.S[i] = state.S;
      take(of, i, state.split);
    } catch (PhysicsError const&) {
      if (of.progress[i] >= hardly_burnt)
        throw;
      of.log_density_ratio[i] = no_product;
      reactant_->from_energy(of, {i, i + 1}, failure);
    }
  }
  /// One that a change of its density leads away from where it has a mixture: it counts as reactant from
  /// where it was, of the energy that it had there.
  void from_entropy(Particles& of, std::size_t i, Failure& failure) const {
    double const progress = of.progress[i], rho = of.rho[i];
    try {
      auto const state = mixed_.from_entropy(progress, rho, of.S[i], split(of, i));
      of.eps[i] = state.eps;
      take(of, i, state.split);
    } catch (PhysicsError const&) {
      if (progress >= hardly_burnt)
        throw;
      auto const last = mixed_.last_density(progress, of.eps[i], of.S[i], split(of, i), rho);
      if (!last)
        throw;
      of.log_density_ratio[i] = no_product;
      of.rho[i] = *last;
      reactant_->from_energy(of, {i, i + 1}, failure);
      of.rho[i] = rho;
      reactant_->from_entropy(of, {i, i + 1}, failure);
    }
  }
  template <class F>
  static void reported(Particles const& of, std::size_t i, Failure& failure, F const& f) {
    try {
      f();
    } catch (std::exception const& error) {
      failure.report(of.id[i], error.what());
    }
  }
  /// Mixtures are done many at once: `some` of places says which lanes it has solved, the others go the
  /// careful way, alone(i), one by one, so that what becomes of a particle does not depend on its neighbours
  /// in memory. then(places) follows.
  template <class Some, class Alone, class Then>
  static void solve(Particles const& of, Range run, Failure& failure, Some const& some, Alone const& alone,
                    Then const& then) {
    for (std::size_t first = run.begin; first < run.end; first += fitting::Pack::size) {
      PackedPlaces const places(first, run.end);
      places.for_each_outside(some(places),
                              [&](std::size_t i) { reported(of, i, failure, [&] { alone(i); }); });
      then(places);
    }
  }
  /// Calls pure(model, run) for pure particles, solves the mixtures and finds what they answer.
  template <class Pure, class Some, class Alone>
  void renew(Particles& of, Range range, Failure& failure, Pure const& pure, Some const& some,
             Alone const& alone) const {
    for_each_run(of, range, pure, [&](Range run) {
      solve(of, run, failure, some, alone, [&](PackedPlaces const& places) {
        places.for_each_outside(mixed_.response(of, places), [&](std::size_t i) {
          if (kind_of(of, i) == Kind::mixed) // and has not just become a lone reactant
            reported(of, i, failure, [&] {
              auto const found = mixed_.response(of.progress[i], of.rho[i], split(of, i));
              of.P[i] = found.P, of.caloric[i] = found.caloric;
            });
        });
      });
    });
  }
  /// Calls pure(model, run) and mixed(run) for neighbours in memory of the same kind.
  template <class Pure, class Mixed>
  void for_each_run(Particles const& of, Range range, Pure const& pure, Mixed const& mixed) const {
    for (std::size_t begin = range.begin, end = begin; begin < range.end; begin = end) {
      auto const kind = kind_of(of, begin);
      while (end < range.end && kind_of(of, end) == kind)
        ++end;
      if (kind == Kind::mixed)
        mixed(Range{begin, end});
      else
        pure(kind == Kind::reactant ? *reactant_ : *product_, Range{begin, end});
    }
  }

  std::unique_ptr<Thermodynamics const> reactant_, product_;
  MixedParticle mixed_;
};

} // namespace

std::unique_ptr<Thermodynamics const> make_reacting_thermodynamics(ReactingModels const& models,
                                                                   ReducedUnits const& units,
                                                                   CentreOfMass centre_of_mass) {
  return std::make_unique<Reacting>(models, units, centre_of_mass);
}

} // namespace mesobridge::sdpd
