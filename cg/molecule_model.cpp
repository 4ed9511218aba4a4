#include "cg/molecule_model.hpp"
#include "md/spanning_steps.hpp"
#include <algorithm>
#include <numeric>

namespace mesobridge::cg {

double MoleculeModel::mass() const {
  return std::accumulate(masses.begin(), masses.end(), 0.0);
}

double MoleculeModel::longest_cutoff() const {
  double longest = 0;
  for (auto const& law : pairs)
    longest = std::max(longest, law.cutoff());
  return longest;
}

MoleculeModel model_of(md::StarPolymer const& star) {
  auto const n = std::size_t(star.atoms());
  PairLaw const repulsion(1, 1, star.repulsion ? md::wca_cutoff() : 0, true);
  std::vector<Bond> bonds;
  for (auto const& bond : star.bonds())
    bonds.push_back({bond.a, bond.b, BondLaw::harmonic(bond.k, bond.l)});
  return {.masses = std::vector<double>(n, 1.0),
          .types = std::vector<int>(n, 0),
          .pairs = {repulsion},
          .type_count = 1,
          .bonds = std::move(bonds),
          .excluded = {}};
}

MoleculeModel model_of(md::MoleculeKind const& kind, double energy_of_mv2) {
  MoleculeModel model{.masses = kind.masses(),
                      .types = std::vector<int>(kind.types.size(), 0),
                      .pairs = {PairLaw(0, 1, 0, false)},
                      .type_count = 1,
                      .bonds = {},
                      .excluded = {}};
  for (double& mass : model.masses)
    mass *= energy_of_mv2;
  for (auto const& term : kind.bonded[std::size_t(md::Bonded::bond)])
    model.bonds.push_back({.a = int(term.atoms[0]), .b = int(term.atoms[1])});
  return model;
}

std::vector<std::pair<int, int>> spanning_steps(MoleculeModel const& model) {
  std::vector<std::pair<int, int>> bonds;
  for (auto const& bond : model.bonds)
    bonds.emplace_back(bond.a, bond.b);
  return md::spanning_steps(model.atoms(), bonds);
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
