#include "workflows/report/number_text.hpp"
#include "workflows/star/chapter.hpp"
#include "workflows/star/chapter_figures.hpp"
#include <cmath>

namespace mesobridge::workflows {

namespace {

/// What the thesis prints for 6-3 stars at rho = 0.3, section 3.2.
constexpr double thesis_beta = 1.05, thesis_C_KU = 5.08e-2, thesis_C_UD = 8.59e-4, thesis_C_difference = 0.05;

using Melts = std::vector<ChapterMelt const*>;

Melts of(Chapter const& chapter, std::function<bool(ChapterMelt const&)> const& wanted) {
  Melts melts;
  for (auto const& melt : chapter.melts)
    if (wanted(melt))
      melts.push_back(&melt);
  return melts;
}

VerdictLine heat_capacity_verdict(ChapterMelt const& melt) {
  auto const &C_melt = melt.entropy.curve("melt")->C, &C_vacuum = melt.entropy.curve("vacuum")->C;
  double const difference = C_melt.mean / C_vacuum.mean - 1,
               se = std::hypot(C_melt.se / C_melt.mean, C_vacuum.se / C_vacuum.mean);
  bool const within = std::abs(difference) <= thesis_C_difference + 2 * se;
  return {fmt::format("heat capacity in the melt against vacuum, {} at rho = {}", melt.star.name(), melt.rho),
          fmt::format("{:+.1f} ± {:.1f} %", 100 * difference, 100 * se), "within 5 % (thesis, Figure 3.8)",
          within ? Verdict::passed : Verdict::failed};
}

std::vector<VerdictLine> verdicts(Chapter const& chapter) {
  auto const& first = chapter.melts.front();
  auto const& c = first.correlations;
  std::vector<VerdictLine> lines;
  lines.push_back({"C_KU: translational against intrinsic energy", with_error_text(c.C_KU),
                   "0 in theory: momenta are separable in classical mechanics, whatever the potential",
                   std::abs(c.test("C_KU = 0").in_se) < 4 ? Verdict::passed : Verdict::failed});
  lines.push_back(
      {"u(r) = g(r) beyond contact",
       fmt::format("farthest bin {:.1f} standard errors off", c.test("u(r) = g(r) beyond contact").in_se),
       "key approximation",
       std::abs(c.test("u(r) = g(r) beyond contact").in_se) < 5 ? Verdict::passed : Verdict::noted});
  lines.push_back({fmt::format("<U1 U2>^r/<U>^2 of pairs nearer than {:.2g}", c.contact),
                   with_error_text(c.contact_energy),
                   "not 1: the thesis sees the key approximation fail there", Verdict::noted});
  for (auto const& melt : chapter.melts)
    lines.push_back(heat_capacity_verdict(melt));
  lines.push_back(
      {"blobs' energies add up to LAMMPS's",
       fmt::format("within {:.1e} (relative)", first.run["blob_energy_sum_relative_error_max"].get<double>()),
       "1e-9",
       first.run["blob_energy_sum_relative_error_max"].get<double>() < 1e-9 ? Verdict::passed
                                                                            : Verdict::failed});
  return lines;
}

Section momenta_section(ChapterMelt const& melt) {
  auto const& c = melt.correlations;
  Table table{.header = comparison_header(),
              .rows = {},
              .caption = "6-3 stars at rho = 0.3. The thesis gives no errors."};
  table.rows = {comparison_row("beta", c.beta, thesis_beta), comparison_row("C_KU", c.C_KU, thesis_C_KU),
                comparison_row("C_UD", c.C_UD, thesis_C_UD)};
  Section section{.title = "Momenta and energies", .content = {}};
  section.content.emplace_back(table);
  section.content.emplace_back(Paragraph{
      fmt::format("beta is that of the run at constant energy, which the thermostat left at T = 1. <U> = {}. "
                  "Autocorrelation times: momentum {:.3g}, intrinsic energy {:.3g}, local density {:.3g}; "
                  "errors are from {} "
                  "blocks of {:.3g} time units. A fixed total energy alone makes C_KU = {:.1e}.",
                  with_error_text(c.U_mean), c.tau_P.tau, c.tau_U.tau, c.tau_rho.tau, c.blocks, c.block_time,
                  c.C_KU_expected)});
  section.content.emplace_back(
      Figure{{draw_svg(figure_3_2(melt)), draw_svg(figure_3_3(melt))}, "Figures 3.2 and 3.3."});
  section.content.emplace_back(Figure{
      {draw_svg(figure_3_4(melt)), figure_3_5(melt)},
      fmt::format("Figures 3.4 and 3.5. Grey: fewer than 50 samples. Typical relative error {:.3f}, of which "
                  "noise makes {:.3f}.",
                  c.map.typical, c.map.typical_from_noise)});
  return section;
}

std::vector<std::string> entropy_row(std::string const& name, cg::Estimate const& C, cg::Estimate const& T,
                                     std::string const& bias) {
  return {name, with_error_text(C), bias, with_error_text(T)};
}

Section entropy_section(Chapter const& chapter) {
  auto const& melt = chapter.melts.front();
  auto const& routes = melt.entropy;
  Table table{.header = {"route", "C", "change with one order more", "T"},
              .rows = {},
              .caption = fmt::format("6-3 stars at rho = 0.3; everything at U = {:.4g}.", routes.U_mean)};
  for (auto const& [route, name] : {std::pair{"melt", "melt: ln P(U) + beta U"},
                                    {"melt_kinetic", "melt: (n/2 - 1)<1/E_kin>^U"},
                                    {"vacuum", "vacuum: P_T(U) of several T (maximum likelihood)"},
                                    {"vacuum_kinetic", "vacuum: (n/2 - 1)<1/E_kin>^U"}})
    if (auto const* const curve = routes.curve(route))
      table.rows.push_back(entropy_row(name, curve->C,
                                       curve->fit.estimate([&](auto const& s) { return s.T(routes.U_mean); }),
                                       fmt::format("{:+.2g}", curve->C_bias)));
  if (routes.equipartition)
    table.rows.push_back(entropy_row("vacuum: the thesis's equipartition, constant energy",
                                     routes.equipartition->C(routes.U_mean),
                                     routes.equipartition->T(routes.U_mean), ""));
  Section section{.title = "Entropy and heat capacity", .content = {}};
  section.content.emplace_back(Paragraph{"S(U) is a polynomial in ln U, found by maximum likelihood: one "
                                         "term alone is a harmonic molecule. What one "
                                         "term more would change is its bias. The kinetic routes need no "
                                         "histogram: for a molecule of fixed momentum "
                                         "1/T = (n/2 - 1)<1/E_kin> with n = 3N - 3 holds exactly, in the "
                                         "melt too if S(U) + const = ln P(U) + beta U. "
                                         "Equipartition with 3N instead is about 1/N low in T."});
  section.content.emplace_back(table);
  auto const small = of(chapter, [](auto const& m) { return m.star.beads == 3; });
  section.content.emplace_back(Figure{{draw_svg(entropy_figure("fig36", small)), draw_svg(figure_3_7(small))},
                                      "Figures 3.6 and 3.7."});
  section.content.emplace_back(
      Figure{{draw_svg(figure_3_8(small))}, "Figure 3.8, at each melt's mean energy."});
  return section;
}

Section positions_section(Chapter const& chapter) {
  auto const& melt = chapter.melts.front();
  auto const small = of(chapter, [](auto const& m) { return m.star.beads == 3; });
  Section section{.title = "Positions and energies", .content = {}};
  section.content.emplace_back(
      Figure{{draw_svg(radial_figure("fig39", small))}, "Figure 3.9, and the difference."});
  section.content.emplace_back(
      Figure{{draw_svg(figure_3_10(melt)), draw_svg(figure_3_11(melt))},
             "Figures 3.10 and 3.11. The innermost point joins bins until 400 pairs are in."});
  section.content.emplace_back(
      Figure{{draw_svg(figure_3_12(melt))}, "Figure 3.12, in bins of equally many samples."});
  Table tests{.header = {"test", "deviation", "standard error", "in standard errors", ""},
              .rows = {},
              .caption = "The key approximation, 6-3 stars at rho = 0.3."};
  for (auto const& test : melt.correlations.tests)
    tests.rows.push_back({test.name, number_text(test.deviation.mean, 3), number_text(test.deviation.se, 2),
                          fmt::format("{:.1f}", test.in_se), test.statement});
  section.content.emplace_back(tests);
  return section;
}

Section larger_section(Melts const& larger) {
  Section section{.title = "Larger molecules", .content = {}};
  section.content.emplace_back(Figure{{draw_svg(radial_figure("fig313", larger))}, "Figure 3.13."});
  Figure entropies{{}, "Figure 3.14."};
  for (std::size_t k = 0; k < larger.size(); ++k)
    entropies.svgs.push_back(draw_svg(entropy_figure(fmt::format("fig314{}", char('a' + k)), {larger[k]})));
  section.content.emplace_back(std::move(entropies));
  return section;
}

} // namespace

Report chapter_report(Chapter const& chapter) {
  auto const& melt = chapter.melts.front();
  Report report{
      .title = "Star polymers: is the key approximation right?",
      .lead = fmt::format(
          "Chapter 3 of the thesis, measured anew with {} molecules over {:.4g} time units at rho = {}: are "
          "position, momentum and intrinsic energy of a molecule independent, and is its entropy that of "
          "the isolated molecule?",
          melt.run["molecules"].get<int>(), melt.run["time_sampled"].get<double>(), melt.rho),
      .verdicts = verdicts(chapter),
      .sections = {},
      .provenance = {}};
  report.sections = {momenta_section(melt), entropy_section(chapter), positions_section(chapter)};
  if (auto const larger = of(chapter, [](auto const& m) { return m.star.beads != 3; }); !larger.empty())
    report.sections.push_back(larger_section(larger));
  return report;
}

} // namespace mesobridge::workflows
