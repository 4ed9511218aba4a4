#include "sdpd/observe/pairing.hpp"
#include "sdpd/neighbours/block_copy.hpp"
#include <algorithm>

namespace mesobridge::sdpd {

double pairing_fraction(System const& system) {
  auto const& neighbours = system.neighbours;
  double const count = static_cast<double>(system.size());
  double const near = pairing_distance * std::cbrt(system.box.volume() / count);
  std::vector<char> is_paired(system.size());
  std::vector<Row> rows;
  for (std::size_t block = 0; block < neighbours.grid().blocks().size(); ++block) {
    auto const members = neighbours.members(block);
    copy_rows(
        members, system.particles.q, [](Index) { return 0.0; }, 0, rows);
    for (auto const& [i, j] : neighbours.pairs(block)) {
      Row const r = rows[i] - rows[j];
      if (norm2(Vec3{r[0], r[1], r[2]}) < near * near)
        is_paired[global_index(members, i)] = is_paired[global_index(members, j)] = 1;
    }
  }
  return static_cast<double>(std::ranges::count(is_paired, 1)) / count;
}

double tolerable_pairing(double K) {
  return 0.01 + 0.5 / K;
}

} // namespace mesobridge::sdpd
