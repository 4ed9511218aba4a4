#define OMPI_SKIP_MPICXX 1
#include "sdpd/lammps/fluid_styles.hpp"
#include "md/error.hpp"
#include "md/lammps_headers.hpp"
#include <optional>

#include <lammps/atom.h>
#include <lammps/comm.h>
#include <lammps/domain.h>
#include <lammps/error.h>
#include <lammps/fix.h>
#include <lammps/force.h>
#include <lammps/lammps.h>
#include <lammps/memory.h>
#include <lammps/modify.h>
#include <lammps/neigh_list.h>
#include <lammps/neighbor.h>
#include <lammps/pair.h>
#include <lammps/update.h>

namespace mesobridge::sdpd {
namespace {

FluidReader reader = nullptr;

/// The step under way, counted from 0 as noise and messages count.
std::uint64_t step_under_way(LAMMPS_NS::LAMMPS const& lammps) {
  return static_cast<std::uint64_t>(std::max<LAMMPS_NS::bigint>(lammps.update->ntimestep - 1, 0));
}

/// Brings numbers to ghosts and back, by the names that LAMMPS's versions have for it.
template <class Comm, class Fix>
void bring_forward(Comm& comm, Fix* fix, int width) {
  if constexpr (requires { comm.forward_comm_fix(fix, width); })
    comm.forward_comm_fix(fix, width);
  else
    comm.forward_comm(fix, width);
}
template <class Comm, class Fix>
void bring_back(Comm& comm, Fix* fix, int width) {
  if constexpr (requires { comm.reverse_comm_fix(fix, width); })
    comm.reverse_comm_fix(fix, width);
  else
    comm.reverse_comm(fix, width);
}

/// The pair style: the forces of the fluid, on all pairs of LAMMPS's half list. Its words are those that a
/// reader takes for a fluid; without them the program gives it one.
class FluidPair final : public LAMMPS_NS::Pair {
 public:
  explicit FluidPair(LAMMPS_NS::LAMMPS* lammps) : Pair(lammps) {
    restartinfo = 0, single_enable = 0, no_virial_fdotr_compute = 1;
    list = nullptr; // LAMMPS leaves it open until it has one
  }
  ~FluidPair() override { memory->destroy(setflag), memory->destroy(cutsq); }
  void settings(int count, char** words) override {
    by_input = count > 0;
    if (by_input)
      guarded([&] { fluid = &own_.emplace(reader({words, words + count})); });
  }
  void coeff(int, char**) override {
    int const types = atom->ntypes;
    memory->create(setflag, types + 1, types + 1, "mesobridge:setflag");
    memory->create(cutsq, types + 1, types + 1, "mesobridge:cutsq");
    for (int i = 1; i <= types; ++i)
      for (int j = 1; j <= types; ++j)
        setflag[i][j] = 1;
    allocated = 1;
  }
  double init_one(int, int) override { return fluid->range(); }
  void compute(int eflag, int vflag) override {
    ev_init(eflag, vflag);
    if (!ghosts)
      error->all(FLERR, std::string("pair style mesobridge needs `fix ID all mesobridge` behind it"));
    guarded([&] { fluid->add_forces(particles_of(*lmp), *ghosts, step_under_way(*lmp)); });
  }

  /// Errors go to the program that gave the fluid; a LAMMPS by itself ends with their text. (LAMMPS's formats
  /// are of a fmt of its own: errors are told as whole strings.)
  template <class F>
  void guarded(F const& f) {
    if (!by_input)
      return f();
    try {
      f();
    } catch (std::exception const& failure) {
      error->one(FLERR, std::string(failure.what()));
    }
  }

  DecomposedFluid* fluid = nullptr;
  GhostExchange* ghosts = nullptr;
  bool by_input = false; ///< the words behind the style have told the fluid

