#include "fitting/eos/list.hpp"
#include <algorithm>

namespace mesobridge::fitting {

std::vector<Material> const& materials() {
  static std::vector<Material> const list{
      {"argon", "Lennard-Jones argon, BWR of Johnson et al. 1993 continued below 100 K, m0 = 6.64e-26 kg, SI",
       LjBwr(lj_bwr_1993, argon_units)},
      {"lj", "Lennard-Jones fluid, BWR of Johnson et al. 1993 continued below T* = 0.8332, reduced units",
       LjBwr(lj_bwr_1993)},
      {"ideal-gas", "monatomic ideal gas, m0 = 1e-25 kg (the thesis's test gas), SI", IdealGas(1e-25)},
      {"tin", "molten tin under shock, Mie-Gruneisen (thesis, Table 6.1), SI", MieGruneisen(tin_parameters)},
      {"nitromethane", "unreacted nitromethane, HZ (thesis, Table 6.2), SI", Hz(nitromethane_parameters)},
      {"nitromethane-products", "its detonation products, JWL (thesis, Table 6.3), SI",
       Jwl(nitromethane_products_parameters)},
      {"water",
       "liquid water, 940 to 1170 kg/m^3 and 280 to 350 K (there its density is within 3 %), stiffened gas "
       "of "
       "Noble and Abel (Le Metayer and Saurel 2016), 0.1 MPa and 1500 m/s at 997 kg/m^3 and 300 K, SI",
       StiffenedGas(water_parameters), UsableRange{940, 1170, 280, 350}},
      {"lj-kn", "Lennard-Jones fluid, Kolafa and Nezbeda 1994, 0.68 <= T* <= 20, reduced units",
       LjKolafaNezbeda()},
      {"lj-thol", "Lennard-Jones fluid, Thol et al. 2016, 0.661 <= T* <= 9, reduced units", LjThol()},
  };
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
