#pragma once
#include <algorithm>
#include <cstddef>
#include <vector>

namespace mesobridge::sdpd {

/// A moment of a moving wall's table: the velocity then, and how far the wall has come.
struct MotionRow {
  double time, velocity;
  double way = 0; ///< found by motion_by_table()
};

/// How a wall moves along its normal, in the units of its owner: at rest; faster and faster to a constant
/// velocity, which it has after the time `ramp`; or by a table, whose velocity goes linearly from row to row
/// and stays what the last one says. Positive velocities go up the axis.
struct WallMotion {
  double velocity = 0;
  double ramp = 0;                   ///< >= 0
  std::vector<MotionRow> table = {}; ///< times from 0 on, rising; in place of velocity and ramp

  bool moves() const { return velocity != 0 || !table.empty(); }

  /// Of a wall that only becomes faster, into the fluid, until it keeps its velocity: that velocity. 0 for
  /// any other.
  double driving_velocity() const {
    if (table.empty())
      return std::max(0.0, velocity);
    double before = 0;
    for (auto const& row : table) {
      if (row.velocity < before)
        return 0;
      before = row.velocity;
    }
    return before;
  }

  double velocity_at(double time) const {
    if (!table.empty())
      return time > 0 ? velocity_of_table(time) : 0;
    return velocity * (time < ramp ? std::max(0.0, time) / ramp : time > 0 ? 1 : 0);
  }
  /// How far it has come.
  double way_at(double time) const {
    if (!table.empty())
      return time > 0 ? way_of_table(time) : 0;
    double const of_ramp = std::clamp(time, 0.0, ramp);
    return velocity * (ramp > 0 ? of_ramp * of_ramp / (2 * ramp) : 0) + velocity * std::max(0.0, time - ramp);
  }

 private:
  /// The last row that is not later.
  std::size_t row_at(double time) const {
    auto const later = std::upper_bound(table.begin(), table.end(), time,
                                        [](double t, MotionRow const& row) { return t < row.time; });
    return static_cast<std::size_t>(later - table.begin()) - 1;
  }
  double acceleration_after(std::size_t k) const {
    return k + 1 == table.size()
               ? 0
               : (table[k + 1].velocity - table[k].velocity) / (table[k + 1].time - table[k].time);
  }
  double velocity_of_table(double time) const {
    auto const k = row_at(time);
    return table[k].velocity + acceleration_after(k) * (time - table[k].time);
  }
  double way_of_table(double time) const {
    auto const k = row_at(time);
    double const since = time - table[k].time;
    return table[k].way + since * (table[k].velocity + acceleration_after(k) * since / 2);
  }
};

/// A motion by the rows of a table, whose ways are found here.
inline WallMotion motion_by_table(std::vector<MotionRow> table) {
  for (std::size_t k = 1; k < table.size(); ++k)
    table[k].way = table[k - 1].way +
                   (table[k].time - table[k - 1].time) * (table[k - 1].velocity + table[k].velocity) / 2;
  return {.velocity = 0, .ramp = 0, .table = std::move(table)};
}

} // namespace mesobridge::sdpd
