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

/// The columns of a table, in their order.
template <class Point>
struct Columns : std::vector<Column<Point>> {
  template <class Of>
  Columns&& with(std::string const& name, Of const& of) && {
    this->push_back({name, [of](Point const& p) { return std::invoke(of, p); }});
    return std::move(*this);
  }
  /// An estimate's mean, and its standard error beside it.
  Columns&& with(std::string const& name, std::string const& unit, cg::Estimate Point::*of) && {
    return std::move(*this)
        .with(name + unit, [of](Point const& p) { return (p.*of).mean; })
        .with(name + "_se" + unit, [of](Point const& p) { return (p.*of).se; });
  }
};

using Point = cg::MetalPoint;
using Shocked = cg::HugoniotPoint;

Columns<Point> const& grid_columns() {
  static auto const list = Columns<Point>()
                               .with("rho_kg_m3", [](Point const& p) { return p.state.rho; })
                               .with("T_K", [](Point const& p) { return p.state.T; })
                               .with("P", "_Pa", &Point::P)
                               .with("e", "_J_kg", &Point::e);
  return list;
}

/// What the CSV leaves out.
Columns<Point> const& further_grid_columns() {
  static auto const list =
      Columns<Point>()
          .with("P_e_correlation", [](Point const& p) { return p.cov_eP / (p.P.se * p.e.se); })
          .with("T_kin", "_K", &Point::T_kin)
          .with("c_v", "_J_kg_K", &Point::c_v)
          .with("lattice_order", [](Point const& p) { return p.end.lattice_order; })
          .with("displacement_2", &Point::displacement_2)
          .with("part_beyond_table", [](Point const& p) { return p.end.part_beyond_table; })
          .with("n_eff_P", [](Point const& p) { return p.P.n_eff; })
          .with("n_eff_e", [](Point const& p) { return p.e.n_eff; });
  return list;
}

Columns<Shocked> const& hugoniot_columns() {
  static auto const list = Columns<Shocked>()
                               .with("rho0_kg_m3", [](Shocked const& p) { return p.initial.rho; })
                               .with("T0_K", [](Shocked const& p) { return p.initial.T; })
                               .with("P0", "_Pa", &Shocked::P0)
                               .with("v_P", "_m_s", &Shocked::v_P)
                               .with("v_S", "_m_s", &Shocked::v_S)
                               .with("rho_kg_m3", &Shocked::rho)
                               .with("P", "_Pa", &Shocked::P)
                               .with("T", "_K", &Shocked::T)
                               .with("e", "_J_kg", &Shocked::e);
  return list;
}

Columns<Shocked> const& further_hugoniot_columns() {
  static auto const list =
      Columns<Shocked>()
          .with("v_S_v_P_correlation", [](Shocked const& p) { return p.cov_vSvP / (p.v_S.se * p.v_P.se); })
          .with("chi_2", &Shocked::chi_2);
  return list;
}

template <class P>
std::string csv(Columns<P> const& columns, std::span<P const> points) {
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
Json json(std::initializer_list<Columns<P> const*> lists, P const& point) {
  Json object = Json::object();
  for (auto const* columns : lists)
    for (auto const& column : *columns)
      object[column.name] = column.of(point);
  object["phase"] = name_of(point.phase);
  return object;
}

template <class P>
void write_table(std::filesystem::path const& file, std::string const& group,
                 std::initializer_list<Columns<P> const*> lists, std::span<P const> points,
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
