#include "sdpd/boundary/mirror.hpp"

namespace mesobridge::sdpd {
namespace {

/// One of the edges of the box along the walls, in cells that are at least as long as the range; in corners,
/// where there is none to walk along, one cell.
struct Edge {
  int axis;
  double length = 1, inverse = 1;
  bool periodic = false;
  int cells = 1;

  explicit Edge(int along) : axis(along) {}
  Edge(Box const& box, int along, double range)
      : axis(along), length(component(box.edge, along)), inverse(1 / length),
        periodic(box.periodic[static_cast<unsigned>(along)]),
        cells(std::max(1, static_cast<int>(length / range))) {}

  int cell_of(double at) const { return static_cast<int>(std::clamp(at / length * cells, 0.0, cells - 1.0)); }
  double nearest(double way) const { return way - turns(way) * length; }
  /// A periodic box is at least twice as long as the range: where the two ends are as near, it does not
  /// matter.
  double turns(double way) const { return periodic ? std::nearbyint(way * inverse) : 0; }

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

/// What the search for images works with, kept so that no step allocates: the places in the layer's order,
/// and again cell after cell, in each in that order.
struct Search {
  std::vector<Place> places;
  std::vector<std::size_t> begin, next; ///< of the cells
  std::array<std::vector<double>, 3> at;
  std::vector<Index> particle;
};

/// The search behind one wall, or behind two or three of several axes at once: images of images.
template <std::size_t walls>
class ImageSearch {
 public:
  ImageSearch(System const& system, std::array<Wall const*, walls> const& of)
      : system_(system), walls_(of), range_(system.neighbours.range()), a_(free_edge(0)),
        b_(free_edge(1)), axes_{axis(0), axis(1), axis(2)} {
    for (std::size_t k = 0; k < walls; ++k)
      now_[k] = of[k]->position(system.wall_time);
  }

  void find(WallLayer& layer) const {
    find_candidates(layer);
    thread_local Search of_caller;
    auto& search = of_caller; // the same for all threads of the loop below
    place(layer, search);
    auto& images = layer.images;
    images.resize(std::max(images.size(), layer.particles.size()));
    for_each_index(layer.particles.size(), threads_for(system_, layer),
                   [&, &search = search](std::size_t k) { look(search, search.places[k], images[k]); });
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
    auto const take_if_near = [&](Index i) {
      bool near = true;
      for (std::size_t k = 0; k < walls; ++k)
        near &= walls_[k]->distance_from(now_[k], at_renewal[i]) < neighbours.reach();
      if (near)
        layer.candidates.push_back(i);
    };
    if constexpr (walls == 1)
      for (Index i = 0; i < system_.size(); ++i)
        take_if_near(i);
    else // which that wall has looked for just now: its list is due whenever a corner's is
      std::ranges::for_each(walls_[0]->layer.candidates, take_if_near);
  }
  double& position_of(WallLayer& layer, std::size_t k) const {
    return layer.position[static_cast<std::size_t>(walls_[k]->axis)];
  }

  /// Finds the layer's particles and puts them into cells.
  void place(WallLayer& layer, Search& search) const {
    layer.particles.clear(), search.places.clear();
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
      search.places.push_back(here);
      layer.particles.push_back(i);
    }
    sort(layer, search);
  }

  void sort(WallLayer const& layer, Search& search) const {
    auto& [places, begin, next, at, particle] = search;
    begin.assign(static_cast<std::size_t>(a_.cells * b_.cells) + 1, 0);
    for (auto const& here : places)
      ++begin[cell(here.cell_a, here.cell_b) + 1];
    for (std::size_t c = 1; c < begin.size(); ++c)
      begin[c] += begin[c - 1];
    next.assign(begin.begin(), begin.end() - 1);
    for (auto& values : at)
      values.resize(places.size());
    particle.resize(places.size());
    for (std::size_t k = 0; k < places.size(); ++k) {
      auto const m = next[cell(places[k].cell_a, places[k].cell_b)]++;
      for (std::size_t d = 0; d < 3; ++d)
        at[d][m] = places[k].at[d];
      particle[m] = layer.particles[k];
    }
  }

  /// Finds the images that one particle sees.
  void look(Search const& search, Place const& here, std::vector<WallImage>& seen) const {
    seen.clear();
    b_.for_each_around(here.cell_b, [&](int y) {
      a_.for_each_around(here.cell_a, [&](int x) {
        look(search, here, search.begin[cell(x, y)], search.begin[cell(x, y) + 1], seen);
      });
    });
  }

  /// From the image of a place to another place, along the walls' normals and then along the other axes.
  double way(std::size_t d, double here, double there) const {
    if (d < walls)
      return here + there;
    return (d == walls ? a_ : b_).nearest(here - there);
  }

  /// Of the particles begin ... end-1 in the order of the cells: squares of distances first, which
  /// vectorises.
  void look(Search const& search, Place const& here, std::size_t begin, std::size_t end,
            std::vector<WallImage>& seen) const {
    constexpr std::size_t at_once = 64;
    std::array<double, at_once> r2;
    for (; begin < end; begin += at_once) {
      std::size_t const count = std::min(at_once, end - begin);
      for (std::size_t m = 0; m < count; ++m) {
        double const x = way(0, here.at[0], search.at[0][begin + m]),
                     y = way(1, here.at[1], search.at[1][begin + m]),
                     z = way(2, here.at[2], search.at[2][begin + m]);
        r2[m] = x * x + y * y + z * z;
      }
      for (std::size_t m = 0; m < count; ++m)
        if (r2[m] < range_ * range_)
          seen.push_back({search.particle[begin + m], from_image(search, here, begin + m)});
    }
  }

  Vec3 from_image(Search const& search, Place const& here, std::size_t m) const {
    Vec3 r;
    for (std::size_t d = 0; d < 3; ++d) {
      double const one = way(d, here.at[d], search.at[d][m]);
      component(r, axes_[d]) = d < walls && walls_[d]->upper ? -one : one;
    }
    return r;
  }

  System const& system_;
  std::array<Wall const*, walls> walls_;
  std::array<double, walls> now_{};
  double range_;
  Edge a_, b_;
  std::array<int, 3> axes_; ///< of the walls, then the others
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
