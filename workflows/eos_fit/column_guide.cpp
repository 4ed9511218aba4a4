#include "workflows/eos_fit/column_guide.hpp"
#include "workflows/eos_fit/data_columns.hpp"
#include <fmt/format.h>

namespace mesobridge::workflows {
namespace {

/// A kind of row: what is given, what is measured there, and a file of one row.
struct RowKind {
  char const *name, *given, *measured, *header, *row;
};

constexpr RowKind row_kinds[] = {
    {"state", "rho, and T or e", "P, e, c_v, sound_speed", "rho_kg_m3,T_K,P_GPa,P_se_GPa", "8930,293,0,0.1"},
    {"hugoniot", "rho0 and T0 (or e0, or P0) ahead of the shock, and one of v_P, v_S, rho, P",
     "another of these; T, c_v, sound_speed behind it", "rho0_g_cm3,T0_K,v_P_km_s,v_S_km_s,v_S_se_km_s",
     "8.93,293,1.00,5.408,0.054"},
    {"isentrope", "rho0 and T0 (or e0, or P0) where it begins, and rho", "P, T, e, c_v, sound_speed",
     "kind,rho0_kg_m3,P0_GPa,rho_kg_m3,P_GPa,P_se_GPa", "isentrope,2440,29.5,1500,9.1,0.3"},
    {"cj", "rho0 and e0, P0 of the unreacted explosive", "v_S (which D is, too), P, rho, v_P",
     "kind,rho0_kg_m3,e0_J_kg,P0_Pa,D_m_s,D_se_m_s", "cj,1717,4950495,1e5,7980,80"}};

} // namespace

std::string column_guide() {
  std::string text =
      "A row of a data file is one observation. A column `kind` says which; without it a row with "
      "rho0 is a hugoniot, any other a state.\n\n";
  for (auto const& kind : row_kinds)
    text += fmt::format("{}\n  given:    {}\n  measured: {}\n  for example\n    {}\n    {}\n\n", kind.name,
                        kind.given, kind.measured, kind.header, kind.row);
  text +=
      "What is measured needs a standard error: a column (P_se_GPa or P_GPa_se), or --relative-error. "
      "Columns "
      "`phase`, `source`, `comment` ... are passed over.\n\n"
      "Columns and their units, which may be written in other usual ways (rho0_g_cc, P [GPa], Us (km/s), up, "
      "T_0):\n";
  for (auto const& [symbol, units] : data_columns_and_units())
    text += fmt::format("  {:<12} {}\n", symbol, units);
  return text;
}

} // namespace mesobridge::workflows
