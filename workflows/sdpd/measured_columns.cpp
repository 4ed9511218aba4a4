#include "workflows/sdpd/measured_columns.hpp"
#include <fmt/format.h>

namespace mesobridge::workflows {

std::string dataset_name(sdpd::Measurement const& of, OutputUnits const& units) {
  return std::string(of.name) + units.of(of.dimension).second;
}

std::vector<std::string> columns_of(sdpd::Measurement const& of, OutputUnits const& units) {
  std::vector<std::string> names;
  for (auto const component : of.components)
    names.push_back(fmt::format("{}{}{}", of.name, component, units.of(of.dimension).second));
  return names;
}

std::vector<sdpd::Measurement> measured_in_every_run(sdpd::Features const& features) {
  std::vector<sdpd::Measurement> measured;
  for (auto const& measurement : sdpd::measurements())
    if (measurement.in_every_run() && measurement.exists(features))
      measured.push_back(measurement);
  return measured;
}

} // namespace mesobridge::workflows
