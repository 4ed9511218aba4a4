#pragma once
#include "md/error.hpp"
#include "md/frame.hpp"
#include "md/mpi_world.hpp"
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace mesobridge::md {

/// An error that LAMMPS reports, with LAMMPS's own text and the command that met it.
struct LammpsError : EnvironmentError {
  using EnvironmentError::EnvironmentError;
};

/// Which ranks run one LAMMPS together.
enum class Ranks {
  own, ///< this rank alone; other ranks may run their own
  all  ///< all ranks of the world, which then must all make the same calls
};

enum class Log { replace, append };

/// The atoms that one rank owns, in LAMMPS's order, which means nothing. Positions may lie a little outside
/// the box. In LAMMPS's units.
struct OwnedAtoms {
  std::vector<std::int64_t> ids; ///< from 1
  std::vector<Vec3> q, v, f;
  std::vector<double> potential; ///< each atom's share of the potential energy; empty if not asked for
};

/// The atoms of one rank while a step is under way: their ids, the forces that LAMMPS has found, and those to
/// be added to them, rows of three numbers.
struct ForcedAtoms {
  std::span<int const> ids; ///< from 1
  double const* const* f;
  double* const* added;
};

/// What LAMMPS takes for the constants of nature in the units of a session.
struct UnitConstants {
  double boltzmann = 1;       ///< k_B [energy/temperature]
  double energy_of_mv2 = 1;   ///< mass velocity^2 as an energy
  double pressure_of_nkt = 1; ///< energy/volume as a pressure
};

/// One LAMMPS inside this process. LAMMPS writes to its log file only, never to the terminal. Every error
/// inside LAMMPS is thrown as LammpsError; the session is then spent (its run is half done) and may only be
/// destroyed. With Ranks::all an error of a single rank leaves the others waiting: the program must then end
/// with MpiWorld::abort.
class LammpsSession {
 public:
  /// Without a log where log_file is empty. Throws LammpsError when it cannot be written.
  LammpsSession(MpiWorld const& world, Ranks ranks, std::filesystem::path const& log_file,
                Log log = Log::replace);
  ~LammpsSession();
  LammpsSession(LammpsSession&&) noexcept;
  LammpsSession& operator=(LammpsSession&&) noexcept;

  /// Runs one LAMMPS command, as in an input script.
  void command(std::string const& text);
  /// The same with fmt's format; numbers are written so that they read back unchanged.
  template <class... Args>
  void command(fmt::format_string<Args const&...> format, Args const&... args) requires(sizeof...(Args) > 0) {
    command(fmt::format(format, args...));
  }

  /// A command that names a file, given by its path whatever characters that has: "words FILE more".
  void command_with_file(std::string const& words, std::filesystem::path const& file,
                         std::string const& more = "");

  /// A keyword of LAMMPS's `thermo_style` as of the last step: "temp", "pe", "press", "vol" ... All ranks
  /// must ask.
  double thermo(std::string const& keyword);
  /// The global scalar of a compute.
  double compute(std::string const& id);
  /// One component, from 0, of the global vector of a compute.
  double compute(std::string const& id, int component);
  UnitConstants unit_constants() const;
  std::int64_t atoms() const;
  std::int64_t step() const;
  /// All atoms, on every rank. Throws InputError when the box is not rectangular.
  Frame frame();

  /// The atoms of this rank as of the last step. `energy_compute` names a compute pe/atom that the last step
  /// has tallied (a thermo output that needs it does so), or is empty.
  OwnedAtoms owned_atoms(std::string const& energy_compute);
  /// Gives the atoms of this rank new velocities between two runs.
  void set_velocities(std::function<Vec3(std::int64_t id, Vec3 const& velocity)> const& velocity_of);

  /// From here on, each time that the forces on all atoms are complete, `add` says what comes on top of them.
  /// It belongs to no potential: energy and pressure leave it out. Once in a session.
  void add_forces(std::function<void(ForcedAtoms const&)> add);

  /// How far beyond the box LAMMPS will look for images of atoms, by the force field as it stands. All ranks
  /// must ask.
  double reach();

  /// Moves the atoms of this rank between two runs; each must stay in the rank's part of the box.
  void set_positions(std::function<Vec3(std::int64_t id)> const& position_of);

  /// The LAMMPS object itself, for those who register styles of their own with it.
  void* lammps() const;

  /// Whether LAMMPS has a style, e.g. has_style("pair", "lj/cut").
  bool has_style(std::string const& category, std::string const& name) const;

 private:
  struct Handle;
  /// Runs a call into LAMMPS; an error spends the session and is told with `doing`.
  template <class Call>
  auto guarded(std::string const& doing, Call&& call);

  std::unique_ptr<Handle> handle_;
};

/// What LAMMPS is installed, for `doctor`.
struct LammpsInstallation {
  int version = 0; ///< as the date yyyymmdd
  std::vector<std::string> packages;
};
LammpsInstallation lammps_installation(MpiWorld const& world);

} // namespace mesobridge::md
