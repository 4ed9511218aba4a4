#include "cg/molecule_model.hpp"
#include <algorithm>
#include <numeric>
#include <queue>

namespace mesobridge::cg {

double MoleculeModel::mass() const {
  return std::accumulate(masses.begin(), masses.end(), 0.0);
}

MoleculeModel model_of(md::StarPolymer const& star) {
  auto const n = std::size_t(star.atoms());
  PairLaw const repulsion(1, 1, star.repulsion ? md::wca_cutoff() : 0, true);
  return {.masses = std::vector<double>(n, 1.0),
          .types = std::vector<int>(n, 0),
          .pairs = {repulsion},
          .type_count = 1,
          .bonds = star.bonds(),
          .excluded = {}};
}

std::vector<std::pair<int, int>> spanning_steps(MoleculeModel const& model) {
  auto const n = std::size_t(model.atoms());
  std::vector<std::vector<int>> neighbours(n, std::vector<int>{});
  for (auto const& bond : model.bonds) {
    neighbours[std::size_t(bond.a)].push_back(bond.b);
    neighbours[std::size_t(bond.b)].push_back(bond.a);
  }
  std::vector<std::pair<int, int>> steps;
  std::vector<bool> reached(n, false);
  for (int start = 0; start < int(n); ++start) {
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

bool joined_by_bonds(MoleculeModel const& model) {
  auto const steps = spanning_steps(model);
  return std::ranges::all_of(steps, [&](auto const& step) {
    return std::ranges::any_of(model.bonds, [&](auto const& bond) {
      return std::minmax(bond.a, bond.b) == std::minmax(step.first, step.second);
    });
  });
}

} // namespace mesobridge::cg
