#include "sdpd/observe/measurement.hpp"

namespace mesobridge::sdpd {
namespace {

template <double Observation::*sum>
std::vector<double> value_of(Observation const& now) {
  return {now.*sum};
}
std::vector<double> energy(Observation const& now) {
  return {now.energy()};
}
std::vector<double> momentum(Observation const& now) {
  return {now.momentum.x, now.momentum.y, now.momentum.z};
}

} // namespace

/// What observe() finds, in the order of the columns of `thermodynamics`.
std::vector<Measurement> observed_sums() {
  using O = Observation;
  return {
      {.name = "kinetic_energy",
       .meaning = "sum p^2/2m",
       .dimension = Dimension::energy,
       .values = value_of<&O::kinetic>},
      {.name = "internal_energy",
       .meaning = "sum eps",
       .dimension = Dimension::energy,
       .exists = with_energies,
       .values = value_of<&O::internal>},
      {.name = "potential_energy",
       .meaning = "of the pair potential",
       .dimension = Dimension::energy,
       .exists = without_densities,
       .values = value_of<&O::potential>},
      {.name = "chemical_energy",
       .meaning = "that the reaction has still to give",
       .dimension = Dimension::energy,
       .exists = with_reaction,
       .values = value_of<&O::chemical>},
      {.name = "energy", .meaning = "total", .dimension = Dimension::energy, .values = energy},
      {.name = "T_kin",
       .meaning = "of the motion",
       .dimension = Dimension::temperature,
       .values = value_of<&O::T_kin>,
       .logged = true},
      {.name = "T_int",
       .meaning = "of the internal energies: the mean of T, in DPDE the harmonic one",
       .dimension = Dimension::temperature,
       .exists = with_energies,
       .values = value_of<&O::T_int>,
       .logged = true},
      {.name = "P",
       .meaning = "pressure, of motion and virial",
       .dimension = Dimension::pressure,
       .values = value_of<&O::P>,
       .logged = true},
      {.name = "rho",
       .meaning = "mean of the particles' densities",
       .dimension = Dimension::density,
       .exists = with_densities,
       .values = value_of<&O::rho>,
       .logged = true},
      {.name = "progress",
       .meaning = "of the reaction, the mean over the mass",
       .exists = with_reaction,
       .values = value_of<&O::progress>,
       .logged = true},
      {.name = "momentum",
       .meaning = "total",
       .components = vector_components,
       .dimension = Dimension::momentum,
       .values = momentum},
  };
}

} // namespace mesobridge::sdpd
