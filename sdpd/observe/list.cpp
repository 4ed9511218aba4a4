#include "sdpd/observe/list.hpp"

namespace mesobridge::sdpd {

// Each in a file of this folder.
std::vector<Measurement> observed_sums();
Measurement mean_neighbours();
Measurement internal_energy_spread();
Measurement compression_response();
Measurement pressure_tensor();
Measurement bond_order();
Measurement structure_factor();
Measurement wall_pressure();
Measurement wall_work();
Measurement wall_drag();
Measurement wall_heat();
Measurement body_work();

std::vector<Measurement> const& measurements() {
  static auto const all = [] {
    auto list = observed_sums();
    list.push_back(mean_neighbours());
    list.push_back(internal_energy_spread());
    list.push_back(compression_response());
    list.push_back(pressure_tensor());
    list.push_back(bond_order());
    list.push_back(structure_factor());
    list.push_back(wall_pressure());
    list.push_back(wall_work());
    list.push_back(wall_drag());
    list.push_back(wall_heat());
    list.push_back(body_work());
    return list;
  }();
  return all;
}

} // namespace mesobridge::sdpd
