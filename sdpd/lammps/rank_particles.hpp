#pragma once
#include <cstddef>
#include <cstdint>

namespace mesobridge::sdpd {

/// The particles that one rank sees: its own first, then the ghosts, which are other ranks' particles and
/// periodic images near its part of the box. Rows of three numbers, reduced; velocities are momenta, because
/// masses are one.
struct RankParticles {
  std::size_t owned, all;
  double const* q;
  double *v, *f;
  std::int32_t const* ids; ///< from 1
  /// Half list of pairs, each once over all ranks: the neighbours of each of `first_count` own particles.
  struct HalfList {
    std::size_t first_count;
    int const *first, *neighbour_count;
    int const* const* neighbours;
    int mask; ///< the bits of a neighbour that are its number
  } list;
  double const *low, *high; ///< corners of this rank's part of the box

  std::uint32_t id(std::size_t i) const { return static_cast<std::uint32_t>(ids[i]) - 1; }
};

/// Numbers of the particles on their way between ranks: the first `width` of each row of `stride` numbers.
struct TravellingRows {
  double* rows;
  int stride, width;
};

/// Brings numbers of the particles from their owners to the ghosts and back; all ranks call it together.
class GhostExchange {
 public:
  virtual ~GhostExchange() = default;
  /// The ghosts' numbers become those of their owners.
  virtual void forward(TravellingRows const& rows) = 0;
  /// The ghosts' numbers are added to those of their owners.
  virtual void reverse(TravellingRows const& rows) = 0;
};

} // namespace mesobridge::sdpd
