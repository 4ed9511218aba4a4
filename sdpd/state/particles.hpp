#pragma once
#include "md/box.hpp"
#include "sdpd/state/caloric.hpp"
#include <cstdint>
#include <vector>

namespace mesobridge::sdpd {

using Index = std::uint32_t;

/// The particles of one size, as a structure of arrays in reduced units (mass 1). The order in memory follows
/// the cells and changes when lists are renewed; `id` says who is who. Arrays that the method does not need
/// are empty: DPDE has no densities, DPD no internal energies either.
struct Particles {
  std::vector<std::uint32_t> id;
  std::vector<Vec3> q;     ///< position; leaves the box between two renewals of the lists
  std::vector<Vec3> p;     ///< momentum
  std::vector<double> eps; ///< internal energy
  std::vector<double> rho; ///< density, with the self term
  std::vector<double> S;   ///< entropy
  std::vector<double> T;   ///< internal temperature
  std::vector<double> P;   ///< pressure
  std::vector<Vec3> f;     ///< conservative force
  std::vector<Caloric> caloric;

  std::size_t size() const { return id.size(); }

  void resize(std::size_t n, bool energies = true, bool densities = true) {
    id.resize(n), q.resize(n), p.resize(n), f.resize(n);
    if (energies)
      eps.resize(n), T.resize(n), caloric.resize(n);
    if (densities)
      rho.resize(n), S.resize(n), P.resize(n);
  }
};

} // namespace mesobridge::sdpd
