#include "sdpd/thermodynamics/mixture.hpp"

namespace mesobridge::sdpd {
namespace {

/// Hands particles on to their species, neighbours in memory of the same species together.
class Mixture final : public Thermodynamics {
 public:
  explicit Mixture(std::vector<std::unique_ptr<Thermodynamics const>> of) : of_(std::move(of)) {}

  void from_entropy(Particles& particles, Range range, Failure& failure) const override {
    for_each_run(particles, range,
                 [&](auto const& of, Range run) { of.from_entropy(particles, run, failure); });
  }
  void from_energy(Particles& particles, Range range, Failure& failure) const override {
    for_each_run(particles, range,
                 [&](auto const& of, Range run) { of.from_energy(particles, run, failure); });
  }
  void response(Particles& particles, Range range, Failure& failure) const override {
    for_each_run(particles, range, [&](auto const& of, Range run) { of.response(particles, run, failure); });
  }
  void energy_from_temperature(Particles& particles, Range range, Failure& failure) const override {
    for_each_run(particles, range,
                 [&](auto const& of, Range run) { of.energy_from_temperature(particles, run, failure); });
  }

  ThermalState state(Particles const& particles, Index i, double eps) const override {
    return of(particles, i).state(particles, i, eps);
  }
  Caloric caloric(Particles const& particles, Index i, double eps, double T_guess) const override {
    return of(particles, i).caloric(particles, i, eps, T_guess);
  }
  std::optional<double> constant_heat_capacity() const override {
    auto const C = of_.front()->constant_heat_capacity();
    for (auto const& other : of_)
      if (other->constant_heat_capacity() != C)
        return std::nullopt;
    return C;
  }
  double heat_capacity(Particles const& particles, Index i) const override {
    return of(particles, i).heat_capacity(particles, i);
  }

 private:
  Thermodynamics const& of(Particles const& particles, std::size_t i) const {
    return *of_[particles.species[i]];
  }
  template <class F>
  void for_each_run(Particles const& particles, Range range, F const& f) const {
    for (std::size_t begin = range.begin, end = begin; begin < range.end; begin = end) {
      while (end < range.end && particles.species[end] == particles.species[begin])
        ++end;
      f(of(particles, begin), Range{begin, end});
    }
  }

  std::vector<std::unique_ptr<Thermodynamics const>> of_;
};

} // namespace

std::unique_ptr<Thermodynamics const>
make_mixture(std::vector<std::unique_ptr<Thermodynamics const>> of_species) {
  return std::make_unique<Mixture>(std::move(of_species));
}

} // namespace mesobridge::sdpd
