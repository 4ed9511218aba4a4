#pragma once
#include "sdpd/kinetics/first_order.hpp"
#include "sdpd/kinetics/prescribed_burn.hpp"
#include "sdpd/kinetics/pressure_burn.hpp"
#include "sdpd/kinetics/second_order.hpp"
#include <functional>
#include <string>
#include <variant>

namespace mesobridge::sdpd {

/// Every law of kinetics. A new one is a file and a word here; scenes and tests know it by its kinds().
using AnyKinetics = std::variant<SecondOrder, FirstOrder, PressureBurn, PrescribedBurn>;

/// A law by its name in scenes.
struct NamedKinetics {
  std::string_view name, summary;
  std::vector<Parameter> parameters;
  std::function<AnyKinetics(std::span<double const>)> make;
};

/// All laws, in the order of AnyKinetics.
std::vector<NamedKinetics> const& kinetics();

/// Throws InputError that lists the names.
NamedKinetics const& kinetics_named(std::string_view name);

/// How lambda follows the rates of its law over a time step (sdpd/README.md, Eq. (S65)).
enum class RateIntegrator {
  euler,   ///< exponential Euler, with the rates of the beginning: first order
  midpoint ///< exponential midpoint, with those of the middle: second order
};
std::vector<std::string> rate_integrator_names(); ///< in the order of RateIntegrator

/// A reaction of the particles, in reduced units.
struct Reaction {
  AnyKinetics kinetics;
  double heat = 0; ///< of a unit mass: chemical energy at lambda = 0, internal at lambda = 1
  RateIntegrator integrator = RateIntegrator::midpoint;
};

} // namespace mesobridge::sdpd
