#pragma once
#include "md/box.hpp"
#include "sdpd/boundary/face.hpp"
#include "sdpd/method/list.hpp"
#include "sdpd/scheme/scheme.hpp"
#include "sdpd/start/layout.hpp"
#include "sdpd/state/body_force.hpp"
#include "sdpd/state/species.hpp"
#include <array>
#include <memory>

namespace mesobridge::sdpd {

/// A fluid in a box: what `Simulation` is built from. Quantities in the units of the method (SI, but
/// for reduced models), except where it says reduced.
struct SimulationSettings {
  static constexpr NumberRange disorders{.min = 0, .max = 0.5};

  AnyMethod method; ///< with what it alone needs
  double rho = 0;   ///< mean density, mass per volume, > 0
  double T = 0;     ///< set temperature, > 0
  std::array<std::uint32_t, 3> lattice{10, 10,
                                       10}; ///< particles along each edge of the initial cubic lattice
  /// Where the particles begin, if not all of them on that lattice at rest, at rho and T; reduced.
  std::shared_ptr<Layout const> layout = {};
  Faces faces = {};          ///< of the box; velocities and times in the units of the method
  BodyForce body_force = {}; ///< in the units of the method
  double disorder = 0;       ///< standard deviation of the initial displacements from it, in lattice spacings
  /// SDPD without a layout: no lattice is left at the start, and the energy of its disorder is gone, see
  /// relax(); `disorder` has no meaning then.
  bool melted = false;
  bool noise = true; ///< false: viscous smoothed particle hydrodynamics, which starts at rest
  double skin = 0;   ///< of the neighbour lists, reduced; 0: chosen by the method
  double dt = 0;     ///< time step, reduced, > 0
  Scheme scheme = {};
  double bath_rate = 0; ///< of the Langevin bath during equilibration, reduced, >= 0; 0: by rescaling
  std::uint64_t seed = 1;
  int threads = 1;

  /// The settings of a method that is known to be this one; throws std::bad_variant_access if it is not.
  template <class Method>
  Method& as() {
    return std::get<Method>(method);
  }
  template <class Method>
  Method const& as() const {
    return std::get<Method>(method);
  }

  ReducedUnits units() const;
  double K() const { return units().K; } ///< atoms or molecules of a particle: 1 for DPD and DPDE
  std::size_t particle_count() const;
  std::vector<Species> reduced_species() const; ///< empty for one
  double spacing() const;    ///< mean distance between particles, at rho; reduced: 1 for SDPD of one species
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

} // namespace mesobridge::sdpd
