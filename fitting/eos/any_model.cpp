#include "fitting/eos/any_model.hpp"

namespace mesobridge::fitting {

AnyIsochore::AnyIsochore(AnyEos const& any, double rho)
    : isochore_(std::visit([rho](auto const& eos) { return decltype(isochore_)(eos.isochore(rho)); }, any)) {}

double AnyIsochore::density() const {
  return std::visit([](auto const& at) { return at.density(); }, isochore_);
}
double AnyIsochore::energy(double T) const {
  return std::visit([T](auto const& at) { return at.energy(T); }, isochore_);
}
double AnyIsochore::entropy(double T) const {
  return std::visit([T](auto const& at) { return at.entropy(T); }, isochore_);
}
double AnyIsochore::pressure(double T) const {
  return std::visit([T](auto const& at) { return at.pressure(T); }, isochore_);
}
double AnyIsochore::heat_capacity(double T) const {
  return std::visit([T](auto const& at) { return at.heat_capacity(T); }, isochore_);
}
double AnyIsochore::heat_capacity_slope(double T) const {
  return std::visit([T](auto const& at) { return at.heat_capacity_slope(T); }, isochore_);
}
double AnyIsochore::pressure_slope(double T) const {
  return std::visit([T](auto const& at) { return at.pressure_slope(T); }, isochore_);
}
double AnyIsochore::pressure_density_slope(double T) const {
  return std::visit([T](auto const& at) { return at.pressure_density_slope(T); }, isochore_);
}
double AnyIsochore::temperature_from_energy(double e, double T_guess) const {
  return std::visit([=](auto const& at) { return at.temperature_from_energy(e, T_guess); }, isochore_);
}
double AnyIsochore::temperature_from_entropy(double s, double T_guess) const {
  return std::visit([=](auto const& at) { return at.temperature_from_entropy(s, T_guess); }, isochore_);
}

double AnyModel::entropy(double e, double rho) const {
  return std::visit([=](auto const& eos) { return eos.entropy(e, rho); }, eos_);
}
double AnyModel::energy_from_entropy(double s, double rho) const {
  return std::visit([=](auto const& eos) { return eos.energy_from_entropy(s, rho); }, eos_);
}
double AnyModel::temperature(double e, double rho) const {
  return std::visit([=](auto const& eos) { return eos.temperature(e, rho); }, eos_);
}
double AnyModel::pressure(double e, double rho) const {
  return std::visit([=](auto const& eos) { return eos.pressure(e, rho); }, eos_);
}
double AnyModel::heat_capacity(double e, double rho) const {
  return std::visit([=](auto const& eos) { return eos.heat_capacity(e, rho); }, eos_);
}
double AnyModel::sound_speed(double e, double rho) const {
  return std::visit([=](auto const& eos) { return eos.sound_speed(e, rho); }, eos_);
}
double AnyModel::energy_from_temperature(double T, double rho) const {
  return std::visit([=](auto const& eos) { return eos.energy_from_temperature(T, rho); }, eos_);
}
double AnyModel::molecular_mass() const {
  return std::visit([](auto const& eos) { return eos.molecular_mass(); }, eos_);
}
double AnyModel::boltzmann() const {
  return std::visit([](auto const& eos) { return eos.boltzmann(); }, eos_);
}
Domain AnyModel::domain() const {
  return std::visit([](auto const& eos) { return eos.domain(); }, eos_);
}

} // namespace mesobridge::fitting
