#include "fitting/model_file.hpp"
#include "fitting/eos/lj_bwr_stability.hpp"
#include "fitting/toml_reader.hpp"
#include "fitting/toml_text.hpp"
#include <algorithm>
#include <array>

namespace mesobridge::fitting {
namespace {

constexpr std::string_view format_name = "mesobridge equation of state 1";

std::string body(IdealGas const& gas) {
  return fmt::format("kind = \"ideal-gas\"\n\n[ideal_gas]\nm0 = {}\ndof = {}\nk_B = {}\n",
                     exact(gas.molecular_mass()), exact(gas.dof()), exact(gas.boltzmann()));
}

std::string units_text(std::optional<LjUnits> const& units) {
  if (!units)
    return "";
  return fmt::format("\n[units]\nsigma_m = {}\nepsilon_J = {}\nmass_kg = {}\n", exact(units->sigma),
                     exact(units->epsilon), exact(units->mass));
}

std::string body(LjKolafaNezbeda const& lj) {
  return "kind = \"lj-kn\"\n" + units_text(lj.units());
}

std::string body(LjThol const& lj) {
  return "kind = \"lj-thol\"\n" + units_text(lj.units());
}

std::string body(LjBwr const& lj) {
  auto const& set = lj.set();
  std::string const text =
      fmt::format("kind = \"lj-bwr\"\n\n# Lennard-Jones units\n[lj_bwr]\ngamma = {}\nT_low = {}\n"
                  "T_max = {}\nrho_max = {}\nx = {}\n",
                  exact(set.gamma), exact(set.T_low), exact(set.T_max), exact(set.rho_max), array(set.x));
  return text + units_text(lj.units());
}

template <DescribedModel Model>
std::string body(Model const& model) {
  auto const& description = Model::description();
  std::string text = fmt::format("kind = \"{}\"\n\n[{}]\n", description.kind, description.table());
  for (auto const& parameter : description.parameters)
    text += fmt::format("{} = {}\n", parameter.key(), exact(model.parameters().*parameter.member));
  return text;
}

std::string covariance_text(Eigen::MatrixXd const& L, std::vector<std::string> const& fitted) {
  std::vector<double> rows;
  for (Eigen::Index i = 0; i < L.rows(); ++i)
    for (Eigen::Index j = 0; j <= i; ++j)
      rows.push_back(L(i, j));
  std::string names;
  for (auto const& key : fitted)
    names += (names.empty() ? "" : ", ") + quoted(key);
  return fmt::format(
      "\n# The covariance of {} is L L^T; rows of the lower triangle of L\n[covariance]\n{}L = {}\n",
      fitted.empty() ? "x" : "these parameters",
      fitted.empty() ? "" : fmt::format("parameters = [{}]\n", names), array(rows));
}

/// Keys of the valid range, with SI units for models that are not reduced.
std::array<std::string_view, 6> valid_keys(bool reduced) {
  if (reduced)
    return {"rho_min", "rho_max", "T_min", "T_max", "e_min", "e_max"};
  return {"rho_min_kg_m3", "rho_max_kg_m3", "T_min_K", "T_max_K", "e_min_J_kg", "e_max_J_kg"};
}

bool has_reduced_range(AnyEos const& eos) {
  return std::holds_alternative<LjBwr>(eos);
}

std::string valid_text(ValidRange const& v, bool reduced) {
  auto const keys = valid_keys(reduced);
  std::array const values{v.rho_min, v.rho_max, v.T_min, v.T_max, v.e_min, v.e_max};
  std::string text = fmt::format("\n# Where the data lie, {}\n[valid]\n",
                                 reduced ? "Lennard-Jones units per atom" : "per unit mass");
  for (std::size_t i = 0; i < keys.size(); ++i)
    text += fmt::format("{} = {}\n", keys[i], exact(values[i]));
  return text;
}

IdealGas read_ideal_gas(TomlReader& file) {
  auto table = file.table("ideal_gas");
  double const m0 = table.number("m0"), dof = table.number("dof"), boltzmann = table.number("k_B");
  table.refuse_unknown();
  return IdealGas(m0, dof, boltzmann);
}

std::optional<LjUnits> read_units(TomlReader& file) {
  if (!file.has("units"))
    return std::nullopt;
  auto table = file.table("units");
  LjUnits const units{.sigma = table.number("sigma_m"),
                      .epsilon = table.number("epsilon_J"),
                      .mass = table.number("mass_kg")};
  table.refuse_unknown();
  return units;
}

LjBwr read_lj_bwr(TomlReader& file) {
  auto table = file.table("lj_bwr");
  LjBwrSet set{.x = {},
               .gamma = table.number("gamma"),
               .T_low = table.number("T_low"),
               .T_max = table.number("T_max"),
               .rho_max = table.number("rho_max")};
  std::ranges::copy(table.numbers("x", bwr::parameters), set.x.begin());
  table.refuse_unknown();
  LjBwr const eos(set, read_units(file));
  auto const found = stability(set, {0.01 * set.rho_max, set.rho_max, set.T_low, set.T_max});
  if (!(found.c_v_min > 0))
    throw InputError(
        fmt::format("lj_bwr: the heat capacity is {:.4g} k_B at rho* = {:.4g}, T* = {:.4g}; it must be "
                    "positive up to rho_max between T_low and T_max",
                    found.c_v_min, found.rho_at_c_v_min, found.T_at_c_v_min));
  return eos;
}

template <DescribedModel Model>
Model read_described(TomlReader& file) {
  auto const& description = Model::description();
  auto table = file.table(description.table());
  typename Model::Parameters parameters{};
  for (auto const& parameter : description.parameters) {
    auto const key = parameter.key();
    parameters.*parameter.member =
        parameter.if_missing && !table.has(key) ? *parameter.if_missing : table.number(key);
  }
  table.refuse_unknown();
  return Model(parameters);
}

Eigen::MatrixXd read_triangle(TomlReader& table, std::size_t size) {
  auto const rows = table.numbers("L", size * (size + 1) / 2);
  auto const n = static_cast<Eigen::Index>(size);
  Eigen::MatrixXd L = Eigen::MatrixXd::Zero(n, n);
  auto next = rows.begin();
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j <= i; ++j)
      L(i, j) = *next++;
  return L;
}

/// Keys of the parameters of a model that describes itself; none for the others.
std::vector<std::string> parameter_keys(AnyEos const& any) {
  return std::visit(
      []<class Model>(Model const&) {
        std::vector<std::string> keys;
        if constexpr (DescribedModel<Model>)
          for (auto const& parameter : Model::description().parameters)
            keys.push_back(parameter.key());
        return keys;
      },
      any);
}

void read_covariance(TomlReader table, EosModel& model) {
  std::size_t size = bwr::parameters;
  if (!has_reduced_range(model.eos)) {
    model.fitted = table.names("parameters", parameter_keys(model.eos));
    size = model.fitted.size();
  }
  model.covariance_factor = read_triangle(table, size);
  table.refuse_unknown();
}

ValidRange read_valid(TomlReader table, bool reduced) {
  auto const keys = valid_keys(reduced);
  std::array<double, 6> x;
  std::ranges::transform(keys, x.begin(), [&](std::string_view key) { return table.number(key); });
  table.refuse_unknown();
  ValidRange const v{x[0], x[1], x[2], x[3], x[4], x[5]};
  require(v.rho_min <= v.rho_max && v.T_min <= v.T_max && v.e_min <= v.e_max, "valid", "a lower bound",
          "must not exceed the upper one");
  return v;
}

AnyEos read_eos(TomlReader& file, toml::table const& table) {
  auto const kind = file.text("kind");
  if (kind == "ideal-gas")
    return read_ideal_gas(file);
  if (kind == "lj-bwr")
    return read_lj_bwr(file);
  if (kind == "lj-kn")
    return LjKolafaNezbeda(read_units(file));
  if (kind == "lj-thol")
    return LjThol(read_units(file));
  std::string kinds = "\"ideal-gas\", \"lj-bwr\", \"lj-kn\", \"lj-thol\"";
  std::optional<AnyEos> described;
  for_each_described_model([&]<class Model>() {
    if (kind == Model::description().kind)
      described = read_described<Model>(file);
    kinds += fmt::format(", \"{}\"", Model::description().kind);
  });
  if (described)
    return *described;
  file.refuse(*table.get("kind"), "kind", fmt::format("must be one of {}", kinds));
}

EosModel read_model(toml::table const& table, std::string const& file_name) {
  TomlReader file(table, file_name);
  if (file.text("format") != format_name)
    file.refuse(*table.get("format"), "format", fmt::format("must be \"{}\"", format_name));
  EosModel model{read_eos(file, table), {}, {}, {}, {}, {}};
  bool const reduced = has_reduced_range(model.eos);
  if (reduced || !parameter_keys(model.eos).empty()) {
    if (file.has("covariance"))
      read_covariance(file.table("covariance"), model);
    if (file.has("valid"))
      model.valid = read_valid(file.table("valid"), reduced);
  }
  read_origin(file, model);
  file.refuse_unknown();
  return model;
}

} // namespace

