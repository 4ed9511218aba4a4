#include "sdpd/lammps/plugin.hpp"
#include "sdpd/lammps/fluid_styles.hpp"

#if __has_include(<lammps/version.h>)
#include <lammps/version.h>
#else
#define LAMMPS_VERSION "unknown" // where the headers come without it; LAMMPS then says that versions differ
#endif

namespace mesobridge::sdpd {
namespace {

/// One style, as LAMMPS's package PLUGIN knows it: its lammpsplugin_t.
struct OfferedStyle {
  char const *version, *style, *name, *info, *author;
  union {
    void* (*of_lammps)(void*);
    void* (*of_words)(void*, int, char**);
  } make;
  void* handle;
};
using Offer = void (*)(OfferedStyle*, void*);

void* pair_of(void* lammps) {
  return make_fluid_pair(static_cast<LAMMPS_NS::LAMMPS*>(lammps));
}
void* fix_of(void* lammps, int count, char** words) {
  return make_fluid_fix(static_cast<LAMMPS_NS::LAMMPS*>(lammps), count, words);
}

} // namespace

void offer_fluid_styles(void* lammps, void* handle, void* offer) {
  auto const offered = reinterpret_cast<Offer>(offer);
  OfferedStyle style{.version = LAMMPS_VERSION,
                     .style = "pair",
                     .name = fluid_style,
                     .info = "mesoscopic fluids: SDPD, DPDE, DPD",
                     .author = "mesobridge",
                     .make = {.of_lammps = pair_of},
                     .handle = handle};
  offered(&style, lammps);
  style.style = "fix", style.make.of_words = fix_of;
  offered(&style, lammps);
}

} // namespace mesobridge::sdpd
