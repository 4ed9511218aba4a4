#pragma once
#include "fitting/eos/hz.hpp"
#include "fitting/eos/ideal_gas.hpp"
#include "fitting/eos/jwl.hpp"
#include "fitting/eos/kolafa_nezbeda.hpp"
#include "fitting/eos/lj_bwr.hpp"
#include "fitting/eos/mie_gruneisen.hpp"
#include "fitting/eos/stiffened_gas.hpp"
#include "fitting/eos/thol.hpp"
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace mesobridge::fitting {

/// Every equation of state; the generic tests run over this list. Choose once by std::visit, outside the
/// loop.
using AnyEos = std::variant<IdealGas, LjBwr, MieGruneisen, Hz, Jwl, StiffenedGas, LjKolafaNezbeda, LjThol>;

/// Where a material's model is near the real one, in the model's units.
struct UsableRange {
  double rho_min, rho_max, T_min, T_max;
};

/// A material that needs no file.
struct Material {
  std::string name;
  std::string description; ///< one line, with units and source
  AnyEos eos;
  std::optional<UsableRange> usable = std::nullopt; ///< nothing: as the description says
};

/// `lj...` in Lennard-Jones units, the others in SI.
std::vector<Material> const& materials();

/// Their names, separated by commas.
std::string material_names();

/// Throws InputError that lists the names when there is no such material.
Material const& material(std::string_view name);

} // namespace mesobridge::fitting
