#pragma once
#include "md/lammps_session.hpp"
#include "md/thermo_sample.hpp"
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace mesobridge::md {

/// One thermodynamic state of the Lennard-Jones fluid, in Lennard-Jones units.
struct LjState {
  double rho = 0;
  double T = 0;
};

/// How long and how finely a program works: minutes, an hour, or the thesis's own sizes.
enum class Preset { quick, standard, paper };

/// One NVT run of the fluid, in Lennard-Jones units. The potential is cut (not shifted) at `cutoff`; with
/// `tail` the mean part beyond it (g(r) = 1) is added to the energy and the pressure.
struct LjFluidSettings {
  int atoms = 500;     ///< 4 n^3: the run starts from a face-centred cubic lattice of n^3 cells
  double cutoff = 3.0; ///< [sigma], 2.5 ... half the box
  bool tail = true;
  /// Time step times sqrt(T*): a thermal atom moves the same way in any state. At rho* = 1.05, T* = 14, U and
  /// P at 0.008, 0.012 and 0.016 agree with those at 0.004 within the errors of 0.1 %.
  double reduced_time_step = 0.010;
  double friction_time = 0.5;             ///< relaxation time of the velocities times sqrt(T*)
  std::int64_t melt_steps = 300;          ///< at a temperature at which the lattice cannot stand
  std::int64_t equilibration_steps = 700; ///< at the set temperature
  std::int64_t sampling_steps = 12000;
  std::int64_t sample_every = 10; ///< steps
  std::uint64_t seed = 1;
  std::filesystem::path log_file = "lammps.log";

  double time_step(LjState state) const;
  std::int64_t steps() const { return melt_steps + equilibration_steps + sampling_steps; }
  /// One line for people: ensemble, potential, cut-off, tail, sizes.
  std::string description() const;
};

LjFluidSettings lj_fluid_settings(Preset preset);

/// Called with each sample while the run goes on; false stops the run at once.
using ThermoConsumer = std::function<bool(ThermoSample const&)>;
/// Called with a snapshot while the run goes on; false stops the run at once.
using FrameConsumer = std::function<bool(Frame const&)>;
/// Called often, from the first step on, with the number of steps done; false stops the run at once.
using StepConsumer = std::function<bool(std::int64_t steps_done)>;

/// Who watches a run; each may be absent.
struct LjFluidConsumers {
  ThermoConsumer thermo;
  FrameConsumer frames;
  std::int64_t frame_every = 1000; ///< steps, a multiple of sample_every
  StepConsumer steps;
};

/// Throws InputError, naming the quantity, when the state cannot be sampled with these settings.
void check(LjState state, LjFluidSettings const& settings);

/// Samples the canonical ensemble of one state: melts a lattice, equilibrates, samples. The thermostat is
/// Langevin's, which is ergodic and acts on all 3N momenta (none is constrained, so T = 2K/3N without a
/// correction), in the Gronbech-Jensen-Farago discretisation, whose positions carry no time step error in a
/// harmonic well (md/README.md, Eq. (M3)). With Ranks::all every rank calls this and the consumers of
/// rank 0 are the ones asked. Returns false when a consumer stopped the run. Throws InputError as `check`,
/// LammpsError, and PhysicsError when the lattice did not melt.
bool sample_lj_fluid(MpiWorld const& world, Ranks ranks, LjState state, LjFluidSettings const& settings,
                     LjFluidConsumers const& consumers, Log log = Log::replace);

/// |sum_j exp(i k.r_j)|/N, the largest of three Bragg vectors k = (4 pi/a) along the axes of a face-centred
/// cubic lattice of constant a: 1 in the crystal, about N^-1/2 in the fluid.
double lattice_order(Frame const& frame, double lattice_constant);
/// The same for a lattice with planes of atoms at these distances along the axes; an axis with 0 is left out.
double lattice_order(Frame const& frame, Vec3 plane_distances);

} // namespace mesobridge::md
