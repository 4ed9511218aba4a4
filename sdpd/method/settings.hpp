#pragma once
#include "fitting/eos/list.hpp"
#include "md/box.hpp"
#include "sdpd/kernel/list.hpp"
#include "sdpd/method/pair_fluid.hpp"
#include "sdpd/scheme/scheme.hpp"
#include "sdpd/state/particles.hpp"
#include "sdpd/state/species.hpp"
#include "sdpd/thermodynamics/thermodynamics.hpp"
#include <array>
#include <optional>
#include <string>

namespace mesobridge::sdpd {

/// A fluid at equilibrium: what `Simulation` is built from. Quantities in the units of the equation of state
/// (SI, but for reduced models), except where it says reduced.
struct SimulationSettings {
  fitting::AnyEos eos = fitting::IdealGas(1);
  /// Several species, whose sizes and equations of state take the place of those here; they remain the units.
  std::vector<SdpdSpecies> species = {};
  double rho = 0; ///< mean density, > 0
  double T = 0;   ///< set temperature, > 0
  double K = 0;   ///< size of a particle in atoms or molecules, >= 1 and with a heat capacity above k_B/2
  CentreOfMass centre_of_mass = CentreOfMass::free; ///< without noise it makes no difference: bulk
  std::array<std::uint32_t, 3> lattice{10, 10,
                                       10}; ///< particles along each edge of the initial cubic lattice
  double disorder =
      0; ///< standard deviation of the initial displacements from it, in lattice spacings, 0 ... 0.5
  std::string kernel = "wendland-c4"; ///< one of kernel_names(); see observe/pairing.hpp
  DensityCorrection density_correction = {};
  double h_factor = 2.5; ///< support h = h_factor (m/rho)^(1/3); 2.5 gives about 65 neighbours
  double eta = 0;        ///< shear viscosity
  double zeta = 0;       ///< bulk viscosity, < 5 eta/3
  double kappa = 0;      ///< thermal conductivity of SDPD; 0: no heat conduction
  bool noise = true;     ///< false: viscous smoothed particle hydrodynamics, which starts at rest
  double skin = 0;       ///< of the neighbour lists, reduced; 0: chosen from dt and K
  double dt = 0;         ///< time step, reduced, > 0
  Scheme scheme = {};
  double bath_rate = 0; ///< of the Langevin bath during equilibration, reduced, >= 0; 0: by rescaling
  std::uint64_t seed = 1;
  int threads = 1;
  /// For DPD and DPDE. The equation of state, K, the kernel, density correction, support and viscosities
  /// above are SDPD's: they are not used then; rho is the mass per volume.
  std::optional<PairFluid> pair_fluid = {};

  ReducedUnits units() const;
  std::size_t particle_count() const;
  std::vector<Species> reduced_species() const; ///< empty for one
  double spacing() const;    ///< mean distance between particles, reduced: 1 for SDPD of one species
  double range() const;      ///< of the interaction, reduced
  Features features() const; ///< of the particles
  bool conducts() const;     ///< whether particles exchange heat beside their friction
};

/// Throws InputError that names the quantity that is out of bounds.
void check(SimulationSettings const& settings);

/// Throws InputError when a unit of the engine, or a length in it, is not a positive number: of quantities
/// that are each allowed, and yet too far apart.
void check_units(SimulationSettings const& settings);

/// Throws InputError that names what was asked for, when the fluid has several species and so no one equation
/// of state that could tell.
void require_one_species(SimulationSettings const& settings, std::string_view asked);

Box box_of(SimulationSettings const& settings);

/// Of the neighbour lists, reduced.
double skin_of(SimulationSettings const& settings);

/// Without noise the centres of mass have no thermal motion that could carry anything: bulk.
CentreOfMass centre_of_mass_of(SimulationSettings const& settings);

} // namespace mesobridge::sdpd
