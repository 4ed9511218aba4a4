#pragma once
#include "fitting/model_file.hpp"
#include "sdpd/method/settings.hpp"
#include "sdpd/observe/equilibrium.hpp"
#include "sdpd/scheme/scheme.hpp"
#include "workflows/scene/scene.hpp"

namespace mesobridge::workflows {

/// The model that a scene names, with what its file says of it. Throws InputError.
fitting::EosModel eos_model_of(Scene const& scene);

/// The equation of state that a scene names: a built-in material, the ideal gas of its m0, or a fitted
/// model's file. Throws InputError.
fitting::AnyEos eos_of(Scene const& scene);
/// Of the product of a scene that reacts.
fitting::AnyEos product_of(Scene const& scene);

/// The scene's table `scheme`.
sdpd::Scheme scheme_of(Scene const& scene);

/// The axis across which the moving walls are, or the first with walls; 2 where there are none.
int moving_axis(Scene const& scene);

/// Along which axis a flow goes, the first periodic one where the scene does not say, and across which it
/// varies: that of the walls, or of a body force's waves.
struct FlowAxes {
  int along, across; ///< 0, 1, 2
};
FlowAxes flow_axes(Scene const& scene);

/// Mean number of particles within the kernel's support, the particle itself with them.
double neighbours_of(double h_factor);

/// The constants that the scene gives or names; those of the plain sum when they are still to be calibrated.
/// Throws InputError when there are none for the scene's kernel.
sdpd::DensityCorrection density_correction_of(Scene const& scene);

/// Steps between the instants at which the particles are looked at one by one: about 40 instants over the run
/// if the scene does not say.
std::int64_t instants_every(Scene::Run const& run);

/// Steps between the frames of the film; 0 where there is none.
std::int64_t film_every(Scene const& scene);

/// What the engine needs of a scene.
sdpd::SimulationSettings settings_of(Scene const& scene, int threads);

/// How many particles the scene has.
std::int64_t particles_of(Scene const& scene);

/// Three factors of N as near to each other as can be. Throws InputError, with the nearest cube, when the
/// flattest box of N particles is flatter than 1 : 3.
std::array<std::uint32_t, 3> lattice_of(std::int64_t N);

/// Processors that this process may use.
int available_threads();

/// Factors from the engine's reduced units to those of the scene, and the ends of the keys that go with them:
/// "_K" in SI, nothing in Lennard-Jones units.
struct OutputUnits {
  double time, length, velocity, energy, specific_energy, entropy, temperature, pressure, density, momentum;
  std::string time_key, length_key, velocity_key, energy_key, specific_energy_key, entropy_key,
      temperature_key, pressure_key, density_key, momentum_key;

  OutputUnits(sdpd::ReducedUnits const& reduced, UnitSystem system);

  /// Of a field of the particles or a measurement: the factor, and the end of its key.
  std::pair<double, std::string> of(Dimension dimension) const;
};

} // namespace mesobridge::workflows
