#include "workflows/command.hpp"
#include "workflows/eos_fit/fit_command.hpp"

namespace mesobridge::workflows {

Command fit_jwl_command() {
  return fit_family_command(
      {.name = "jwl",
       .material = "detonation products (Jones-Wilkins-Lee)",
       .example = "mesobridge fit jwl expansion.csv cj.csv --m0 \"61.04 u\" -o out/products.toml",
       .family = fitting::jwl_family});
}

} // namespace mesobridge::workflows
