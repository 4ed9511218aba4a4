#include "sdpd/neighbours/matchings.hpp"
#include <array>
#include <bit>
#include <limits>
#include <stdexcept>

namespace mesobridge::sdpd {
namespace {

constexpr std::size_t word_bits = 64;

/// The matching of each pair, with room for words * 64 of them. False when those are too few.
template <std::size_t words>
bool colour(std::span<LocalPair const> pairs, std::size_t particles, std::vector<std::uint32_t>& matching) {
  using Matchings = std::array<std::uint64_t, words>; // that a particle is in already, as bits
  thread_local std::vector<Matchings> taken;
  taken.assign(particles, Matchings{});
  matching.resize(pairs.size());
  // Pairs come in runs of the same first particle, whose bits stay in registers meanwhile.
  Matchings own{};
  std::size_t first = 0;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    if (pairs[k].i != first) {
      taken[first] = own;
      first = pairs[k].i;
      own = taken[first];
    }
    auto& other = taken[pairs[k].j];
    std::size_t w = 0;
    while (w < words && (own[w] | other[w]) == ~std::uint64_t{0})
      ++w;
    if (w == words)
      return false;
    std::uint64_t const free = ~(own[w] | other[w]), bit = free & -free;
    own[w] |= bit, other[w] |= bit;
    matching[k] =
        static_cast<std::uint32_t>(w * word_bits) + static_cast<std::uint32_t>(std::countr_zero(free));
  }
  return true;
}

/// The same with as much room as it takes.
template <std::size_t words>
void colour_in_room(std::span<LocalPair const> pairs, std::size_t particles,
                    std::vector<std::uint32_t>& matching) {
  // Twice as many matchings as a particle can have pairs are always enough.
  constexpr std::size_t most = 2 * std::numeric_limits<std::uint16_t>::max() / word_bits;
  if (colour<words>(pairs, particles, matching))
    return;
  if constexpr (words <= most)
    colour_in_room<4 * words>(pairs, particles, matching);
  else
    throw std::logic_error("pairs of a particle with itself, or twice as many as there can be");
}

} // namespace

void order_in_matchings(std::span<LocalPair const> pairs, std::size_t particles,
                        std::vector<LocalPair>& ordered, std::vector<std::uint32_t>& ends) {
  thread_local std::vector<std::uint32_t> matching;
  colour_in_room<4>(pairs, particles, matching);
  ends.clear();
  for (auto const m : matching) {
    if (m >= ends.size())
      ends.resize(m + 1, 0);
    ++ends[m];
  }
  std::uint32_t begin = 0;
  for (auto& end : ends) { // from counts to beginnings, which the loop below moves to the ends
    std::uint32_t const count = end;
    end = begin;
    begin += count;
  }
  ordered.reserve(pairs.size()); // no more than that: vectors that grow take up to twice as much
  ordered.resize(pairs.size());
  for (std::size_t k = 0; k < pairs.size(); ++k)
    ordered[ends[matching[k]]++] = pairs[k];
}

} // namespace mesobridge::sdpd
