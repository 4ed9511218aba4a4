#include "sdpd/matchings.hpp"
#include <bit>

namespace mesobridge::sdpd {
namespace {

constexpr unsigned word_bits = 64;

/// The matchings that each particle is in already, as bits.
class Occupation {
 public:
  void reset(std::size_t particles, std::size_t words) {
    words_ = words;
    bits_.assign(particles * words, 0);
  }
  /// The first matching in which both are free, now taken by them; words * word_bits when there is none.
  std::size_t take(LocalPair const& pair) {
    std::uint64_t *const a = &bits_[pair.i * words_], *const b = &bits_[pair.j * words_];
    for (std::size_t w = 0; w < words_; ++w)
      if (std::uint64_t const free = ~(a[w] | b[w])) {
        std::uint64_t const bit = free & -free;
        a[w] |= bit, b[w] |= bit;
        return w * word_bits + static_cast<std::size_t>(std::countr_zero(free));
      }
    return words_ * word_bits;
  }

 private:
  std::size_t words_ = 0;
  std::vector<std::uint64_t> bits_;
};

/// The matching of each pair. False when `words` words are too few.
bool colour(std::span<LocalPair const> pairs, std::size_t particles, std::size_t words,
            std::vector<std::uint32_t>& matching) {
  thread_local Occupation occupation;
  occupation.reset(particles, words);
  matching.resize(pairs.size());
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    std::size_t const m = occupation.take(pairs[k]);
    if (m == words * word_bits)
      return false;
    matching[k] = static_cast<std::uint32_t>(m);
  }
  return true;
}

} // namespace

void order_in_matchings(std::span<LocalPair const> pairs, std::size_t particles,
                        std::vector<LocalPair>& ordered, std::vector<std::uint32_t>& ends) {
  thread_local std::vector<std::uint32_t> matching;
  for (std::size_t words = 3; !colour(pairs, particles, words, matching);)
    words *= 2;
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
