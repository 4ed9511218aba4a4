#include "sdpd/boundary/mirror.hpp"
#include <numeric>

namespace mesobridge::sdpd {

WallLayer::WallLayer(System const& system, Wall const& wall)
    : system_(system), wall_(wall),
      range_(system.neighbours.range()), across_{(wall.axis + 1) % 3, (wall.axis + 2) % 3} {
  auto const& q = system.particles.q;
  for (unsigned k = 0; k < 2; ++k)
    cells_[k] = std::max(1, static_cast<int>(component(system.box.edge, across_[k]) / range_));
  for (Index i = 0; i < system.size(); ++i)
    if (wall.distance(q[i], system.wall_time) < range_)
      members_.push_back(i);
  auto const index = [&](Index i) {
    auto const [x, y] = cell_of(q[i]);
    return static_cast<std::size_t>(y * cells_[0] + x);
  };
  cell_begin_.assign(static_cast<std::size_t>(cells_[0] * cells_[1]) + 1, 0);
  for (Index const i : members_)
    ++cell_begin_[index(i) + 1];
  std::partial_sum(cell_begin_.begin(), cell_begin_.end(), cell_begin_.begin());
  by_cell_.resize(members_.size());
  auto next = cell_begin_;
  for (Index const i : members_)
    by_cell_[next[index(i)]++] = i;
}

Vec3 WallLayer::from_image(Vec3 const& q, Vec3 const& of) const {
  Vec3 r = system_.box.minimum_image(q - of);
  double const both = wall_.distance(q, system_.wall_time) + wall_.distance(of, system_.wall_time);
  component(r, wall_.axis) = wall_.upper ? -both : both;
  return r;
}

std::array<int, 2> WallLayer::cell_of(Vec3 const& q) const {
  Vec3 const inside = system_.box.wrap(q);
  std::array<int, 2> cell{};
  for (unsigned k = 0; k < 2; ++k) {
    double const at = component(inside, across_[k]) / component(system_.box.edge, across_[k]) * cells_[k];
    cell[k] = static_cast<int>(std::clamp(at, 0.0, cells_[k] - 1.0));
  }
  return cell;
}

std::vector<int> WallLayer::around(int cell, unsigned edge) const {
  int const n = cells_[edge];
  std::vector<int> found;
  for (int const step : {-1, 0, 1}) {
    int at = cell + step;
    if (system_.box.periodic[static_cast<unsigned>(across_[edge])])
      at = (at + n) % n;
    if (at >= 0 && at < n && std::ranges::find(found, at) == found.end())
      found.push_back(at);
  }
  return found;
}

} // namespace mesobridge::sdpd
