#include "workflows/command.hpp"
#include "workflows/eos_fit/fit_command.hpp"

namespace mesobridge::workflows {

Command fit_mie_gruneisen_command() {
  return fit_family_command(
      {.name = "mie-gruneisen",
       .material = "metals and liquids under shock (Mie-Gruneisen)",
       .example = "mesobridge fit mie-gruneisen workflows/data/tin-us-up.csv --m0 \"118.71 u\" --fix "
                  "Gamma_0=2.3 --fix Gamma_inf=0 --fix q=1 --fix c_v=210 -o out/tin.toml",
       .family = fitting::mie_gruneisen_family});
}

} // namespace mesobridge::workflows