 private:
  std::optional<DecomposedFluid> own_;
};

/// The fix: the steps of the motion, friction and noise; it brings numbers to ghosts and back, and moves what
/// particles carry along with them. It shows each one's internal energy and temperature, and their energy
/// together, and writes them into LAMMPS's restart files.
class FluidFix final : public LAMMPS_NS::Fix, public GhostExchange {
 public:
  FluidFix(LAMMPS_NS::LAMMPS* lammps, int count, char** words) : Fix(lammps, count, words) {
    constexpr int most_numbers = 8;
    comm_forward = comm_reverse = most_numbers;
    time_integrate = 1;
    maxexchange = carried_numbers;
    restart_peratom = 1;
    peratom_flag = 1, size_peratom_cols = 2, peratom_freq = 1;
    scalar_flag = 1, global_freq = 1, extscalar = 1;
    atom->add_callback(growing), atom->add_callback(restarting); // LAMMPS takes the fix that is being made
    if (auto* const with = dynamic_cast<FluidPair*>(force->pair); with && with->fluid) {
      begin(*with);
      take_given();
    }
  }
  ~FluidFix() override { atom->delete_callback(id, growing), atom->delete_callback(id, restarting); }
  void begin(FluidPair& with) {
    pair_ = &with, fluid = with.fluid, with.ghosts = this;
    grow_arrays(atom->nmax);
  }

  int setmask() override {
    return LAMMPS_NS::FixConst::INITIAL_INTEGRATE | LAMMPS_NS::FixConst::FINAL_INTEGRATE;
  }
  void init() override {
    if (!fluid)
      error->all(FLERR, std::string("fix mesobridge needs `pair_style mesobridge` before it"));
    if (pair_->by_input && fluid->has_energies() && !known_)
      error->all(FLERR,
                 std::string("fix mesobridge finds no energies: they come from a restart file, or from fix "
                             "property/atom d_mesobridge_eps d_mesobridge_T"));
  }
  void initial_integrate(int) override { fluid->kick_and_drift(particles_of(*lmp), atom->x[0]); }
  void final_integrate() override {
    auto const particles = particles_of(*lmp);
    fluid->kick(particles);
    pair_->guarded([&] { fluid->fluctuate(particles, *this, step_under_way(*lmp)); });
  }

  double compute_scalar() override {
    double own = 0, all = 0;
    for (int i = 0; i < atom->nlocal; ++i)
      own += carried(i).eps;
    MPI_Allreduce(&own, &all, 1, MPI_DOUBLE, MPI_SUM, world);
    return all;
  }

  void grow_arrays(int most) override {
    if (!fluid)
      return;
    fluid->carried.resize(static_cast<std::size_t>(most));
    rows_.resize(fluid->carried.size());
    for (std::size_t i = 0; i < rows_.size(); ++i)
      rows_[i] = &fluid->carried[i].eps;
    array_atom = rows_.data();
  }
  void copy_arrays(int from, int to, int) override { carried(to) = carried(from); }
  int pack_exchange(int i, double* to) override {
    to[0] = carried(i).eps, to[1] = carried(i).T, to[2] = carried(i).S;
    return carried_numbers;
  }
  int unpack_exchange(int i, double* from) override {
    carried(i) = {from[0], from[1], from[2]};
    return carried_numbers;
  }
  int pack_restart(int i, double* to) override {
    to[0] = carried_numbers + 1;
    return 1 + pack_exchange(i, to + 1);
  }
  /// LAMMPS keeps what all fixes have written of an atom one behind the other.
  void unpack_restart(int i, int number) override {
    double* at = atom->extra[i];
    for (int k = 0; k < number; ++k)
      at += static_cast<int>(*at);
    unpack_exchange(i, at + 1);
    known_ = true;
  }
  int size_restart(int) override { return carried_numbers + 1; }
  int maxsize_restart() override { return carried_numbers + 1; }

