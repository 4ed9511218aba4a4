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

/// How many of `count` particles are of each species: whole numbers by the largest remainders.
std::vector<std::size_t> species_counts(std::span<Species const> species, std::size_t count);

/// The mean mass of `count` particles; 1 without species.
double mean_mass(std::span<Species const> species, std::size_t count);

/// The species of each of `count` particles by their ids, which the seed draws.
std::vector<std::uint32_t> draw_species(std::span<Species const> species, std::size_t count,
                                        std::uint64_t seed);

} // namespace mesobridge::sdpd
