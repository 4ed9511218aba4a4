#include "workflows/nearest.hpp"
#include "md/error.hpp"
#include <algorithm>
#include <fmt/ranges.h>
#include <vector>

namespace mesobridge::workflows {

namespace {

/// Edit distance with swaps (optimal string alignment), row by row.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j)
    last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] != b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], before[j - 2] + 1);
    }
    std::swap(before, last);
    std::swap(last, row);
  }
  return last[b.size()];
}

} // namespace

std::string nearest(std::string_view word, std::span<std::string const> candidates) {
  std::string best;
  // One error in three letters (begun) is a misspelling; more is another word.
  std::size_t best_distance = std::max<std::size_t>(1, (word.size() + 2) / 3) + 1;
  for (auto const& candidate : candidates) {
    auto const distance = edit_distance(word, candidate);
    if (distance < best_distance) {
      best_distance = distance;
      best = candidate;
    }
  }
  return best;
}

std::string did_you_mean(std::string_view word, std::span<std::string const> candidates) {
  auto const found = nearest(word, candidates);
  return found.empty() ? "" : "; did you mean '" + found + "'?";
}

void refuse_unknown(std::string_view what, std::string_view word, std::span<std::string const> known) {
  throw InputError(fmt::format("unknown {} '{}'{}; known: {}", what, word, did_you_mean(word, known),
                               fmt::join(known, ", ")));
}

} // namespace mesobridge::workflows
