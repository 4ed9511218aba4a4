#pragma once
#include "md/lammps_session.hpp"
#include "sdpd/lammps/decomposed_fluid.hpp"
#include <memory>

namespace mesobridge::sdpd {

/// Makes both styles known to a session, as `plugin load` does to a LAMMPS that has it.
void register_fluid_styles(md::LammpsSession& session);

/// A fluid whose particles are the atoms of a LAMMPS session, by a pair style and a fix of ours that are
/// registered in this process. The session keeps a pointer to the fluid.
class LammpsStyles {
 public:
  /// Names the styles to LAMMPS and asks for them: the box of the session must be there, its atoms not yet.
  LammpsStyles(md::LammpsSession& session, DecomposedFluid& fluid);
  ~LammpsStyles();
  LammpsStyles(LammpsStyles const&) = delete;
  LammpsStyles& operator=(LammpsStyles const&) = delete;

  /// Puts those of the particles that lie in this rank's part of the box there; all ranks are given all.
  void create(Particles const& particles);

  /// What this rank knows, a row of numbers_per_particle for each of its own: id (from 0), position,
  /// momentum, internal energy, temperature.
  std::vector<double> own_rows() const;
  static constexpr std::size_t numbers_per_particle = 9;

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

} // namespace mesobridge::sdpd
