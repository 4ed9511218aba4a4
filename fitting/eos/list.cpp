#include "fitting/eos/list.hpp"
#include <algorithm>

namespace mesobridge::fitting {

namespace {

std::vector<Material> built_in() {
  std::vector<Material> list{
      {"argon", "Lennard-Jones argon, BWR of Johnson et al. 1993 continued below 100 K, m0 = 6.64e-26 kg, SI",
       LjBwr(lj_bwr_1993, argon_units)},
      {"lj", "Lennard-Jones fluid, BWR of Johnson et al. 1993 continued below T* = 0.8332, reduced units",
       LjBwr(lj_bwr_1993)},
      {"ideal-gas", "monatomic ideal gas, m0 = 1e-25 kg (the thesis's test gas), SI", IdealGas(1e-25)}};
  for_each_described_model([&]<class Model>() {
    for (auto const& material : Model::description().materials)
      list.push_back({std::string(material.name), std::string(material.description),
                      Model(material.parameters), material.usable});
  });
  list.push_back({"lj-kn", "Lennard-Jones fluid, Kolafa and Nezbeda 1994, 0.68 <= T* <= 20, reduced units",
                  LjKolafaNezbeda()});
  list.push_back(
      {"lj-thol", "Lennard-Jones fluid, Thol et al. 2016, 0.661 <= T* <= 9, reduced units", LjThol()});
  return list;
}

} // namespace

std::vector<Material> const& materials() {
  static auto const list = built_in();
  return list;
}

Material const& material(std::string_view name) {
  auto const found = std::ranges::find(materials(), name, &Material::name);
  if (found != materials().end())
    return *found;
  throw InputError(fmt::format("no material is named '{}'; built in: {}", name, material_names()));
}

std::string material_names() {
  std::string names;
  for (auto const& known : materials())
    names += (names.empty() ? "" : ", ") + known.name;
  return names;
}

} // namespace mesobridge::fitting
