#include "fitting/model_file.hpp"
#include "workflows/pages/schema.hpp"

namespace mesobridge::workflows {
namespace {

Json closed_table(Json properties, Json required) {
  return {{"type", "object"},
          {"properties", std::move(properties)},
          {"required", std::move(required)},
          {"additionalProperties", false}};
}

Json number_schema(NumberRange const& range, std::string const& text) {
  Json schema{{"type", "number"}, {"description", text}};
  put_bounds(schema, range);
  return schema;
}

Json numbers(std::vector<std::pair<std::string, std::string>> const& keys) {
  Json properties = Json::object(), required = Json::array();
  for (auto const& [key, text] : keys)
    properties[key] = number_schema(any_number, text), required.push_back(key);
  return closed_table(properties, required);
}

/// A model of one kind: its tables, and what every file may say.
Json variant(std::string const& kind, Json tables, Json const& required) {
  tables["kind"] = {{"const", kind}};
  for (char const* common : {"format", "data_hash", "covariance", "valid", "provenance"})
    tables[common] = true;
  Json names{"format", "kind"};
  names.insert(names.end(), required.begin(), required.end());
  return closed_table(std::move(tables), std::move(names));
}

template <class Model>
Json described() {
  auto const& description = Model::description();
  Json properties = Json::object(), required = Json::array();
  for (auto const& parameter : description.parameters) {
    auto const key = parameter.key();
    properties[key] = number_schema(parameter.allowed, std::string(parameter.meaning));
    if (!parameter.if_missing)
      required.push_back(key);
  }
  auto const table = description.table();
  return variant(std::string(description.kind), {{table, closed_table(properties, required)}}, {table});
}

/// A model of a DPDE particle (fitting/particle_model_file.hpp), whose internal energy stands in that table;
/// the tables' columns are checked where they are read.
Json particle(std::string const& kind, std::string const& internal_energy) {
  Json tables{{internal_energy, true}};
  for (char const* other : {"temperature_unit", "state", "particle", "potential", "friction", "conduction"})
    tables[other] = true;
  return variant(kind, std::move(tables), {internal_energy});
}

} // namespace

Json model_schema() {
  Json const units = numbers({{"sigma_m", "sigma of Lennard-Jones [m]"},
                              {"epsilon_J", "epsilon of Lennard-Jones [J]"},
                              {"mass_kg", "mass of one atom [kg]"}});
  Json bwr = numbers({{"gamma", "of the exponential terms"},
                      {"T_low", "least temperature [epsilon/k_B]"},
                      {"T_max", "greatest temperature"},
                      {"rho_max", "greatest density [1/sigma^3]"}});
  bwr["properties"]["x"] = {
      {"type", "array"}, {"items", {{"type", "number"}}}, {"minItems", 32}, {"maxItems", 32}};
  bwr["required"].push_back("x");
  Json kinds{variant("ideal-gas",
                     {{"ideal_gas", numbers({{"m0", "mass of one molecule [kg]"},
                                             {"dof", "degrees of freedom of one molecule"},
                                             {"k_B", "Boltzmann's constant [J/K]"}})}},
                     {"ideal_gas"}),
             variant("lj-bwr", {{"lj_bwr", bwr}, {"units", units}}, {"lj_bwr"}),
             variant("lj-kn", {{"units", units}}, Json::array()),
             variant("lj-thol", {{"units", units}}, Json::array())};
  fitting::for_each_described_model([&]<class Model>() { kinds.push_back(described<Model>()); });
  for (auto const& [kind, internal_energy] :
       {std::pair{"constant", "constant"}, {"heat-capacity", "heat_capacity"}, {"entropy", "entropy"}})
    kinds.push_back(particle(kind, internal_energy));
  return {{"$schema", "http://json-schema.org/draft-07/schema#"},
          {"title", "A model of mesobridge: an equation of state, or a DPDE particle"},
          {"type", "object"},
          {"oneOf", kinds}};
}

} // namespace mesobridge::workflows
