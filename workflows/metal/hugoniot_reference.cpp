#include "workflows/metal/hugoniot_reference.hpp"
#include "md/error.hpp"
#include "workflows/csv_table.hpp"
#include "workflows/report/number_text.hpp"
#include "workflows/summary.hpp"
#include "workflows/text_file.hpp"
#include <algorithm>
#include <map>

namespace mesobridge::workflows {
namespace {

using Row = std::map<std::string, double>;

std::vector<Row> rows_of(std::filesystem::path const& file) {
  auto const table = parse_csv(read_text_file(file), file.string());
  std::vector<Row> rows;
  for (auto const& line : table.rows) {
    Row row;
    for (std::size_t c = 0; c < table.header.cells.size(); ++c)
      row[table.header.cells[c]] = csv_number(table, line, c);
    rows.push_back(std::move(row));
  }
  for (auto const* column : {"rho0_kg_m3", "T0_K", "v_P_m_s", "v_P_se_m_s", "v_S_m_s", "v_S_se_m_s",
                             "rho_kg_m3", "P_Pa", "P_se_Pa", "T_K", "T_se_K"})
    require(
        rows.front().contains(column), "--hugoniot", file.string(),
        fmt::format("must be a table that `md hugoniot` wrote (hugoniot.csv): it has no column {}", column));
  std::ranges::sort(rows, {}, [](Row const& row) { return row.at("v_P_m_s"); });
  return rows;
}

/// One of the four that a shock is told by.
struct Quantity {
  std::string name, unit, key;
  double factor; ///< from SI
  cg::Estimate piston, reference;

  double deviation() const { return (piston.mean - reference.mean) / std::hypot(piston.se, reference.se); }
};

std::vector<Quantity> quantities(HugoniotReference const& reference, ShockOfRun const& shock) {
  auto const& m = shock.measured;
  return {{"v_S", "m/s", "v_S_m_s", 1, m.v_S, reference.v_S},
          {"rho", "kg/m^3", "rho_kg_m3", 1, shock.mass_per_volume, reference.rho},
          {"P", "GPa", "P_Pa", 1e-9, m.P, reference.P},
          {"T", "K", "T_K", 1, m.T, reference.T}};
}

/// That the curve begins in the state ahead of the piston.
void require_same(std::filesystem::path const& file, std::string const& quantity, std::string const& unit,
                  std::string const& option, double ahead, double initial) {
  constexpr double same = 0.005;
  require(std::abs(initial / ahead - 1) <= same, "--hugoniot", file.string(),
          fmt::format("must begin at the {} of the piston's run, {:g} {}, and begins at {:g}: give both the "
                      "same {}",
                      quantity, ahead, unit, initial, option));
}

std::string text(cg::Estimate const& value, double factor) {
  return with_error_text({value.mean * factor, value.se * factor, value.n_eff});
}

} // namespace

HugoniotReference read_hugoniot_reference(std::filesystem::path const& file, md::MetalState const& ahead,
                                          double v_P) {
  auto const rows = rows_of(file);
  auto const upper = std::ranges::find_if(rows, [&](Row const& row) { return row.at("v_P_m_s") >= v_P; });
  require(rows.size() > 1 && upper != rows.begin() && upper != rows.end(), "--hugoniot", file.string(),
          fmt::format("must have points on both sides of --vp = {:g} m/s; it has {:g} ... {:g}", v_P,
                      rows.front().at("v_P_m_s"), rows.back().at("v_P_m_s")));
  auto const& lower = *(upper - 1);
  for (auto const* row : {&lower, &*upper}) {
    require_same(file, "density", "kg/m^3", "--rho0", ahead.rho, row->at("rho0_kg_m3"));
    require_same(file, "temperature", "K", "--T0", ahead.T, row->at("T0_K"));
  }
  double const part = (v_P - lower.at("v_P_m_s")) / (upper->at("v_P_m_s") - lower.at("v_P_m_s"));
  auto const between = [&](std::string const& mean, std::string const& se) {
    return cg::Estimate{(1 - part) * lower.at(mean) + part * upper->at(mean),
                        std::hypot((1 - part) * lower.at(se), part * upper->at(se)), 1};
  };
  auto rho = between("rho_kg_m3", "v_P_se_m_s"); // points are at set densities: the error is that of v_P
  rho.se *= std::abs((upper->at("rho_kg_m3") - lower.at("rho_kg_m3")) /
                     (upper->at("v_P_m_s") - lower.at("v_P_m_s")));
  return {.v_S = between("v_S_m_s", "v_S_se_m_s"),
          .rho = rho,
          .P = between("P_Pa", "P_se_Pa"),
          .T = between("T_K", "T_se_K")};
}

Json reference_json(HugoniotReference const& reference, ShockOfRun const& shock) {
  Json json;
  for (auto const& q : quantities(reference, shock)) {
    put(json, q.key, q.reference);
    json["deviation"][q.name] = q.deviation();
  }
  return json;
}

Section reference_section(HugoniotReference const& reference, ShockOfRun const& shock) {
  Table table{.header = {"behind the front", "piston", "equilibrium", "difference [se]"},
              .caption = "Equilibrium: states of even compression that fulfil the relations of Rankine and "
                         "Hugoniot (md hugoniot), linear between two of them. A crystal that a piston shocks "
                         "along one axis keeps some shear stress."};
  for (auto const& q : quantities(reference, shock))
    table.rows.push_back({fmt::format("{} [{}]", q.name, q.unit), text(q.piston, q.factor),
                          text(q.reference, q.factor), fmt::format("{:+.1f}", q.deviation())});
  return {"Beside states of equilibrium", {std::move(table)}};
}

std::string reference_text(HugoniotReference const& reference, ShockOfRun const& shock) {
  std::string lines;
  for (auto const& q : quantities(reference, shock))
    lines += fmt::format("equilibrium {:4} {} {} ({:+.1f} se)\n", q.name, text(q.reference, q.factor), q.unit,
                         q.deviation());
  return lines;
}

} // namespace mesobridge::workflows
