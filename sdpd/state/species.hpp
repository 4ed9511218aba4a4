#pragma once
#include "sdpd/state/particles.hpp"
#include <span>
#include <string>

namespace mesobridge::sdpd {

/// One kind of particles of a fluid that has several.
struct Species {
  std::string name;
  double share; ///< of the particles, > 0; those of all species sum to 1
  double mass;  ///< reduced
};

/// What a particle of unlike masses adds up over its neighbours to know its density (sdpd/README.md, Eq.
/// (S44)). Where the masses are equal it makes no difference.
enum class DensitySum {
  mass,  ///< rho_i = sum_j m_j W_ij: right where the mass per volume is smooth, as for two sizes of one fluid
  number ///< rho_i = m_i sum_j W_ij: right where the number per volume is, as at the interface of two fluids
};

/// How many of `count` particles are of each species: whole numbers by the largest remainders.
std::vector<std::size_t> species_counts(std::span<Species const> species, std::size_t count);

/// The mean mass of `count` particles; 1 without species.
double mean_mass(std::span<Species const> species, std::size_t count);

/// The species of each of `count` particles by their ids, which the seed draws.
std::vector<std::uint32_t> draw_species(std::span<Species const> species, std::size_t count,
                                        std::uint64_t seed);

} // namespace mesobridge::sdpd
