#include "sdpd/state/species.hpp"
#include "sdpd/state/random.hpp"
#include <algorithm>
#include <cmath>
#include <numeric>

namespace mesobridge::sdpd {

std::vector<std::size_t> species_counts(std::span<Species const> species, std::size_t count) {
  std::vector<std::size_t> counts, by_remainder(species.size());
  std::vector<double> remainders;
  for (auto const& [name, share, mass] : species) {
    double const wanted = share * static_cast<double>(count), whole = std::floor(wanted);
    counts.push_back(static_cast<std::size_t>(whole)), remainders.push_back(wanted - whole);
  }
  std::iota(by_remainder.begin(), by_remainder.end(), std::size_t{0});
  std::ranges::stable_sort(by_remainder, std::greater(), [&](std::size_t s) { return remainders[s]; });
  std::size_t given = std::accumulate(counts.begin(), counts.end(), std::size_t{0});
  for (std::size_t k = 0; given < count; ++k, ++given)
    ++counts[by_remainder[k % by_remainder.size()]];
  return counts;
}

double mean_mass(std::span<Species const> species, std::size_t count) {
  if (species.empty())
    return 1;
  double sum = 0;
  auto const counts = species_counts(species, count);
  for (std::size_t s = 0; s < counts.size(); ++s)
    sum += static_cast<double>(counts[s]) * species[s].mass;
  return sum / static_cast<double>(count);
}

std::vector<std::uint32_t> draw_species(std::span<Species const> species, std::size_t count,
                                        std::uint64_t seed) {
  NoiseSource const source(seed, Stream::species, 0);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> drawn; // a random number, and the id
  for (std::uint32_t id = 0; id < count; ++id)
    drawn.emplace_back(
        Philox4x32::generate({id, 0, source.step_low, source.step_high_and_stream}, source.key)[0], id);
  std::ranges::sort(drawn);
  std::vector<std::uint32_t> of(count);
  auto next = drawn.begin();
  auto const counts = species_counts(species, count);
  for (std::uint32_t s = 0; s < counts.size(); ++s)
    for (std::size_t k = 0; k < counts[s]; ++k, ++next)
      of[next->second] = s;
  return of;
}

} // namespace mesobridge::sdpd
