#define OMPI_SKIP_MPICXX 1
#include "md/ghost_cutoff.hpp"
#include "md/lammps_headers.hpp"

#include <lammps/comm.h>
#include <lammps/lammps.h>

namespace mesobridge::md {

double ghost_cutoff(void* lammps) {
  auto& instance = *static_cast<LAMMPS_NS::LAMMPS*>(lammps);
  instance.init();
  return instance.comm->get_comm_cutoff();
}

} // namespace mesobridge::md