  int pack_forward_comm(int n, int* of, double* to, int, int*) override {
    double const* const begin = to;
    for (int k = 0; k < n; ++k)
      for (double const number : row(of[k]))
        *to++ = number;
    return static_cast<int>(to - begin);
  }
  void unpack_forward_comm(int n, int first, double* from) override {
    for (int k = first; k < first + n; ++k)
      for (double& number : row(k))
        number = *from++;
  }
  int pack_reverse_comm(int n, int first, double* to) override {
    double const* const begin = to;
    for (int k = first; k < first + n; ++k)
      for (double const number : row(k))
        *to++ = number;
    return static_cast<int>(to - begin);
  }
  void unpack_reverse_comm(int n, int* of, double* from) override {
    for (int k = 0; k < n; ++k)
      for (double& number : row(of[k]))
        number += *from++;
  }

  void forward(TravellingRows const& rows) override {
    under_way_ = rows;
    bring_forward(*comm, static_cast<Fix*>(this), rows.width);
  }
  void reverse(TravellingRows const& rows) override {
    under_way_ = rows;
    bring_back(*comm, static_cast<Fix*>(this), rows.width);
  }

 private:
  static constexpr int carried_numbers = 3;
  static constexpr int growing = 0, restarting = 1; // kinds of callbacks

  std::span<double> row(int i) const {
    return {under_way_.rows + std::ptrdiff_t{under_way_.stride} * i,
            static_cast<std::size_t>(under_way_.width)};
  }
  DecomposedFluid::Carried& carried(int i) { return fluid->carried[static_cast<std::size_t>(i)]; }

  /// The energies and temperatures that an input has given each atom, if it has.
  void take_given() {
    int is_double = 0, columns = 0;
    int const eps = atom->find_custom(given_eps, is_double, columns),
              T = atom->find_custom(given_T, is_double, columns);
    if (eps < 0 || T < 0)
      return;
    for (int i = 0; i < atom->nlocal; ++i)
      carried(i) = {.eps = atom->dvector[eps][i], .T = atom->dvector[T][i]};
    known_ = true;
  }

  FluidPair* pair_ = nullptr;
  DecomposedFluid* fluid = nullptr;
  bool known_ = false;
  std::vector<double*> rows_;
  TravellingRows under_way_{};
};

} // namespace

void set_fluid_reader(FluidReader of) {
  reader = of;
}

LAMMPS_NS::Pair* make_fluid_pair(LAMMPS_NS::LAMMPS* lammps) {
  return new FluidPair(lammps); // LAMMPS deletes it
}

LAMMPS_NS::Fix* make_fluid_fix(LAMMPS_NS::LAMMPS* lammps, int count, char** words) {
  return new FluidFix(lammps, count, words);
}

void give_fluid(LAMMPS_NS::LAMMPS& lammps, DecomposedFluid& fluid) {
  auto& pair = dynamic_cast<FluidPair&>(*lammps.force->pair);
  pair.fluid = &fluid;
  dynamic_cast<FluidFix&>(*lammps.modify->fix[lammps.modify->nfix - 1]).begin(pair);
}

RankParticles particles_of(LAMMPS_NS::LAMMPS const& lammps) {
  auto const& atom = *lammps.atom;
  auto const owned = static_cast<std::size_t>(atom.nlocal);
  auto rows = [](double** of) { return of ? of[0] : nullptr; };
  RankParticles particles{owned,
                          owned + static_cast<std::size_t>(atom.nghost),
                          rows(atom.x),
                          rows(atom.v),
                          rows(atom.f),
                          atom.tag,
                          {},
                          lammps.domain->sublo,
                          lammps.domain->subhi};
  if (auto const* const list = lammps.force->pair->list)
    particles.list = {static_cast<std::size_t>(list->inum), list->ilist, list->numneigh, list->firstneigh,
                      NEIGHMASK};
  return particles;
}

FluidCommands fluid_commands(DecomposedFluid const& fluid) {
  return {.before = {"units lj", "atom_style atomic", "newton on", "atom_modify map array", "boundary p p p"},
          .after = {fmt::format("timestep {}", fluid.dt()), fmt::format("neighbor {} bin", fluid.skin()),
                    fmt::format("comm_modify cutoff {}", fluid.reach()),
                    "neigh_modify every 1 delay 0 check yes one 20000 page 400000"}};
}

} // namespace mesobridge::sdpd
