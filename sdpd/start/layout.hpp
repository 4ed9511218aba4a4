#pragma once
#include "sdpd/start/shape.hpp"
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace mesobridge::sdpd {

/// How particles stand at the start.
enum class Lattice {
  cubic,
  fcc,
  random ///< anywhere, independent of each other
};

/// A part of the box, and how it starts. In reduced units.
struct Region {
  std::string name;
  Shape shape;
  bool outside = false; ///< all of the box but the shape
  bool vacuum = false;  ///< no particles; what follows says nothing then
  Lattice lattice = Lattice::cubic;
  double spacing = 1; ///< (m/rho)^(1/3), > 0
  std::uint32_t species = 0;
  double T = 1;        ///< >= 0
  double progress = 0; ///< of a reaction
  Vec3 velocity = {};  ///< at the middle of the box
  /// How the velocity changes along x, y and z.
  Vec3 along_x = {}, along_y = {}, along_z = {};

  bool contains(Vec3 const& q) const { return sdpd::contains(shape, q) != outside; }
};

/// The coordinates of sites along x, y and z: there is one at each combination of them.
using Coordinates = std::array<std::vector<double>, 3>;

/// Where the particles of a box begin that several regions fill, each with its own lattice, density,
/// temperature and velocity. What a region holds, those behind it in the list take from it.
class Layout {
 public:
  /// Throws InputError when the regions hold less than two particles or more than an index can count, or
  /// when a region lies outside the box.
  Layout(Vec3 const& edge, std::vector<Region> regions, std::uint64_t seed);

  Vec3 const& edge() const { return edge_; }
  std::vector<Region> const& regions() const { return regions_; }
  std::size_t size() const { return size_; }                               ///< particles in all
  std::vector<std::size_t> const& particles() const { return particles_; } ///< of each region

  /// Calls f(q, r) for the place of each particle of region r, region by region, always in the same order.
  void for_each_place(std::function<void(Vec3 const&, std::size_t)> const& f) const;

  std::size_t region_at(Vec3 const& q) const; ///< the last that holds the place; their number for none

  /// By which part the lattice of a region holds more sites than its density asks for: whole cells fill it.
  double excess(std::size_t region) const;

  /// The mean velocity at a place of a region.
  Vec3 velocity_at(std::size_t region, Vec3 const& q) const;

 private:
  using Sites = std::function<void(Vec3 const&)>;

  Cuboid cuboid_of(Region const& region) const; ///< of the box, that the region's lattice fills
  double sites_of(Region const& region) const;  ///< wanted, in that cuboid
  std::array<std::uint64_t, 3> cells_of(Region const& region) const;
  std::vector<Coordinates> lattice_of(Region const& region) const; ///< for each site of a cell
  std::size_t count(std::size_t region) const;                     ///< of the particles
  void for_each_site(std::size_t region, Sites const& f) const;
  void for_each_lattice_site(Region const& region, Sites const& f) const;
  void for_each_random_site(std::size_t region, Sites const& f) const;

  Vec3 edge_;
  std::vector<Region> regions_;
  std::uint64_t seed_;
  std::vector<std::size_t> particles_;
  std::size_t size_ = 0;
};

} // namespace mesobridge::sdpd
