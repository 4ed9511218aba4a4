#include "sdpd/boundary/layer_cells.hpp"
#include "sdpd/boundary/mirror.hpp"
#include "sdpd/simd/lanes.hpp"
#include <bit>

namespace mesobridge::sdpd {
namespace {

/// What the search for images works with, kept so that no step allocates: where the candidates are, how far
/// from the walls and then along the other axes, with a phantom past the end; and whose images each may see.
struct Search {
  std::array<std::vector<double>, 3> at;
  LayerCells cells;
  std::vector<std::vector<std::uint32_t>> near;
};

std::size_t whole_registers(std::size_t count) {
  return (count + lane_count - 1) / lane_count * lane_count;
}

/// The search behind one wall, or behind two or three of several axes at once: images of images.
template <std::size_t walls>
class ImageSearch {
 public:
  ImageSearch(System const& system, std::array<Wall const*, walls> const& of)
      : system_(system), walls_(of), range_(system.neighbours.range()), axes_{axis(0), axis(1), axis(2)} {
    bool moves = false;
    for (std::size_t k = 0; k < walls; ++k)
      now_[k] = of[k]->position(system.wall_time), moves |= of[k]->motion.moves();
    allowed_ = moves ? system.neighbours.skin() / 4 : 0;
    // Either particle comes nearer by half the skin, and the image by twice what each wall does.
    reach_ = range_ + system.neighbours.skin() + 2 * walls * allowed_;
    a_ = free_edge(0), b_ = free_edge(1);
  }

