#pragma once
#include "sdpd/setup/viscosity_line.hpp"
#include "sdpd/setup/viscosity_wave.hpp"

namespace mesobridge::sdpd {

/// The viscosity that the friction of pairs is to have, so that a fluid has the one that is asked for
/// (sdpd/README.md, Eqs. (S94), (S95)).
struct RealisedViscosity {
  double pairs = 0;
  cg::Estimate realised;     ///< with these pairs by all trials near them (S108), at waves of `wavelength`
  cg::Estimate of_half_wave; ///< the same at waves half as long
  cg::Estimate T_kin;        ///< of the trial with these pairs, over the set temperature
  double amplitude = 0;      ///< of its flow, over the thermal velocity
  double kinetic = 0;        ///< what the motion of particles carries in a fluid without structure, (S55)
  double wavelength = 0;     ///< in mean distances between particles
  std::vector<ViscosityTrial> trials = {}; ///< in their order; the last ones are the longer ones
  std::size_t particles = 0;
  std::uint64_t steps = 0; ///< made in all
};

/// The box of the trials: its longest edge is the wave.
std::array<std::uint32_t, 3> viscosity_lattice(SimulationSettings const& settings);

/// The least viscosity that motion of the particles and friction of pairs have together in a fluid without
/// structure, whatever the friction, in the units of the method (S106).
double least_viscosity_without_structure(SimulationSettings const& settings);

/// Throws InputError where that is surely more than what is asked for, which needs no trial.
void check_realised_viscosity(SimulationSettings const& settings);

/// Steps that finding it takes, about.
double steps_of_realised_viscosity(SimulationSettings const& settings);

/// Finds it for SDPD of one species at the settings' state, with their time step and scheme; the viscosity of
/// the settings is the one that is asked for. Throws InputError where the fluid has more than that with any
/// friction, which says the least that was found and what it is made of; PhysicsError where the fluid does
/// not flow or trials do not come to an end; Interrupted. `on_trial` is told each trial when it is done.
RealisedViscosity realise_viscosity(SimulationSettings settings, std::function<bool()> const& keep_going,
                                    std::function<void(ViscosityTrial const&)> const& on_trial = {});

} // namespace mesobridge::sdpd
