#include "sdpd/start/layout.hpp"
#include "md/error.hpp"
#include "sdpd/start/count_sites.hpp"
#include "sdpd/state/random.hpp"
#include <algorithm>
#include <array>
#include <limits>

namespace mesobridge::sdpd {
namespace {

double volume_of(Cuboid const& cuboid) {
  Vec3 const edge = cuboid.to - cuboid.from;
  return edge.x * edge.y * edge.z;
}

bool is_empty(Cuboid const& cuboid) {
  Vec3 const edge = cuboid.to - cuboid.from;
  return !(edge.x > 0 && edge.y > 0 && edge.z > 0);
}

/// The sites of a cell, in its edges.
std::vector<Vec3> basis_of(Lattice lattice) {
  if (lattice == Lattice::fcc)
    return {{.25, .25, .25}, {.75, .75, .25}, {.75, .25, .75}, {.25, .75, .75}};
  return {{.5, .5, .5}};
}

/// How many cells fill a cuboid along x, y, z with so many sites in all, or nearly: whole numbers along the
/// two shorter edges, and along the longest the one that brings their product nearest to what is wanted.
std::array<std::uint64_t, 3> cells_along(Cuboid const& cuboid, double cell, double wanted) {
  Vec3 const edge = cuboid.to - cuboid.from;
  auto const whole = [](double x) { return static_cast<std::uint64_t>(std::max(1.0, std::round(x))); };
  std::array<std::uint64_t, 3> n{whole(edge.x / cell), whole(edge.y / cell), whole(edge.z / cell)};
  int const longest = edge.z >= edge.x && edge.z >= edge.y ? 2 : edge.y >= edge.x ? 1 : 0;
  auto const at = static_cast<std::size_t>(longest);
  auto const across = static_cast<double>(n[(at + 1) % 3] * n[(at + 2) % 3]);
  n[at] = whole(wanted / across);
  return n;
}

double random_number(std::uint32_t word) {
  return (word + 0.5) / 4294967296.0;
}

} // namespace

Layout::Layout(Vec3 const& edge, std::vector<Region> regions, std::uint64_t seed)
    : edge_(edge), regions_(std::move(regions)), seed_(seed), particles_(regions_.size()) {
  constexpr double most = std::numeric_limits<std::uint32_t>::max();
  double sites = 0;
  for (auto const& region : regions_) {
    require(region.outside || !is_empty(cuboid_of(region)), "region", region.name,
            "must have a part inside the box");
    sites += region.vacuum ? 0 : sites_of(region);
  }
  require(sites <= most, "particles in all regions", sites, fmt::format("must be <= {}", most));
  for (std::size_t r = 0; r < regions_.size(); ++r)
    size_ += particles_[r] = count(r);
  require(size_ >= 2, "particles in all regions", size_, "must be >= 2");
}

void Layout::for_each_place(std::function<void(Vec3 const&, std::size_t)> const& f) const {
  for (std::size_t r = 0; r < regions_.size(); ++r)
    if (!regions_[r].vacuum)
      for_each_site(r, [&](Vec3 const& q) {
        if (region_at(q) == r)
          f(q, r);
      });
}

Vec3 Layout::velocity_at(std::size_t region, Vec3 const& q) const {
  auto const& of = regions_[region];
  Vec3 const off = q - 0.5 * edge_;
  return of.velocity + off.x * of.along_x + off.y * of.along_y + off.z * of.along_z;
}

Cuboid Layout::cuboid_of(Region const& region) const {
  Cuboid const box{{}, edge_};
  return region.outside ? box : intersection(box, bounds(region.shape));
}

double Layout::sites_of(Region const& region) const {
  return volume_of(cuboid_of(region)) / std::pow(region.spacing, 3);
}

std::size_t Layout::region_at(Vec3 const& q) const {
  for (std::size_t r = regions_.size(); r-- > 0;)
    if (regions_[r].contains(q))
      return r;
  return regions_.size();
}

void Layout::for_each_site(std::size_t region, Sites const& f) const {
  if (regions_[region].lattice == Lattice::random)
    for_each_random_site(region, f);
  else
    for_each_lattice_site(regions_[region], f);
}

std::array<std::uint64_t, 3> Layout::cells_of(Region const& region) const {
  auto const per_cell = static_cast<double>(basis_of(region.lattice).size());
  return cells_along(cuboid_of(region), region.spacing * std::cbrt(per_cell), sites_of(region) / per_cell);
}

double Layout::excess(std::size_t region) const {
  auto const& of = regions_[region];
  if (of.lattice == Lattice::random)
    return std::round(sites_of(of)) / sites_of(of) - 1;
  auto const n = cells_of(of);
  return static_cast<double>(n[0] * n[1] * n[2] * basis_of(of.lattice).size()) / sites_of(of) - 1;
}

std::vector<Coordinates> Layout::lattice_of(Region const& region) const {
  auto const cuboid = cuboid_of(region);
  auto const n = cells_of(region);
  std::vector<Coordinates> lattice;
  for (auto const& b : basis_of(region.lattice)) {
    auto& at = lattice.emplace_back();
    for (int axis = 0; axis < 3; ++axis) {
      double const from = component(cuboid.from, axis), edge = component(cuboid.to, axis) - from;
      auto const cells = n[static_cast<std::size_t>(axis)];
      for (std::uint64_t k = 0; k < cells; ++k)
        at[static_cast<std::size_t>(axis)].push_back(
            from + edge * ((static_cast<double>(k) + component(b, axis)) / static_cast<double>(cells)));
    }
  }
  return lattice;
}

void Layout::for_each_lattice_site(Region const& region, Sites const& f) const {
  auto const lattice = lattice_of(region);
  auto const n = cells_of(region);
  for (std::uint64_t z = 0; z < n[2]; ++z)
    for (std::uint64_t y = 0; y < n[1]; ++y)
      for (std::uint64_t x = 0; x < n[0]; ++x)
        for (auto const& at : lattice)
          f({at[0][x], at[1][y], at[2][z]});
}

std::size_t Layout::count(std::size_t region) const {
  auto const& of = regions_[region];
  std::size_t count = 0;
  if (of.vacuum)
    return 0;
  if (of.lattice != Lattice::random) {
    std::optional<std::size_t> quick = 0;
    for (auto const& at : lattice_of(of))
      if (auto const more = count_sites(at, regions_, region); quick && more)
        *quick += *more;
      else
        quick = std::nullopt;
    if (quick)
      return *quick;
  }
  for_each_site(region, [&](Vec3 const& q) { count += region_at(q) == region; });
  return count;
}

void Layout::for_each_random_site(std::size_t region, Sites const& f) const {
  auto const cuboid = cuboid_of(regions_[region]);
  Vec3 const edge = cuboid.to - cuboid.from;
  auto const sites = static_cast<std::uint32_t>(std::llround(sites_of(regions_[region])));
  NoiseSource const source(seed_, Stream::initial_sites, 0);
  for (std::uint32_t k = 0; k < sites; ++k) {
    auto const word = Philox4x32::generate(
        {k, static_cast<std::uint32_t>(region), source.step_low, source.step_high_and_stream}, source.key);
    f(cuboid.from + Vec3{edge.x * random_number(word[0]), edge.y * random_number(word[1]),
                         edge.z * random_number(word[2])});
  }
}

} // namespace mesobridge::sdpd
