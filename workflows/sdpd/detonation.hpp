#pragma once
#include "fitting/znd.hpp"
#include "sdpd/observe/detonation_front.hpp"
#include "workflows/report/report.hpp"
#include "workflows/sdpd/run_scene.hpp"
#include "workflows/store/store.hpp"

namespace mesobridge::workflows {

/// The plane detonation of a reacting fluid without viscosity, by the models of its settings.
struct DetonationTheory {
  fitting::ReactiveFluid fluid;
  fitting::Shock chapman_jouguet;
  std::vector<fitting::ZonePoint> zone; ///< behind the front; empty where the kinetics have no such theory

  double zone_length() const; ///< 0 where there is no zone
  fitting::ZonePoint const& spike() const { return zone.front(); }
};

/// From the state at rest, with the pressure that the reactant's model has there. Nothing where the particles
/// do not react or the models have no detonation. The zone is that of irreversible kinetics of Arrhenius,
/// whose pair law counts the neighbours that a uniform fluid has. In the units of the settings.
std::optional<DetonationTheory> detonation_theory(sdpd::SimulationSettings const& settings);

/// The pressure behind a front, over the way from where the wave began, 1 where the measured reaction zone
/// ends.
struct ReleaseOfRun {
  double time;
  std::vector<double> place, P; ///< of the slices with fluid
};

/// What a run shows of its detonation, by its profiles; in the scene's units.
struct DetonationOfRun {
  sdpd::SteadyDetonation measured;
  DetonationTheory theory;
  std::vector<double> rho,
      P; ///< of the slices of the last frame that was taken, from the front backwards, where there is fluid
  double instant;                    ///< when that was
  std::vector<ReleaseOfRun> release; ///< at four of the instants
  std::optional<double> wall; ///< velocity of the wall that the wave has left; nothing where there is none

  /// Whether its velocity is no longer another one in the second half of the frames: by 3 standard errors or
  /// 1 %.
  bool is_steady() const;
};

/// The profiles of a run as those of a wave towards larger coordinates along their axis; in the scene's
/// units. The velocity of the scale is that of the products of Chapman and Jouguet.
struct DetonationFrames {
  std::vector<sdpd::DetonationFrame> frames;
  sdpd::ShockScale scale;
};
std::optional<DetonationFrames> detonation_frames(Store const& store, Scene const& scene,
                                                  sdpd::SimulationSettings const& settings,
                                                  DetonationTheory const& theory);

/// Nothing where nothing reacts, where there are no profiles of velocity, rho, T_int, P and progress along
/// one axis, or no steady detonation in the last two thirds of the way along it.
std::optional<DetonationOfRun> detonation_of(Store const& store, Scene const& scene,
                                             sdpd::SimulationSettings const& settings);

/// detonation_D and reaction_zone with standard errors, and `chapman_jouguet` and `znd`.
void put_detonation(Json& json, DetonationOfRun const& found, OutputUnits const& units);

/// A table beside the theory, the way of the front, the profiles in its frame, and the slices in the plane of
/// pressure and volume.
Section detonation_section(DetonationOfRun const& found, Scene const& scene, OutputUnits const& units);

} // namespace mesobridge::workflows
