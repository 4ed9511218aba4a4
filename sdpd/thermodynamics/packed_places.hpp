#pragma once
#include "fitting/simd/pack.hpp"
#include <algorithm>
#include <cstddef>
#include <vector>

namespace mesobridge::sdpd {

/// Neighbouring particles that fill a pack; where there are fewer, the last one fills the lanes left over.
struct PackedPlaces {
  std::size_t first;
  int count;

  PackedPlaces(std::size_t first, std::size_t end)
      : first(first),
        count(static_cast<int>(std::min(end - first, static_cast<std::size_t>(fitting::Pack::size)))) {}

  fitting::Pack load(std::vector<double> const& from) const {
    if (count == fitting::Pack::size)
      return fitting::Pack::load(&from[first]);
    fitting::Pack some = from[first + static_cast<std::size_t>(count) - 1];
    for (int lane = 0; lane < count; ++lane)
      some.v[lane] = from[first + static_cast<std::size_t>(lane)];
    return some;
  }
  /// Writes the lanes of the mask.
  void store(fitting::Pack values, fitting::PackMask where, std::vector<double>& to) const {
    if (count == fitting::Pack::size && fitting::all_of(where))
      return values.store(&to[first]);
    for (int lane = 0; lane < count; ++lane)
      if (where[lane])
        to[first + static_cast<std::size_t>(lane)] = values.v[lane];
  }
  /// Calls f(place) for the lanes outside the mask.
  template <class F>
  void for_each_outside(fitting::PackMask mask, F const& f) const {
    if (fitting::all_of(mask)) [[likely]]
      return;
    for (int lane = 0; lane < count; ++lane)
      if (!mask[lane])
        f(first + static_cast<std::size_t>(lane));
  }
};

} // namespace mesobridge::sdpd
