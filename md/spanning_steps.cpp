#include "md/spanning_steps.hpp"
#include <queue>

namespace mesobridge::md {

std::vector<std::pair<int, int>> spanning_steps(int atoms, std::vector<std::pair<int, int>> const& bonds) {
  auto const n = std::size_t(atoms);
  std::vector<std::vector<int>> neighbours(n, std::vector<int>{});
  for (auto const& [a, b] : bonds) {
    neighbours[std::size_t(a)].push_back(b);
    neighbours[std::size_t(b)].push_back(a);
  }
  std::vector<std::pair<int, int>> steps;
  std::vector<bool> reached(n, false);
  for (int start = 0; start < atoms; ++start) {
    if (reached[std::size_t(start)])
      continue;
    if (start > 0)
      steps.emplace_back(0, start);
    std::queue<int> open({start});
    reached[std::size_t(start)] = true;
    for (; !open.empty(); open.pop())
      for (int const next : neighbours[std::size_t(open.front())])
        if (!reached[std::size_t(next)]) {
          reached[std::size_t(next)] = true;
          steps.emplace_back(open.front(), next);
          open.push(next);
        }
  }
  return steps;
}

} // namespace mesobridge::md