EosModel model_of(LjBwrFit const& fit, std::optional<LjUnits> units, std::string data_hash,
                  std::map<std::string, std::string> provenance) {
  auto const& box = fit.sampled;
  return {.eos = fit.eos.in_units(units),
          .covariance_factor = fit.covariance_factor,
          .valid = ValidRange{box.rho_min, box.rho_max, box.T_min, box.T_max, fit.e_min, fit.e_max},
          .data_hash = std::move(data_hash),
          .provenance = std::move(provenance),
          .fitted = {}};
}

std::string to_toml(EosModel const& model) {
  std::string text = fmt::format("format = \"{}\"\n", format_name);
  text += data_hash_text(model.data_hash);
  text += std::visit([](auto const& eos) { return body(eos); }, model.eos);
  if (model.valid)
    text += valid_text(*model.valid, has_reduced_range(model.eos));
  if (model.covariance_factor)
    text += covariance_text(*model.covariance_factor, model.fitted);
  return text + provenance_text(model.provenance);
}

EosModel parse_model(std::string_view text, std::string const& file_name) {
  return read_toml(text, file_name, read_model);
}

namespace {

/// The usable range of a material as that of a fit: energies are extreme at its corners.
std::optional<ValidRange> valid_range(Material const& material) {
  if (!material.usable)
    return std::nullopt;
  auto const& [rho_min, rho_max, T_min, T_max] = *material.usable;
  std::vector<double> e;
  std::visit(
      [&](auto const& eos) {
        for (double const rho : {rho_min, rho_max})
          for (double const T : {T_min, T_max})
            e.push_back(eos.energy_from_temperature(T, rho));
      },
      material.eos);
  auto const [e_min, e_max] = std::ranges::minmax(e);
  return ValidRange{rho_min, rho_max, T_min, T_max, e_min, e_max};
}

} // namespace

EosModel load_eos(std::string const& name_or_file,
                  std::function<std::string(std::string const&)> const& read_text) {
  if (std::ranges::find(materials(), name_or_file, &Material::name) != materials().end())
    return {material(name_or_file).eos, {}, valid_range(material(name_or_file)), {}, {}, {}};
  if (!name_or_file.ends_with(".toml"))
    throw InputError(fmt::format("model '{}': must be a model file (*.toml) or a built-in material: {}",
                                 name_or_file, material_names()));
  return parse_model(read_text(name_or_file), name_or_file);
}

} // namespace mesobridge::fitting
