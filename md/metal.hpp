#pragma once
#include "md/lj_fluid.hpp"
#include "md/metal_crystal.hpp"

namespace mesobridge::md {

/// One thermodynamic state of a metal.
struct MetalState {
  double rho = 0; ///< [kg/m^3]
  double T = 0;   ///< [K]
  friend bool operator==(MetalState const&, MetalState const&) = default;
};

/// What a run begins with. A crystal may stay solid far above its melting point and a liquid may stay liquid
/// below it: in a run of picoseconds the state depends on the start.
enum class MetalStart { solid, liquid };

/// One NVT run of a metal. The crystal is strained evenly in all directions to the requested density.
struct MetalSettings {
  MetalPotential potential;
  Lattice lattice = Lattice::fcc;
  MetalStart start = MetalStart::solid;
  int least_atoms = 256; ///< the block of the lattice has at least so many
  /// Time step in units of d/max(c, v): nearest neighbours' distance over the bulk sound speed of the crystal
  /// at this density, or over a thermal atom's speed; 2.6 fs in copper at rest. Copper's e and P at 0.02,
  /// 0.04 and 0.06 agree within their errors of 0.15 %, as a crystal at 10 800 kg/m^3, 2500 K and as a liquid
  /// at 9500, 3000 K.
  double reduced_time_step = 0.04;
  double friction_steps = 40;              ///< relaxation time of the velocities in time steps
  std::int64_t melt_steps = 1500;          ///< of a liquid start, far above the melting point
  std::int64_t equilibration_steps = 1000; ///< at the set temperature
  std::int64_t sampling_steps = 8000;
  std::int64_t sample_every = 20; ///< steps
  std::uint64_t seed = 1;
  std::filesystem::path log_file = "lammps.log";

  int atoms() const { return CrystalBlock(lattice, least_atoms).atoms(); }
  std::int64_t steps() const;
  /// One line for people: ensemble, potential, start, sizes, zero of energy.
  std::string description() const;
};

MetalSettings metal_settings(Preset preset, MetalPotential const& potential);

/// What the crystal at rest tells about runs at one density.
struct MetalScales {
  double zero_of_e = 0; ///< specific energy of the crystal of zero pressure, above free atoms [J/kg]
  double sound_speed =
      0; ///< bulk sound speed, of the unexpanded crystal where the state is an expanded one [m/s]
  double neighbour_distance = 0; ///< [m]

  /// [s]
  double time_step(double T, MetalSettings const& settings) const;
};
MetalScales scales_of(MpiWorld const& world, double rho, MetalSettings const& settings, Log log);

/// One instant of a metal.
struct MetalSample {
  std::int64_t step = 0;
  double T = 0; ///< kinetic temperature, 2/(3N k_B) times the kinetic energy [K]
  double e = 0; ///< kinetic and potential energy above the perfect crystal of zero pressure at rest [J/kg]
  double P = 0; ///< [Pa]
  /// Mean squared displacement since the equilibration began, the centre of mass apart [m^2].
  double displacement_2 = 0;
};

/// What the last configuration of a run tells.
struct MetalEnd {
  double lattice_order = 0;     ///< 1 in the perfect crystal, about atoms^-1/2 in a liquid
  double part_beyond_table = 0; ///< of the atoms: beyond the potential's table of the embedding energy
};

struct MetalConsumers {
  std::function<bool(MetalSample const&)> samples; ///< false stops the run at once
  StepConsumer steps;
};

/// Throws InputError, naming the quantity, when the state cannot be sampled with these settings. The
/// densities that are allowed are those from half to twice that of the file's lattice constant.
void check(MetalState state, MetalSettings const& settings);

/// Samples the canonical ensemble of one state: Langevin's thermostat on all 3N momenta in the discretisation
/// of Gronbech-Jensen and Farago, as in sample_lj_fluid. Returns what the end of the run tells, or nothing
/// when a consumer stopped it. Throws InputError as `check`, LammpsError, and PhysicsError when the run
/// becomes unstable or a liquid start does not melt.
std::optional<MetalEnd> sample_metal(MpiWorld const& world, MetalState state, MetalSettings const& settings,
                                     MetalConsumers const& consumers, Log log = Log::replace);

} // namespace mesobridge::md
