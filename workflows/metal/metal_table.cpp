#include "workflows/metal/metal_table.hpp"
#include "md/error.hpp"
#include "workflows/report/number_text.hpp"
#include <algorithm>
#include <functional>

namespace mesobridge::workflows {

namespace {

template <class Point>
struct Column {
  std::string name;
  std::function<double(Point const&)> of;
};

using Point = cg::MetalPoint;
using Shocked = cg::HugoniotPoint;

std::vector<Column<Point>> const& grid_columns() {
  static std::vector<Column<Point>> const list{
      {"rho_kg_m3", [](Point const& p) { return p.state.rho; }},
      {"T_K", [](Point const& p) { return p.state.T; }},
      {"P_Pa", [](Point const& p) { return p.P.mean; }},
      {"P_se_Pa", [](Point const& p) { return p.P.se; }},
      {"e_J_kg", [](Point const& p) { return p.e.mean; }},
      {"e_se_J_kg", [](Point const& p) { return p.e.se; }},
  };
  return list;
}

/// What the CSV leaves out.
std::vector<Column<Point>> const& further_grid_columns() {
  static std::vector<Column<Point>> const list{
      {"P_e_correlation", [](Point const& p) { return p.cov_eP / (p.P.se * p.e.se); }},
      {"T_kin_K", [](Point const& p) { return p.T_kin.mean; }},
      {"T_kin_se_K", [](Point const& p) { return p.T_kin.se; }},
      {"c_v_J_kg_K", [](Point const& p) { return p.c_v.mean; }},
      {"c_v_se_J_kg_K", [](Point const& p) { return p.c_v.se; }},
      {"lattice_order", [](Point const& p) { return p.end.lattice_order; }},
      {"displacement_2", [](Point const& p) { return p.displacement_2; }},
      {"part_beyond_table", [](Point const& p) { return p.end.part_beyond_table; }},
      {"n_eff_P", [](Point const& p) { return p.P.n_eff; }},
      {"n_eff_e", [](Point const& p) { return p.e.n_eff; }},
  };
  return list;
}

std::vector<Column<Shocked>> const& hugoniot_columns() {
  static std::vector<Column<Shocked>> const list{
      {"rho0_kg_m3", [](Shocked const& p) { return p.initial.rho; }},
      {"T0_K", [](Shocked const& p) { return p.initial.T; }},
      {"P0_Pa", [](Shocked const& p) { return p.P0.mean; }},
      {"P0_se_Pa", [](Shocked const& p) { return p.P0.se; }},
      {"v_P_m_s", [](Shocked const& p) { return p.v_P.mean; }},
      {"v_P_se_m_s", [](Shocked const& p) { return p.v_P.se; }},
      {"v_S_m_s", [](Shocked const& p) { return p.v_S.mean; }},
      {"v_S_se_m_s", [](Shocked const& p) { return p.v_S.se; }},
      {"rho_kg_m3", [](Shocked const& p) { return p.rho; }},
      {"P_Pa", [](Shocked const& p) { return p.P.mean; }},
      {"P_se_Pa", [](Shocked const& p) { return p.P.se; }},
      {"T_K", [](Shocked const& p) { return p.T.mean; }},
      {"T_se_K", [](Shocked const& p) { return p.T.se; }},
      {"e_J_kg", [](Shocked const& p) { return p.e.mean; }},
      {"e_se_J_kg", [](Shocked const& p) { return p.e.se; }},
  };
  return list;
}

std::vector<Column<Shocked>> const& further_hugoniot_columns() {
  static std::vector<Column<Shocked>> const list{
      {"v_S_v_P_correlation", [](Shocked const& p) { return p.cov_vSvP / (p.v_S.se * p.v_P.se); }},
      {"chi_2", [](Shocked const& p) { return p.chi_2; }},
  };
  return list;
}

template <class P>
std::string csv(std::vector<Column<P>> const& columns, std::span<P const> points) {
  std::string text;
  for (auto const& column : columns)
    text += (text.empty() ? "" : ",") + column.name;
  text += '\n';
  for (auto const& point : points) {
    std::string line;
    for (auto const& column : columns) // the shortest digits that read back exactly
      line += (line.empty() ? "" : ",") + fmt::format("{}", column.of(point));
    text += line + '\n';
  }
  return text;
}

template <class P>
Json json(std::initializer_list<std::vector<Column<P>> const*> lists, P const& point) {
  Json object = Json::object();
  for (auto const* columns : lists)
    for (auto const& column : *columns)
      object[column.name] = column.of(point);
  object["phase"] = name_of(point.phase);
  return object;
}

template <class P>
void write_table(std::filesystem::path const& file, std::string const& group,
                 std::initializer_list<std::vector<Column<P>> const*> lists, std::span<P const> points,
                 std::string const& description, Provenance const& provenance) {
  Store store(file, Store::Mode::create);
  write_provenance(store, provenance);
  store.set_attribute(group, "description", description);
  for (auto const* columns : lists)
    for (auto const& column : *columns) {
      std::vector<double> values;
      for (auto const& point : points)
        values.push_back(column.of(point));
      if (!std::all_of(values.begin(), values.end(), [](double x) { return std::isfinite(x); }))
        throw PhysicsError(
            fmt::format("column '{}' of '{}' is not finite: it is not written", column.name, group));
      store.write(group + "/" + column.name, values);
    }
  std::vector<std::int64_t> liquid;
  for (auto const& point : points)
    liquid.push_back(point.phase == cg::Phase::liquid);
  store.write(group + "/liquid", liquid);
  store.close();
}

std::string in(cg::Estimate const& estimate, double unit) {
  return with_error_text({estimate.mean / unit, estimate.se / unit, estimate.n_eff});
}

} // namespace

std::string metal_grid_csv(std::span<Point const> points) {
  return csv(grid_columns(), points);
}

Json metal_grid_json(std::span<Point const> points) {
  Json states = Json::array();
  for (auto const& point : points)
    states.push_back(json({&grid_columns(), &further_grid_columns()}, point));
  return states;
}

std::string metal_grid_text(std::span<Point const> points) {
  auto text = fmt::format("{:>10} {:>8}  {:<20} {:<22} {:<7} {:>6}\n", "rho kg/m^3", "T K", "P GPa",
                          "e kJ/kg", "phase", "order");
  for (auto const& p : points)
    text += fmt::format("{:10.1f} {:8.1f}  {:<20} {:<22} {:<7} {:6.2f}\n", p.state.rho, p.state.T,
                        in(p.P, 1e9), in(p.e, 1e3), name_of(p.phase), p.end.lattice_order);
  return text;
}

std::string hugoniot_csv(std::span<Shocked const> points) {
  return csv(hugoniot_columns(), points);
}

Json hugoniot_json(std::span<Shocked const> points) {
  Json states = Json::array();
  for (auto const& point : points) {
    auto object = json({&hugoniot_columns(), &further_hugoniot_columns()}, point);
    object["states"] = point.states;
    states.push_back(std::move(object));
  }
  return states;
}

std::string hugoniot_text(std::span<Shocked const> points) {
  auto text = fmt::format("{:<16} {:<16} {:>10}  {:<18} {:<16} {:<20} {}\n", "v_P m/s", "v_S m/s",
                          "rho kg/m^3", "P GPa", "T K", "e kJ/kg", "phase");
  for (auto const& p : points)
    text += fmt::format("{:<16} {:<16} {:10.1f}  {:<18} {:<16} {:<20} {}\n", in(p.v_P, 1), in(p.v_S, 1),
                        p.rho, in(p.P, 1e9), in(p.T, 1), in(p.e, 1e3), name_of(p.phase));
  return text;
}

void write_metal_grid(std::filesystem::path const& file, std::span<Point const> points,
                      std::string const& description, Provenance const& provenance) {
  write_table(file, "metal_grid", {&grid_columns(), &further_grid_columns()}, points, description,
              provenance);
}

void write_hugoniot(std::filesystem::path const& file, std::span<Shocked const> points,
                    std::string const& description, Provenance const& provenance) {
  write_table(file, "hugoniot", {&hugoniot_columns(), &further_hugoniot_columns()}, points, description,
              provenance);
}

std::vector<std::string> warnings_on(std::span<Point const> points, md::MetalSettings const& settings) {
  std::vector<std::string> warnings;
  auto const usual = settings.start == md::MetalStart::solid ? cg::Phase::solid : cg::Phase::liquid;
  double lowest_beyond = 0;
  for (auto const& point : points) {
    if (point.phase != usual)
      warnings.push_back(fmt::format("at {:.1f} kg/m^3, {:.0f} K the {} start ended as a {}", point.state.rho,
                                     point.state.T, name_of(usual), name_of(point.phase)));
    if (point.end.part_beyond_table > 0 && (lowest_beyond == 0 || point.state.rho < lowest_beyond))
      lowest_beyond = point.state.rho;
  }
  if (lowest_beyond > 0)
    warnings.push_back(
        fmt::format("from {:.1f} kg/m^3 on some atoms lie beyond the potential's table of the embedding "
                    "energy, which LAMMPS continues in a straight line (column part_beyond_table)",
                    lowest_beyond));
  return warnings;
}

} // namespace mesobridge::workflows
