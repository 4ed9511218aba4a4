#include "workflows/detonation_study/detonation_runs.hpp"
#include "workflows/eos/detonation_view.hpp"
#include "workflows/report/number_text.hpp"
#include "workflows/reproduce/list.hpp"
#include "workflows/reproduce/published.hpp"

namespace mesobridge::workflows {
namespace {

constexpr double GPa = 1e9;

template <class State>
std::vector<std::string> row_of(std::string const& what, double D, double rho, State const& at) {
  return {what, D > 0 ? number_text(D, 5) : "", number_text(rho, 5), number_text(at.P / GPa, 4),
          number_text(at.T, 4)};
}

/// With zero in place of the pressure that the reactant's model has at rest.
fitting::Shock without_pressure(fitting::ReactiveFluid fluid) {
  fluid.at_rest.P = 0;
  return fluid.crussard().chapman_jouguet();
}

} // namespace

Reproduced reproduce_figure_6_2(ReproduceOptions const&, Context const&) {
  auto const theory = nitromethane_theory();
  auto const& cj = theory.chapman_jouguet;
  auto const at_zero = without_pressure(theory.fluid);
  double const printed = published("thesis-table-6.4.csv").value("Rayleigh", "D_m_s");
  Table table{
      .header = {"state", "D [m/s]", "density [kg/m^3]", "P [GPa]", "T [K]"},
      .rows = {row_of("at rest", 0, theory.fluid.at_rest.rho, theory.fluid.at_rest),
               row_of("Chapman-Jouguet", cj.v_S, cj.behind.rho, cj.behind),
               row_of("the same, P = 0 at rest", at_zero.v_S, at_zero.behind.rho, at_zero.behind),
               row_of("von Neumann", cj.v_S, theory.spike().rho, theory.spike().state),
               {"Chapman-Jouguet, printed", number_text(printed, 5), "", "", ""}},
      .caption =
          "The printed velocity follows from the thesis's own equations for 3.52e6 J/kg of heat in "
          "place of the 4.716e6 J/kg (4.78e-19 J a molecule) that it states, and these are taken here."};
  Reproduced found;
  found.summary = {{"D_m_s", cj.v_S},
                   {"P_Pa", cj.behind.P},
                   {"rho_kg_m3", cj.behind.rho},
                   {"T_K", cj.behind.T},
                   {"D_at_zero_pressure_m_s", at_zero.v_S},
                   {"D_printed_m_s", printed}};
  auto& report = found.report;
  report.title = "Figure 6.2: Hugoniot and Crussard curves of nitromethane";
  report.lead =
      "The unreacted fluid by the equation of state HZ and its products by JWL, from 1104 kg/m^3 and 300 K. "
      "The Rayleigh line of the slowest detonation touches the Crussard curve at the Chapman-Jouguet point.";
  auto const plot =
      detonation_plot(view_of(theory.fluid, "nitromethane", "nitromethane-products"), 24 * GPa, 120);
  report.sections = {{"Pressure over volume", {Figure{{draw_svg(plot)}, ""}, table}}};
  report.sources = {"Faure 2017"};
  return found;
}

} // namespace mesobridge::workflows
