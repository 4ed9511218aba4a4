#include "fuzz/change_hdf5.hpp"
#include "fuzz/child.hpp"
#include "fuzz/kinds/kinds.hpp"
#include "workflows/lj/grid_file.hpp"

namespace mesobridge::fuzz {
namespace {

void prepare(std::filesystem::path const& folder) {
  std::vector<md::LjState> states;
  for (double const rho : {0.2, 0.5, 0.8})
    for (double const T : {1.5, 3.0})
      states.push_back({.rho = rho, .T = T});
  workflows::LjGridFile file(folder / "lj-grid.h5", states, {},
                             {.command = "fuzz", .seed = 1, .scene = "", .inputs = {}});
  std::mt19937_64 bits(3);
  std::normal_distribution<double> normal;
  for (std::size_t s = 0; s < states.size(); ++s) {
    std::vector<md::ThermoSample> samples;
    for (int k = 0; k < 600; ++k) {
      md::ThermoSample sample{};
      sample.step = 20 * k;
      sample.T = states[s].T * (1 + 0.01 * normal(bits));
      sample.U = -2 - states[s].rho + 0.02 * normal(bits);
      sample.P = states[s].rho * states[s].T + 0.05 * normal(bits);
      samples.push_back(sample);
    }
    file.append(s, samples);
  }
  file.close(true);
}

void change(Random& random, Trial& trial) {
  trial.commands = {{"cg", "state-grid", "lj-grid.h5", "-o", "out", "--quiet"}};
  trial.change = change_hdf5(random, trial.folder / "lj-grid.h5");
}

} // namespace

Kind lj_grid_kind() {
  return {.name = "lj-grid", .prepare = prepare, .change = change};
}

} // namespace mesobridge::fuzz
