#include "workflows/command.hpp"
#include "workflows/eos_fit/fit_command.hpp"

namespace mesobridge::workflows {

Command fit_hz_command() {
  return fit_family_command({.name = "hz",
                             .material = "unreacted explosives (HZ)",
                             .example = "mesobridge fit hz workflows/data/nitromethane-us-up.csv --from "
                                        "nitromethane --fix Gamma_0=1 --fix c_v=1211 -o out/nm.toml",
                             .family = fitting::hz_family});
}

} // namespace mesobridge::workflows
