#include "sdpd/lammps/plugin.hpp"
#include "md/error.hpp"
#include "sdpd/lammps/fluid_styles.hpp"
#include "sdpd/lammps/lammps_engine.hpp"
#include "workflows/sdpd/run_checks.hpp"

namespace mesobridge::workflows {
namespace {

/// `pair_style mesobridge fluid.toml`: the fluid of a scene.
sdpd::SimulationSettings fluid_of_words(std::vector<std::string> const& words) {
  require(words.size() == 1, "words behind pair_style mesobridge", words.size(),
          "must be one, the file of the fluid's scene");
  auto const settings = settings_of(load_run(words[0], {}, 1, Engine::lammps), 1);
  sdpd::refuse_for_lammps(settings);
  return settings;
}

} // namespace
} // namespace mesobridge::workflows

/// What a LAMMPS calls when its command `plugin load` has opened this library.
extern "C" void lammpsplugin_init(void* lammps, void* handle, void* offer) {
  mesobridge::sdpd::set_fluid_reader(mesobridge::workflows::fluid_of_words);
  mesobridge::sdpd::offer_fluid_styles(lammps, handle, offer);
}
