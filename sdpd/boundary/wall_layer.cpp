#include "sdpd/boundary/mirror.hpp"

namespace mesobridge::sdpd {
namespace {

/// One of the two edges of the box across a wall, in cells that are at least as long as the range.
struct Edge {
  int axis;
  double length;
  bool periodic;
  int cells;

  Edge(Box const& box, int along, double range)
      : axis(along), length(component(box.edge, along)), periodic(box.periodic[static_cast<unsigned>(along)]),
        cells(std::max(1, static_cast<int>(length / range))) {}

  int cell_of(double at) const { return static_cast<int>(std::clamp(at / length * cells, 0.0, cells - 1.0)); }
  double nearest(double way) const { return periodic ? way - length * std::nearbyint(way / length) : way; }

  /// Calls f for the cell and those beside it, each once.
  template <class F>
  void for_each_around(int cell, F const& f) const {
    bool const all = periodic && cells <= 3;
    int const first = all ? 0 : periodic ? cell - 1 : std::max(0, cell - 1);
    int const last = all ? cells - 1 : periodic ? cell + 1 : std::min(cells - 1, cell + 1);
    for (int at = first; at <= last; ++at)
      f((at + cells) % cells);
  }
};

/// Where a particle of the layer is: across the wall, and how far from it.
struct Place {
  double a, b, distance;
  int cell_a, cell_b;
};

/// Particles that may come within the range before the lists are renewed, and so has each come by half their
/// skin, or the wall by as much. Those of an earlier look are kept as long as that holds.
void find_candidates(System const& system, Wall& wall) {
  auto const& neighbours = system.neighbours;
  auto& layer = wall.layer;
  double const now = wall.position(system.wall_time);
  if (layer.renewal == neighbours.renewals() && std::abs(now - layer.position) <= neighbours.skin() / 2)
    return;
  layer.renewal = neighbours.renewals(), layer.position = now;
  layer.candidates.clear();
  auto const at_renewal = neighbours.positions_at_renewal();
  for (Index i = 0; i < system.size(); ++i)
    if (wall.distance(at_renewal[i], system.wall_time) < neighbours.reach())
      layer.candidates.push_back(i);
}

/// What the search for images works with, kept so that no step allocates.
struct Search {
  std::vector<Place> places;
  std::vector<std::vector<Index>> in_cell;
};

void find_images(System const& system, Wall& wall) {
  double const range = system.neighbours.range();
  find_candidates(system, wall);
  auto& particles = wall.layer.particles;
  auto& images = wall.layer.images;
  Edge const a(system.box, (wall.axis + 1) % 3, range), b(system.box, (wall.axis + 2) % 3, range);
  thread_local Search of_caller;
  auto& [places, in_cell] = of_caller; // the same for all threads of the loop below
  particles.clear(), places.clear();
  in_cell.resize(static_cast<std::size_t>(a.cells * b.cells));
  for (auto& some : in_cell)
    some.clear();
  auto const cell = [&](int x, int y) { return static_cast<std::size_t>(y * a.cells + x); };
  for (Index const i : wall.layer.candidates)
    if (double const distance = wall.distance(system.particles.q[i], system.wall_time); distance < range) {
      Vec3 const q = system.box.wrap(system.particles.q[i]);
      double const x = component(q, a.axis), y = component(q, b.axis);
      in_cell[cell(a.cell_of(x), b.cell_of(y))].push_back(static_cast<Index>(particles.size()));
      places.push_back({x, y, distance, a.cell_of(x), b.cell_of(y)});
      particles.push_back(i);
    }
  images.resize(std::max(images.size(), particles.size()));
  for_each_index(particles.size(), system.threads, [&, &places = places, &in_cell = in_cell](std::size_t k) {
    auto const& here = places[k];
    auto& seen = images[k];
    seen.clear();
    b.for_each_around(here.cell_b, [&](int y) {
      a.for_each_around(here.cell_a, [&](int x) {
        for (Index const other : in_cell[cell(x, y)]) {
          auto const& there = places[other];
          double const both = here.distance + there.distance;
          if (both >= range)
            continue;
          Vec3 r;
          component(r, wall.axis) = wall.upper ? -both : both;
          component(r, a.axis) = a.nearest(here.a - there.a),
                       component(r, b.axis) = b.nearest(here.b - there.b);
          if (norm2(r) < range * range)
            seen.push_back({particles[other], r});
        }
      });
    });
  });
}

} // namespace

void find_wall_images(System& system) {
  for (auto& wall : system.walls)
    find_images(system, wall);
}

} // namespace mesobridge::sdpd
