#include "fitting/eos/list.hpp"
#include "md/error.hpp"
#include "workflows/command.hpp"

namespace mesobridge::workflows {

namespace {

/// JSON has no number for a bound at infinity.
Json bound(double x) {
  return std::isfinite(x) ? Json(x) : Json(nullptr);
}

Result list(Context&) {
  Result result;
  result.json["models"] = Json::array();
  for (auto const& material : fitting::materials()) {
    auto const domain = std::visit([](auto const& eos) { return eos.domain(); }, material.eos);
    bool const reduced = std::visit([](auto const& eos) { return eos.boltzmann() == 1; }, material.eos);
    std::string const density = reduced ? "" : "_kg_m3", kelvin = reduced ? "" : "_K";
    result.json["models"].push_back({{"name", material.name},
                                     {"description", material.description},
                                     {"rho_max" + density, bound(domain.rho_max)},
                                     {"T_min" + kelvin, bound(domain.T_min)},
                                     {"T_max" + kelvin, bound(domain.T_max)},
                                     {"edge", domain.edge}});
    if (auto const& usable = material.usable)
      result.json["models"].back().update(Json{{"usable_rho_min" + density, usable->rho_min},
                                               {"usable_rho_max" + density, usable->rho_max},
                                               {"usable_T_min" + kelvin, usable->T_min},
                                               {"usable_T_max" + kelvin, usable->T_max}});
    result.text +=
        fmt::format("{:<22} {}\n{:<22} edge: {}\n", material.name, material.description, "", domain.edge);
  }
  return result;
}

} // namespace

Command::Action eos_list_command(CLI::App&) {
  return list;
}

} // namespace mesobridge::workflows
