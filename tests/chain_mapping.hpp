#pragma once
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <string>
#include <vector>

namespace mesobridge::tests {

/// The mapping of a chain of beads of mass 1 with harmonic bonds, which repel each other (WCA), bonded or
/// not.
inline std::string chain_mapping(std::string const& name, int atoms, double k, double l) {
  std::vector<int> first, second;
  for (int bond = 1; bond < atoms; ++bond)
    first.push_back(bond), second.push_back(bond + 1);
  auto const as_many = [](auto const& like, double value) { return std::vector<double>(like.size(), value); };
  return fmt::format(R"(format = "mesobridge mapping 1"
name = "{}"
atoms = {}
masses = {::.1f}

[bonds]
count = {}
a = {}
b = {}
k = {::.1f}
l = {::.1f}

[pairs]
count = 1
type_a = [1]
type_b = [1]
epsilon = [1.0]
sigma = [1.0]
cutoff = [1.122462048309373]
shifted = "yes"
bonded = "yes"
)",
                     name, atoms, std::vector<double>(std::size_t(atoms), 1.0), atoms - 1, first, second,
                     as_many(first, k), as_many(first, l));
}

} // namespace mesobridge::tests
