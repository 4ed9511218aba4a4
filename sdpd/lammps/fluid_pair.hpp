#pragma once
#include "md/lammps_headers.hpp"
#include "sdpd/lammps/fluid_styles.hpp"
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include <lammps/atom.h>
#include <lammps/comm.h>
#include <lammps/domain.h>
#include <lammps/error.h>
#include <lammps/force.h>
#include <lammps/lammps.h>
#include <lammps/memory.h>
#include <lammps/neigh_list.h>
#include <lammps/neighbor.h>
#include <lammps/pair.h>
#include <lammps/update.h>

namespace mesobridge::sdpd {

/// The step under way, counted from 0 as noise and messages count.
inline std::uint64_t step_under_way(LAMMPS_NS::LAMMPS const& lammps) {
  return static_cast<std::uint64_t>(std::max<LAMMPS_NS::bigint>(lammps.update->ntimestep - 1, 0));
}

/// What the pair style and the fix of one fluid share; each may go first.
struct Shared {
  DecomposedFluid* fluid = nullptr;
  GhostExchange* ghosts = nullptr;
  bool by_input = false; ///< the words behind the pair style have told the fluid

  /// Errors go to the program that gave the fluid; a LAMMPS by itself ends with their text. (LAMMPS's formats
  /// are of a fmt of its own: errors are told as whole strings.)
  template <class F>
  void guarded(LAMMPS_NS::Error* error, F const& f) const {
    if (!by_input)
      return f();
    try {
      f();
    } catch (std::exception const& failure) {
      error->one(FLERR, std::string(failure.what()));
    }
  }
};

/// The pair style: the forces of the fluid, on all pairs of LAMMPS's half list. Its words are those that a
/// reader takes for a fluid; without them the program gives it one.
class FluidPair final : public LAMMPS_NS::Pair {
 public:
  explicit FluidPair(LAMMPS_NS::LAMMPS* lammps) : Pair(lammps) {
    restartinfo = 0, single_enable = 0, no_virial_fdotr_compute = 1;
    list = nullptr; // LAMMPS leaves it open until it has one
  }
  ~FluidPair() override {
    shared->fluid = nullptr;
    memory->destroy(setflag), memory->destroy(cutsq);
  }
  void settings(int count, char** words) override {
    if (shared->fluid)
      error->all(FLERR, std::string("pair style mesobridge has its fluid already"));
    shared->by_input = count > 0;
    shared->guarded(error, [&] {
      if (shared->by_input)
        shared->fluid = &own_.emplace(read_fluid({words, words + count}));
    });
  }
  void coeff(int, char**) override {
    if (allocated)
      return;
    int const types = atom->ntypes;
    memory->create(setflag, types + 1, types + 1, "mesobridge:setflag");
    memory->create(cutsq, types + 1, types + 1, "mesobridge:cutsq");
    for (int i = 1; i <= types; ++i)
      for (int j = 1; j <= types; ++j)
        setflag[i][j] = 1;
    allocated = 1;
  }
  double init_one(int, int) override {
    if (!shared->fluid)
      error->all(FLERR, std::string("pair style mesobridge needs the file of a fluid's scene behind it"));
    return shared->fluid->range();
  }
  void compute(int eflag, int vflag) override {
    ev_init(eflag, vflag);
    if (shared->by_input) // potential energy and virial are not told: who asks for them must see it
      eng_vdwl = std::nan(""), std::fill_n(virial, 6, std::nan(""));
    if (!shared->ghosts)
      error->all(FLERR, std::string("pair style mesobridge needs `fix ID all mesobridge` behind it"));
    shared->guarded(
        error, [&] { shared->fluid->add_forces(particles_of(*lmp), *shared->ghosts, step_under_way(*lmp)); });
  }

  std::shared_ptr<Shared> const shared = std::make_shared<Shared>();

 private:
  std::optional<DecomposedFluid> own_;
};

} // namespace mesobridge::sdpd
