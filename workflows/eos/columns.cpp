#include "workflows/eos/columns.hpp"
#include "md/error.hpp"
#include <algorithm>
#include <cmath>

namespace mesobridge::workflows {

namespace {

using fitting::EosState;
using fitting::Shock;

template <class Row, class Value>
Column column(std::string key, std::string si_suffix, std::string unit, std::vector<Row> const& rows,
              Value&& value) {
  Column result{std::move(key), std::move(si_suffix), std::move(unit), {}};
  for (auto const& row : rows)
    result.values.push_back(value(row));
  return result;
}

} // namespace

Columns state_columns(std::vector<EosState> const& states) {
  return {
      column("rho", "_kg_m3", "kg/m^3", states, [](EosState const& s) { return s.rho; }),
      column("T", "_K", "K", states, [](EosState const& s) { return s.T; }),
      column("P", "_Pa", "Pa", states, [](EosState const& s) { return s.P; }),
      column("e", "_J_kg", "J/kg", states, [](EosState const& s) { return s.e; }),
      column("s", "_J_kg_K", "J/(kg K)", states, [](EosState const& s) { return s.s; }),
      column("c_v", "_J_kg_K", "J/(kg K)", states, [](EosState const& s) { return s.c_v; }),
      column("sound_speed", "_m_s", "m/s", states, [](EosState const& s) { return s.sound_speed; }),
      column("gruneisen", "", "", states, [](EosState const& s) { return s.gruneisen; }),
  };
}

Columns shock_columns(std::vector<Shock> const& shocks) {
  Columns columns{column("v_P", "_m_s", "m/s", shocks, [](Shock const& s) { return s.v_P; }),
                  column("v_S", "_m_s", "m/s", shocks, [](Shock const& s) { return s.v_S; })};
  std::vector<EosState> behind;
  for (auto const& shock : shocks)
    behind.push_back(shock.behind);
  for (auto& of_state : state_columns(behind))
    columns.push_back(std::move(of_state));
  return columns;
}

void require_numbers(Columns const& columns) {
  for (auto const& c : columns)
    for (std::size_t row = 0; row < c.values.size(); ++row)
      if (auto const& value = c.values[row]; value && !std::isfinite(*value)) {
        std::string state;
        for (auto const& other : columns)
          if (auto const& here = other.values.at(row); here && (other.key == "rho" || other.key == "T"))
            state += fmt::format("{}{} = {}", state.empty() ? " at " : ", ", other.key, *here);
        throw PhysicsError(
            fmt::format("{} = {}{}: the state is too extreme for double precision", c.key, *value, state));
      }
}

void put_first_row(Json& object, Columns const& columns, bool reduced, std::string const& prefix) {
  require_numbers(columns);
  for (auto const& c : columns)
    if (auto const value = c.values.front())
      object[prefix + c.name(reduced)] = *value;
}

Json arrays(Columns const& columns, bool reduced) {
  require_numbers(columns);
  Json object = Json::object();
  for (auto const& c : columns) {
    auto& array = object[c.name(reduced)] = Json::array();
    for (auto const& value : c.values)
      array.push_back(value ? Json(*value) : Json());
  }
  return object;
}

std::string csv_text(Columns const& columns, bool reduced) {
  require_numbers(columns);
  std::string text;
  for (auto const& c : columns)
    text += (text.empty() ? "" : ",") + c.name(reduced);
  for (std::size_t row = 0; row < columns.front().values.size(); ++row) {
    text += '\n';
    for (std::size_t i = 0; i < columns.size(); ++i) {
      auto const& value = columns[i].values[row];
      text += (i ? "," : "") + (value ? fmt::format("{}", *value) : std::string());
    }
  }
  return text + "\n";
}

void tell_first_row(Result& result, Columns const& columns, bool reduced) {
  put_first_row(result.json, columns, reduced);
  constexpr std::size_t least_width = 12;
  auto const width = std::max(
      least_width, std::ranges::max(columns, {}, [](auto const& c) { return c.key.size(); }).key.size());
  for (auto const& c : columns)
    if (auto const value = c.values.front())
      result.text += fmt::format("{:<{}} {:<24} {}\n", c.key, width, fmt::format("{:.10g}", *value),
                                 reduced ? "" : c.unit);
}

} // namespace mesobridge::workflows
