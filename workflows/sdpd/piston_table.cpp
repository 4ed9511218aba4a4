#include "workflows/sdpd/piston_table.hpp"
#include "md/error.hpp"
#include "workflows/sdpd/column_file.hpp"

namespace mesobridge::workflows {

sdpd::WallMotion piston_table(Scene const& scene) {
  auto times = scene.box.piston_times, velocities = scene.box.piston_velocities;
  if (auto const& file = scene.box.piston_file) {
    bool const si = scene.units == UnitSystem::SI;
    std::string const t = si ? "t_s" : "t", v = si ? "v_m_s" : "v";
    auto columns = read_columns(*file, {t, v}, {});
    times = columns[t], velocities = columns[v];
    for (std::size_t k = 0; k < times.size(); ++k)
      require(k > 0 ? times[k] > times[k - 1] : times[k] == 0,
              fmt::format("box.piston_file = \"{}\": {} of row {}", *file, t, k + 1), times[k],
              k > 0 ? "must be later than the row before" : "must be 0 in the first row");
  }
  std::vector<sdpd::MotionRow> rows;
  for (std::size_t k = 0; k < times.size(); ++k)
    rows.push_back({.time = times[k], .velocity = velocities[k]});
  return sdpd::motion_by_table(std::move(rows));
}

} // namespace mesobridge::workflows
