#define OMPI_SKIP_MPICXX 1
#define LAMMPS_LIB_MPI
#include "sdpd/lammps/styles.hpp"
#include "md/lammps_headers.hpp"
#include "sdpd/lammps/fluid_styles.hpp"

#include <lammps/force.h>
#include <lammps/lammps.h>
#include <lammps/library.h>
#include <lammps/modify.h>

namespace mesobridge::sdpd {

void register_fluid_styles(md::LammpsSession& session) {
  auto& lammps = *static_cast<LAMMPS_NS::LAMMPS*>(session.lammps());
  (*lammps.force->pair_map)[fluid_style] = make_fluid_pair;
  (*lammps.modify->fix_map)[fluid_style] = make_fluid_fix;
}

struct LammpsStyles::Inside {
  LAMMPS_NS::LAMMPS& lammps;
  DecomposedFluid& fluid;
};

LammpsStyles::LammpsStyles(md::LammpsSession& session, DecomposedFluid& fluid)
    : inside_(new Inside{*static_cast<LAMMPS_NS::LAMMPS*>(session.lammps()), fluid}) {
  auto& lammps = inside_->lammps;
  register_fluid_styles(session);
  session.command("pair_style {}", fluid_style);
  session.command("pair_coeff * *");
  session.command("fix {0} all {0}", fluid_style);
  give_fluid(lammps, fluid);
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