  void find(WallLayer& layer) const {
    thread_local Search of_caller;
    auto& search = of_caller; // the same for all threads of the loops below
    if (!is_kept(layer)) {
      find_candidates(layer);
      find_near(layer, search);
    }
    place(layer, system_.particles.q, search);
    find_particles(layer, search);
    for_each_index(layer.particles.size(), threads_for(system_, layer), [&, &search = search](std::size_t k) {
      layer.counts[k] = look(layer, search, layer.places[k]);
    });
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
  LayerEdge free_edge(std::size_t k) const {
    return walls + k < 3 ? LayerEdge(system_.box, axis(walls + k), reach_) : LayerEdge(0);
  }

  /// Whether the candidates of an earlier look are still all that may come within the range.
  bool is_kept(WallLayer const& layer) const {
    bool kept = layer.renewal == system_.neighbours.renewals();
    for (std::size_t k = 0; k < walls; ++k)
      kept &= std::abs(now_[k] - layer.position[static_cast<std::size_t>(walls_[k]->axis)]) <= allowed_;
    return kept;
  }

  /// Particles that may come within the range before the lists are renewed or the walls have moved too far.
  void find_candidates(WallLayer& layer) const {
    layer.renewal = system_.neighbours.renewals();
    for (std::size_t k = 0; k < walls; ++k)
      layer.position[static_cast<std::size_t>(walls_[k]->axis)] = now_[k];
    layer.candidates.clear();
    auto const at_renewal = system_.neighbours.positions_at_renewal();
    auto const take_if_near = [&](Index i) {
      bool near = true;
      for (std::size_t k = 0; k < walls; ++k)
        near &= walls_[k]->distance_from(now_[k], at_renewal[i]) < system_.neighbours.reach();
      if (near)
        layer.candidates.push_back(i);
    };
    if constexpr (walls == 1)
      for (Index i = 0; i < system_.size(); ++i)
        take_if_near(i);
    else // which that wall has looked for: its list is due whenever a corner's is
      std::ranges::for_each(walls_[0]->layer.candidates, take_if_near);
  }

  /// Where the candidates are, and the phantom, whose image nobody sees.
  void place(WallLayer const& layer, std::span<Vec3 const> q, Search& search) const {
    for (std::size_t d = 0; d < 3; ++d) {
      auto& at = search.at[d];
      at.resize(layer.candidates.size() + 1);
      for (std::size_t c = 0; c < layer.candidates.size(); ++c) {
        Vec3 const& here = q[layer.candidates[c]];
        at[c] = d < walls ? walls_[d]->distance_from(now_[d], here) : component(here, axes_[d]);
      }
      at.back() = d < walls ? 2 * range_ : 0;
    }
  }

  /// Whose images each candidate may see, from where the particles were when the lists were renewed. The
  /// order depends on that alone: a restart has the same.
  void find_near(WallLayer& layer, Search& search) const {
    std::size_t const count = layer.candidates.size();
    place(layer, system_.neighbours.positions_at_renewal(), search);
    auto& [at, cells, near] = search;
    cells.sort(a_, b_, at, axis_a, count, lane_count);
    near.resize(std::max(near.size(), count));
    for_each_index(count, system_.threads, [&, &search = search](std::size_t c) { find_near(search, c); });
    layer.begin.assign(count + 1, 0);
    for (std::size_t c = 0; c < count; ++c)
      layer.begin[c + 1] = layer.begin[c] + whole_registers(near[c].size());
    layer.near.assign(layer.begin.back(), static_cast<std::uint32_t>(count));
    for (std::size_t c = 0; c < count; ++c)
      std::ranges::copy(near[c], layer.near.data() + layer.begin[c]);
    auto& [of, x, y, z] = layer.images;
    of.resize(layer.near.size()), x.resize(of.size()), y.resize(of.size()), z.resize(of.size());
  }

  /// Whose images one candidate may see.
  void find_near(Search& search, std::size_t c) const {
    auto const& at = search.at;
    auto const& cells = search.cells;
    auto& near = search.near[c];
    Lanes const reach2 = broadcast(reach_ * reach_);
    std::size_t found = 0;
    cells.for_each_around(a_, b_, at[axis_a][c], at[2][c], [&](std::size_t begin, std::size_t end) {
      near.resize(std::max(near.size(), found + whole_registers(end - begin)));
      for (std::size_t m = begin; m < end; m += lane_count) {
        Lanes r2{};
        for (std::size_t d = 0; d < 3; ++d) {
          Lanes const one = way(d, broadcast(at[d][c]), load<Lanes>(&cells.at[d][m]));
          r2 += one * one;
        }
        unsigned const present = end - m < lane_count ? (1u << (end - m)) - 1 : 0xffu;
        unsigned const bits = less(r2, reach2) & present;
        compress(bits, &cells.places[m], &near[found]);
        found += static_cast<std::size_t>(std::popcount(bits));
      }
    });
    near.resize(found);
  }

  /// Those of the candidates that are within the range now.
  void find_particles(WallLayer& layer, Search const& search) const {
    layer.particles.clear(), layer.places.clear();
    for (std::size_t c = 0; c < layer.candidates.size(); ++c) {
      bool near = true;
      for (std::size_t k = 0; k < walls; ++k)
        near &= search.at[k][c] < range_;
      if (near)
        layer.particles.push_back(layer.candidates[c]), layer.places.push_back(static_cast<std::uint32_t>(c));
    }
    layer.counts.resize(layer.particles.size());
  }

  /// From the image of a place to another place, along the walls' normals and then along the other axes.
  template <class X>
  X way(std::size_t d, X const& here, X const& there) const {
    if (d < walls)
      return here + there;
    return (d == walls ? a_ : b_).nearest(X(here - there));
  }

  /// Finds the images that one candidate sees, and says how many.
  std::uint32_t look(WallLayer& layer, Search const& search, std::uint32_t c) const {
    Lanes const range2 = broadcast(range_ * range_);
    std::array<double*, 3> const to{layer.images.x.data(), layer.images.y.data(), layer.images.z.data()};
    std::size_t const first = layer.begin[c];
    std::size_t found = first;
    for (std::size_t m = first; m < layer.begin[c + 1]; m += lane_count) {
      std::array<Lanes, 3> r;
      for (std::size_t d = 0; d < 3; ++d)
        r[d] = way(d, broadcast(search.at[d][c]), gather(search.at[d].data(), &layer.near[m]));
      unsigned const bits = less(r[0] * r[0] + r[1] * r[1] + r[2] * r[2], range2);
      compress(bits, &layer.near[m], &layer.images.of[found]);
      for (std::size_t d = 0; d < 3; ++d)
        compress(bits, d < walls && walls_[d]->upper ? -r[d] : r[d],
                 to[static_cast<std::size_t>(axes_[d])] + found);
      found += static_cast<std::size_t>(std::popcount(bits));
    }
    for (std::size_t m = found; m % lane_count != 0; ++m) {
      layer.images.of[m] = static_cast<std::uint32_t>(layer.candidates.size());
      to[0][m] = 0.5 * range_, to[1][m] = 0, to[2][m] = 0; // within what kernels are made for
    }
    return static_cast<std::uint32_t>(found - first);
  }

  static constexpr std::size_t axis_a = walls < 2 ? 1 : 2; ///< the one that a_ goes along, if there is one

  System const& system_;
  std::array<Wall const*, walls> walls_;
  std::array<double, walls> now_{};
  double range_, allowed_ = 0, reach_ = 0;
  std::array<int, 3> axes_; ///< of the walls, then the others
  LayerEdge a_{0}, b_{0};
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
