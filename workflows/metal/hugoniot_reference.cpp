#include "workflows/metal/hugoniot_reference.hpp"
#include "md/error.hpp"
#include "md/quasiharmonic_metal.hpp"
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

HugoniotReference squeezed_along_z(HugoniotReference reference, md::MetalPistonSettings const& settings) {
  md::QuasiharmonicMetal metal(
      md::MpiWorld(),
      {.potential = settings.potential, .lattice = settings.lattice, .log_file = settings.log_file});
  auto const shift = [&](md::Squeeze squeeze, double sign) {
    double const compression = metal.compression(settings.ahead, settings.v_P, squeeze),
                 rho = compression * settings.ahead.rho;
    auto const shocked = metal.shocked(settings.ahead, rho, squeeze);
    reference.v_S.mean += sign * settings.v_P * compression / (compression - 1);
    reference.rho.mean += sign * rho, reference.P.mean += sign * shocked.P;
    reference.T.mean += sign * shocked.T;
  };
  shift(md::Squeeze::along_z, 1), shift(md::Squeeze::evenly, -1);
  return reference;
}

namespace {

/// All beside each other, with the differences from the piston's in standard errors.
Section reference_section(HugoniotReference const& reference,
                          std::optional<HugoniotReference> const& squeezed, ShockOfRun const& shock) {
  Table table{.header = {"behind the front", "piston", "squeezed evenly", "difference [se]"},
              .caption = "Squeezed evenly: states of equilibrium that fulfil the relations of Rankine and "
                         "Hugoniot (md hugoniot), linear between two of them."};
  if (squeezed) {
    table.header.insert(table.header.end(), {"squeezed along z", "difference [se]"});
    table.caption += " Squeezed along z: the same for a crystal without any plastic flow, whose lattice is "
                     "another then (a face-centred one comes near to a body-centred one), by the difference "
                     "of static crystals (md/README.md, "
                     "Eq. (M15)); the errors are those of the former. What a piston leaves lies at one of "
                     "them, or between.";
  }
  auto const even = quantities(reference, shock);
  for (std::size_t k = 0; k < even.size(); ++k) {
    auto const& q = even[k];
    table.rows.push_back({fmt::format("{} [{}]", q.name, q.unit), text(q.piston, q.factor),
                          text(q.reference, q.factor), fmt::format("{:+.1f}", q.deviation())});
    if (squeezed) {
      auto const along = quantities(*squeezed, shock)[k];
      table.rows.back().push_back(text(along.reference, q.factor));
      table.rows.back().push_back(fmt::format("{:+.1f}", along.deviation()));
    }
  }
  return {"Beside crystals of the same shock", {std::move(table)}};
}

/// Lines that begin with the name.
std::string reference_text(std::string const& name, HugoniotReference const& reference,
                           ShockOfRun const& shock) {
  std::string lines;
  for (auto const& q : quantities(reference, shock))
    lines += fmt::format("{} {:4} {} {} ({:+.1f} se)\n", name, q.name, text(q.reference, q.factor), q.unit,
                         q.deviation());
  return lines;
}

/// Nothing where there is no such shock; `why` says so then.
std::optional<HugoniotReference> estimate_along_z(HugoniotReference const& reference,
                                                  md::MetalPistonSettings const& settings, std::string& why) {
  try {
    return squeezed_along_z(reference, settings);
  } catch (InputError const& error) {
    why = error.what();
  } catch (PhysicsError const& error) {
    why = error.what();
  } catch (md::LammpsError const& error) {
    why = error.what(); // the piston's own results are there already, and count without it
  }
  return std::nullopt;
}

} // namespace

std::string put_references(HugoniotReference const& reference, md::MetalPistonSettings const& settings,
                           ShockOfRun const& shock, Json& summary, Report& report) {
  summary["hugoniot"] = reference_json(reference, shock);
  auto lines = reference_text("squeezed evenly ", reference, shock);
  std::string why;
  auto const squeezed = estimate_along_z(reference, settings, why);
  if (squeezed) {
    summary["hugoniot_along_z"] = reference_json(*squeezed, shock);
    lines += reference_text("squeezed along z", *squeezed, shock);
  } else
    report.warnings.push_back(fmt::format("There is no estimate of a crystal squeezed along z: {}.", why));
  report.sections.push_back(reference_section(reference, squeezed, shock));
  return lines;
}

} // namespace mesobridge::workflows
