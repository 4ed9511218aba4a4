#include "sdpd/boundary/mirror.hpp"

namespace mesobridge::sdpd {
namespace {

/// One of the edges of the box along the walls, in cells that are at least as long as the range; in corners,
/// where there is none to walk along, one cell.
struct Edge {
  int axis;
  double length = 0;
  bool periodic = false;
  int cells = 1;

  explicit Edge(int along) : axis(along) {}
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

/// Where a particle of the layer is: how far from the walls, then along the other axes.
struct Place {
  std::array<double, 3> at;
  int cell_a, cell_b;
};

/// What the search for images works with, kept so that no step allocates.
struct Search {
  std::vector<Place> places;
  std::vector<std::vector<Index>> in_cell;
};

/// The search behind one wall, or behind two or three of several axes at once: images of images.
template <std::size_t walls>
class ImageSearch {
 public:
  ImageSearch(System const& system, std::array<Wall const*, walls> const& of)
      : system_(system), walls_(of), range_(system.neighbours.range()), a_(free_edge(0)), b_(free_edge(1)) {
    for (std::size_t k = 0; k < walls; ++k)
      now_[k] = of[k]->position(system.wall_time);
  }

  void find(WallLayer& layer) const {
    find_candidates(layer);
    auto& [particles, images, candidates, renewal, position] = layer;
    thread_local Search of_caller;
    auto& [places, in_cell] = of_caller; // the same for all threads of the loop below
    place(layer, places, in_cell);
    images.resize(std::max(images.size(), particles.size()));
    for_each_index(particles.size(), system_.threads,
                   [&, &particles = particles, &images = images, &places = places,
                    &in_cell = in_cell](std::size_t k) { look(k, particles, places, in_cell, images[k]); });
  }

 private:
  /// The axes of the walls, then the others, in turn after the first wall's.
  int axis(std::size_t k) const {
    if (k < walls)
      return walls_[k]->axis;
    int free = walls_[0]->axis;
    for (std::size_t seen = walls; seen <= k; ++seen)
      do
        free = (free + 1) % 3;
      while (is_walled(free));
    return free;
  }
  bool is_walled(int axis) const {
    return std::ranges::any_of(walls_, [&](Wall const* wall) { return wall->axis == axis; });
  }
  Edge free_edge(std::size_t k) const {
    return walls + k < 3 ? Edge(system_.box, axis(walls + k), range_) : Edge(0);
  }
  std::size_t cell(int x, int y) const { return static_cast<std::size_t>(y * a_.cells + x); }

  /// Particles that may come within the range before the lists are renewed, and so has each come by half
  /// their skin, or a wall by as much. Those of an earlier look are kept as long as that holds.
  void find_candidates(WallLayer& layer) const {
    auto const& neighbours = system_.neighbours;
    bool kept = layer.renewal == neighbours.renewals();
    for (std::size_t k = 0; k < walls; ++k)
      kept &= std::abs(now_[k] - position_of(layer, k)) <= neighbours.skin() / 2;
    if (kept)
      return;
    layer.renewal = neighbours.renewals();
    for (std::size_t k = 0; k < walls; ++k)
      position_of(layer, k) = now_[k];
    layer.candidates.clear();
    auto const at_renewal = neighbours.positions_at_renewal();
    for (Index i = 0; i < system_.size(); ++i) {
      bool near = true;
      for (std::size_t k = 0; k < walls; ++k)
        near &= walls_[k]->distance_from(now_[k], at_renewal[i]) < neighbours.reach();
      if (near)
        layer.candidates.push_back(i);
    }
  }
  double& position_of(WallLayer& layer, std::size_t k) const {
    return layer.position[static_cast<std::size_t>(walls_[k]->axis)];
  }

  /// Finds the layer's particles and puts them into cells.
  void place(WallLayer& layer, std::vector<Place>& places, std::vector<std::vector<Index>>& in_cell) const {
    layer.particles.clear(), places.clear();
    in_cell.resize(static_cast<std::size_t>(a_.cells * b_.cells));
    for (auto& some : in_cell)
      some.clear();
    for (Index const i : layer.candidates) {
      Place here{};
      bool near = true;
      for (std::size_t k = 0; k < walls; ++k) {
        here.at[k] = walls_[k]->distance_from(now_[k], system_.particles.q[i]);
        near &= here.at[k] < range_;
      }
      if (!near)
        continue;
      Vec3 const q = system_.box.wrap(system_.particles.q[i]);
      if constexpr (walls < 3)
        here.at[walls] = component(q, a_.axis), here.cell_a = a_.cell_of(here.at[walls]);
      if constexpr (walls < 2)
        here.at[walls + 1] = component(q, b_.axis), here.cell_b = b_.cell_of(here.at[walls + 1]);
      in_cell[cell(here.cell_a, here.cell_b)].push_back(static_cast<Index>(layer.particles.size()));
      places.push_back(here);
      layer.particles.push_back(i);
    }
  }

  /// Finds the images that the k-th particle of the layer sees.
  void look(std::size_t k, std::vector<Index> const& particles, std::vector<Place> const& places,
            std::vector<std::vector<Index>> const& in_cell, std::vector<WallImage>& seen) const {
    auto const& here = places[k];
    seen.clear();
    b_.for_each_around(here.cell_b, [&](int y) {
      a_.for_each_around(here.cell_a, [&](int x) {
        for (Index const other : in_cell[cell(x, y)]) {
          auto const& there = places[other];
          Vec3 r;
          bool near = true;
          for (std::size_t w = 0; w < walls; ++w) {
            double const both = here.at[w] + there.at[w];
            near &= both < range_;
            component(r, walls_[w]->axis) = walls_[w]->upper ? -both : both;
          }
          if (!near)
            continue;
          if constexpr (walls < 3)
            component(r, a_.axis) = a_.nearest(here.at[walls] - there.at[walls]);
          if constexpr (walls < 2)
            component(r, b_.axis) = b_.nearest(here.at[walls + 1] - there.at[walls + 1]);
          if (norm2(r) < range_ * range_)
            seen.push_back({particles[other], r});
        }
      });
    });
  }

  System const& system_;
  std::array<Wall const*, walls> walls_;
  std::array<double, walls> now_{};
  double range_;
  Edge a_, b_;
};

} // namespace

void find_wall_images(System& system) {
  auto const& walls = system.walls;
  for (auto& wall : system.walls)
    ImageSearch<1>(system, {&wall}).find(wall.layer);
  for (auto& [of, layer] : system.corners)
    if (of.size() == 2)
      ImageSearch<2>(system, {&walls[of[0]], &walls[of[1]]}).find(layer);
    else
      ImageSearch<3>(system, {&walls[of[0]], &walls[of[1]], &walls[of[2]]}).find(layer);
}

} // namespace mesobridge::sdpd
