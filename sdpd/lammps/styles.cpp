#define OMPI_SKIP_MPICXX 1
#define LAMMPS_LIB_MPI
#include "sdpd/lammps/styles.hpp"
#include "md/lammps_headers.hpp"

#include <lammps/atom.h>
#include <lammps/comm.h>
#include <lammps/domain.h>
#include <lammps/fix.h>
#include <lammps/force.h>
#include <lammps/lammps.h>
#include <lammps/library.h>
#include <lammps/memory.h>
#include <lammps/modify.h>
#include <lammps/neigh_list.h>
#include <lammps/neighbor.h>
#include <lammps/pair.h>
#include <lammps/update.h>

namespace mesobridge::sdpd {
namespace {

constexpr char const* style_name = "mesobridge";

/// The step under way, counted from 0 as noise and messages count.
std::uint64_t step_under_way(LAMMPS_NS::LAMMPS const& lammps) {
  return static_cast<std::uint64_t>(std::max<LAMMPS_NS::bigint>(lammps.update->ntimestep - 1, 0));
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

/// The pair style: the forces of the fluid, on all pairs of LAMMPS's half list.
class FluidPair final : public LAMMPS_NS::Pair {
 public:
  explicit FluidPair(LAMMPS_NS::LAMMPS* lammps) : Pair(lammps) {
    restartinfo = 0, single_enable = 0, no_virial_fdotr_compute = 1;
  }
  ~FluidPair() override { memory->destroy(setflag), memory->destroy(cutsq); }
  void settings(int, char**) override {}
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
    fluid->add_forces(particles_of(*lmp), *ghosts, step_under_way(*lmp));
  }

  DecomposedFluid* fluid = nullptr;
  GhostExchange* ghosts = nullptr;
};

/// The fix: the steps of the motion, friction and noise; it brings numbers to ghosts and back, and moves what
/// particles carry along with them.
class FluidFix final : public LAMMPS_NS::Fix, public GhostExchange {
 public:
  FluidFix(LAMMPS_NS::LAMMPS* lammps, int count, char** words) : Fix(lammps, count, words) {
    constexpr int most_numbers = 8;
    comm_forward = comm_reverse = most_numbers;
    time_integrate = 1;
    maxexchange = 3;
    atom->add_callback(0); // LAMMPS takes the fix that is being made
  }
  ~FluidFix() override { atom->delete_callback(id, 0); }
  void begin(DecomposedFluid& of) {
    fluid = &of;
    grow_arrays(atom->nmax);
  }

  int setmask() override {
    return LAMMPS_NS::FixConst::INITIAL_INTEGRATE | LAMMPS_NS::FixConst::FINAL_INTEGRATE;
  }
  void initial_integrate(int) override { fluid->kick_and_drift(particles_of(*lmp), atom->x[0]); }
  void final_integrate() override {
    auto const particles = particles_of(*lmp);
    fluid->kick(particles);
    fluid->fluctuate(particles, *this, step_under_way(*lmp));
  }

  void grow_arrays(int most) override {
    if (fluid)
      fluid->carried.resize(static_cast<std::size_t>(most));
  }
  void copy_arrays(int from, int to, int) override { carried(to) = carried(from); }
  int pack_exchange(int i, double* to) override {
    to[0] = carried(i).eps, to[1] = carried(i).T, to[2] = carried(i).S;
    return 3;
  }
  int unpack_exchange(int i, double* from) override {
    carried(i) = {from[0], from[1], from[2]};
    return 3;
  }

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
    comm->forward_comm_fix(this, rows.width);
  }
  void reverse(TravellingRows const& rows) override {
    under_way_ = rows;
    comm->reverse_comm_fix(this, rows.width);
  }

 private:
  std::span<double> row(int i) const {
    return {under_way_.rows + std::ptrdiff_t{under_way_.stride} * i,
            static_cast<std::size_t>(under_way_.width)};
  }
  DecomposedFluid::Carried& carried(int i) { return fluid->carried[static_cast<std::size_t>(i)]; }

  DecomposedFluid* fluid = nullptr;
  TravellingRows under_way_{};
};

LAMMPS_NS::Pair* make_pair(LAMMPS_NS::LAMMPS* lammps) {
  return new FluidPair(lammps); // LAMMPS deletes it
}
LAMMPS_NS::Fix* make_fix(LAMMPS_NS::LAMMPS* lammps, int count, char** words) {
  return new FluidFix(lammps, count, words);
}

} // namespace

struct LammpsStyles::Inside {
  LAMMPS_NS::LAMMPS& lammps;
  DecomposedFluid& fluid;
};

LammpsStyles::LammpsStyles(md::LammpsSession& session, DecomposedFluid& fluid)
    : inside_(new Inside{*static_cast<LAMMPS_NS::LAMMPS*>(session.lammps()), fluid}) {
  auto& lammps = inside_->lammps;
  (*lammps.force->pair_map)[style_name] = make_pair;
  (*lammps.modify->fix_map)[style_name] = make_fix;
  session.command("pair_style {}", style_name);
  session.command("pair_coeff * *");
  session.command("fix {0} all {0}", style_name);
  auto& fix = dynamic_cast<FluidFix&>(*lammps.modify->fix[lammps.modify->nfix - 1]);
  fix.begin(fluid);
  auto& pair = dynamic_cast<FluidPair&>(*lammps.force->pair);
  pair.fluid = &fluid, pair.ghosts = &fix;
}

LammpsStyles::~LammpsStyles() = default;

void LammpsStyles::create(Particles const& from) {
  auto& lammps = inside_->lammps;
  std::size_t const n = from.size();
  std::vector<int> ids(n), types(n, 1);
  for (std::size_t i = 0; i < n; ++i)
    ids[i] = static_cast<int>(from.id[i]) + 1;
  static_assert(sizeof(Vec3) == 3 * sizeof(double));
  lammps_create_atoms(&lammps, static_cast<int>(n), ids.data(), types.data(), &from.q[0].x, &from.p[0].x,
                      nullptr, 0);
  if (from.eps.empty())
    return;
  std::vector<std::size_t> place(n);
  for (std::size_t i = 0; i < n; ++i)
    place[from.id[i]] = i;
  auto const here = particles_of(lammps);
  for (std::size_t i = 0; i < here.owned; ++i) {
    auto const at = place[here.id(i)];
    inside_->fluid.carried[i] = {.eps = from.eps[at], .T = from.T[at]};
  }
}

std::vector<double> LammpsStyles::own_rows() const {
  auto const here = particles_of(inside_->lammps);
  std::vector<double> rows;
  rows.reserve(numbers_per_particle * here.owned);
  for (std::size_t i = 0; i < here.owned; ++i) {
    auto const& carried = inside_->fluid.carried[i];
    rows.push_back(here.id(i));
    rows.insert(rows.end(), here.q + 3 * i, here.q + 3 * i + 3);
    rows.insert(rows.end(), here.v + 3 * i, here.v + 3 * i + 3);
    rows.insert(rows.end(), {carried.eps, carried.T});
  }
  return rows;
}

} // namespace mesobridge::sdpd
