#define OMPI_SKIP_MPICXX 1
#include "md/error.hpp"
#include "sdpd/lammps/fluid_pair.hpp"

#include <lammps/fix.h>
#include <lammps/modify.h>

namespace mesobridge::sdpd {
namespace {

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

/// The fix: the steps of the motion, friction and noise; it brings numbers to ghosts and back, and moves what
/// particles carry along with them. It shows each one's internal energy and temperature, and their energy
/// together, and writes them into LAMMPS's restart files. Where an input has given them by fix property/atom,
/// it keeps those numbers as they are now.
class FluidFix final : public LAMMPS_NS::Fix, public GhostExchange {
 public:
  FluidFix(LAMMPS_NS::LAMMPS* lammps, int count, char** words) : Fix(lammps, count, words) {
    constexpr int most_numbers = 8, usual_words = 3;
    if (count != usual_words || igroup != 0)
      error->all(FLERR, std::string("fix mesobridge is of the group all and takes no words"));
    comm_forward = comm_reverse = most_numbers;
    time_integrate = 1;
    maxexchange = carried_numbers;
    restart_peratom = 1;
    peratom_flag = 1, size_peratom_cols = 2, peratom_freq = 1;
    scalar_flag = 1, global_freq = 1, extscalar = 1;
    atom->add_callback(growing), atom->add_callback(restarting); // LAMMPS takes the fix that is being made
    auto* const pair = dynamic_cast<FluidPair*>(force->pair);
    if (pair && pair->shared->fluid) {
      begin(*pair);
      known_ = each_given([](double& given, double& carried) { carried = given; });
    }
  }
  ~FluidFix() override {
    if (shared_ && shared_->ghosts == this)
      shared_->ghosts = nullptr;
    atom->delete_callback(id, growing), atom->delete_callback(id, restarting);
  }
  void begin(FluidPair& with) {
    shared_ = with.shared;
    shared_->ghosts = this;
    grow_arrays(atom->nmax);
  }

  int setmask() override {
    return LAMMPS_NS::FixConst::INITIAL_INTEGRATE | LAMMPS_NS::FixConst::FINAL_INTEGRATE;
  }
  void init() override {
    if (!has_fluid())
      error->all(FLERR, std::string("fix mesobridge needs `pair_style mesobridge` before it"));
    if (!shared_->by_input)
      return;
    int const own = known_ || atom->nlocal == 0;
    int all = 0;
    MPI_Allreduce(&own, &all, 1, MPI_INT, MPI_MIN, world);
    if (fluid().has_energies() && !all)
      error->all(FLERR,
                 std::string("fix mesobridge finds no energies: they come from a restart file, or from fix "
                             "property/atom d_mesobridge_eps d_mesobridge_T"));
    shared_->guarded(error, [&] { refuse_other_system(); });
  }
  void initial_integrate(int) override { fluid().kick_and_drift(particles_of(*lmp), atom->x[0]); }
  void final_integrate() override {
    auto const particles = particles_of(*lmp);
    fluid().kick(particles);
    shared_->guarded(error, [&] { fluid().fluctuate(particles, *this, step_under_way(*lmp)); });
    if (shared_->by_input)
      each_given([](double& given, double& carried) { given = carried; });
  }

  double compute_scalar() override {
    double own = 0, all = 0;
    for (int i = 0; has_fluid() && i < atom->nlocal; ++i)
      own += carried(i).eps;
    MPI_Allreduce(&own, &all, 1, MPI_DOUBLE, MPI_SUM, world);
    return all;
  }

  void grow_arrays(int most) override {
    if (!has_fluid())
      return;
    fluid().carried.resize(static_cast<std::size_t>(most));
    rows_.resize(fluid().carried.size());
    for (std::size_t i = 0; i < rows_.size(); ++i)
      rows_[i] = &fluid().carried[i].eps;
    array_atom = rows_.data();
  }
  void copy_arrays(int from, int to, int) override {
    if (has_fluid())
      carried(to) = carried(from);
  }
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
  bool has_fluid() const { return shared_ && shared_->fluid; }
  DecomposedFluid& fluid() { return *shared_->fluid; }
  DecomposedFluid::Carried& carried(int i) { return fluid().carried[static_cast<std::size_t>(i)]; }

  /// f(what fix property/atom has, what is carried) of each atom's energy and temperature, if an input has
  /// given them.
  template <class F>
  bool each_given(F const& f) {
    int is_double = 0, columns = 0;
    int const eps = atom->find_custom(given_eps, is_double, columns),
              T = atom->find_custom(given_T, is_double, columns);
    if (eps < 0 || T < 0)
      return false;
    for (int i = 0; i < atom->nlocal; ++i)
      f(atom->dvector[eps][i], carried(i).eps), f(atom->dvector[T][i], carried(i).T);
    return true;
  }

  /// The fluid knows its box, step and masses from its scene.
  void refuse_other_system() {
    Vec3 const edge = fluid().box_edge();
    bool const same_box =
        !domain->triclinic && domain->xperiodic && domain->yperiodic && domain->zperiodic &&
        norm(Vec3{domain->boxlo[0], domain->boxlo[1], domain->boxlo[2]}) <= 1e-9 * norm(edge) &&
        norm(Vec3{domain->prd[0], domain->prd[1], domain->prd[2]} - edge) <= 1e-9 * norm(edge);
    if (!same_box)
      throw InputError(
          fmt::format("the box must be that of the fluid's scene: periodic, from 0 0 0 to {} {} {}", edge.x,
                      edge.y, edge.z));
    if (atom->ntypes != 1 || !atom->mass || atom->mass[1] != 1)
      throw InputError("atoms must be of one type, with the mass 1");
    if (std::abs(update->dt - fluid().dt()) > 1e-12 * fluid().dt())
      throw InputError(
          fmt::format("timestep = {}: must be that of the fluid's scene, {}", update->dt, fluid().dt()));
    if (!force->newton_pair)
      throw InputError("newton must be on for pairs");
  }

  std::shared_ptr<Shared> shared_;
  bool known_ = false;
  std::vector<double*> rows_;
  TravellingRows under_way_{};
};

} // namespace

LAMMPS_NS::Fix* make_fluid_fix(LAMMPS_NS::LAMMPS* lammps, int count, char** words) {
  return new FluidFix(lammps, count, words);
}

void give_fluid(LAMMPS_NS::LAMMPS& lammps, DecomposedFluid& fluid) {
  auto& pair = dynamic_cast<FluidPair&>(*lammps.force->pair);
  pair.shared->fluid = &fluid;
  dynamic_cast<FluidFix&>(*lammps.modify->fix[lammps.modify->nfix - 1]).begin(pair);
}

} // namespace mesobridge::sdpd
