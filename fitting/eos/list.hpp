#pragma once
#include "fitting/eos/davis.hpp"
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
#include <type_traits>
#include <variant>
#include <vector>

namespace mesobridge::fitting {

/// Every equation of state; files, fits, commands and the generic tests run over this list. Choose once by
/// std::visit, outside the loop.
using AnyEos =
    std::variant<IdealGas, LjBwr, MieGruneisen, Hz, Jwl, Davis, StiffenedGas, LjKolafaNezbeda, LjThol>;

/// Calls f.operator()<Model>() for every model of the list that describes itself, in the list's order.
template <class F>
void for_each_described_model(F&& f) {
  [&]<class... Models>(std::type_identity<std::variant<Models...>>) {
    auto const call = [&]<class Model>(std::type_identity<Model>) {
      if constexpr (DescribedModel<Model>)
        f.template operator()<Model>();
    };
    (call(std::type_identity<Models>{}), ...);
  }(std::type_identity<AnyEos>{});
}

/// A material that needs no file.
struct Material {
  std::string name;
  std::string description; ///< one line, with units and source
  AnyEos eos;
  std::optional<UsableRange> usable = std::nullopt; ///< nothing: as the description says
};

/// `lj...` in Lennard-Jones units, the others in SI. Models that describe themselves bring their own.
std::vector<Material> const& materials();

/// Their names, separated by commas.
std::string material_names();

/// Throws InputError that lists the names when there is no such material.
Material const& material(std::string_view name);

} // namespace mesobridge::fitting
