#pragma once
#include "sdpd/system/system.hpp"

namespace mesobridge::sdpd {

/// The particles that a wall's images can reach, by places across it, found anew for each sum over them.
class WallLayer {
 public:
  /// Those nearer to the wall than the range of the interaction.
  WallLayer(System const& system, Wall const& wall);

  std::size_t size() const { return members_.size(); }
  Index operator[](std::size_t k) const { return members_[k]; }

  /// Calls f(j, r) for every particle j of the layer, i itself too, whose image is within the range of i; r
  /// points from the image to i. In an order that the positions decide.
  template <class F>
  void for_each_image(Index i, F const& f) const {
    Vec3 const& q = system_.particles.q[i];
    auto const [a, b] = cell_of(q);
    for (int const y : around(b, 1))
      for (int const x : around(a, 0)) {
        auto const cell = static_cast<std::size_t>(y * cells_[0] + x);
        for (Index k = cell_begin_[cell]; k < cell_begin_[cell + 1]; ++k)
          if (Vec3 const r = from_image(q, system_.particles.q[by_cell_[k]]); norm2(r) < range_ * range_)
            f(by_cell_[k], r);
      }
  }

 private:
  Vec3 from_image(Vec3 const& q, Vec3 const& of) const;
  std::array<int, 2> cell_of(Vec3 const& q) const;
  /// The cell and its neighbours along one of the two edges across the wall, each once.
  std::vector<int> around(int cell, unsigned edge) const;

  System const& system_;
  Wall const& wall_;
  double range_;
  std::array<int, 2> across_; ///< the axes across the wall
  std::array<int, 2> cells_;
  std::vector<Index> members_, by_cell_, cell_begin_;
};

/// Adds what the images behind the walls give to the particles' densities (sdpd/README.md, Eq. (S40)).
void add_wall_densities(System& system);

/// Adds the forces of pressures by the images, and notes what each wall exerts (Eq. (S41)).
void add_wall_forces(System& system);

/// The same of the pair potential (DPD, DPDE), with its energy (Eq. (S42)). Throws PhysicsError when a
/// particle is nearer to an image than the potential is defined.
void add_wall_pair_forces(System& system);

/// What the walls give in a kick over dt: impulse and work.
void count_wall_impulses(System& system, double dt);

/// Lets the walls move, if they are not held, and reflects particles that have come through one in its frame.
void move_walls(System& system, double dt);

} // namespace mesobridge::sdpd
