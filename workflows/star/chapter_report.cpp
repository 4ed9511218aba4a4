#include "workflows/report/number_text.hpp"
#include "workflows/star/chapter.hpp"
#include "workflows/star/chapter_figures.hpp"
#include <algorithm>
#include <cmath>

namespace mesobridge::workflows {

namespace {

/// What the thesis prints for 6-3 stars at rho = 0.3, section 3.2.
constexpr double thesis_beta = 1.05, thesis_C_KU = 5.08e-2, thesis_C_UD = 8.59e-4, thesis_C_difference = 0.05;

/// In the order of their densities.
Melts of_star(Chapter const& chapter, std::string const& name) {
  Melts melts;
  for (auto const& melt : chapter.melts)
    if (melt.star.name() == name)
      melts.push_back(&melt);
  std::sort(melts.begin(), melts.end(), [](auto const* a, auto const* b) { return a->rho < b->rho; });
  return melts;
}

Melts all_of(Chapter const& chapter) {
  Melts melts;
  for (auto const& melt : chapter.melts)
    melts.push_back(&melt);
  return melts;
}

/// The names of the molecules but for the first one.
std::vector<std::string> larger_stars(Chapter const& chapter) {
  std::vector<std::string> names{chapter.melts.front().star.name()};
  for (auto const& melt : chapter.melts)
    if (std::find(names.begin(), names.end(), melt.star.name()) == names.end())
      names.push_back(melt.star.name());
  names.erase(names.begin());
  return names;
}

/// The melt whose heat capacity is farthest from vacuum.
VerdictLine heat_capacity_verdict(Chapter const& chapter) {
  auto const farther = [](ChapterMelt const& a, ChapterMelt const& b) {
    return std::abs(heat_capacity_difference(a).mean) < std::abs(heat_capacity_difference(b).mean);
  };
  auto const& melt = *std::max_element(chapter.melts.begin(), chapter.melts.end(), farther);
  auto const difference = heat_capacity_difference(melt);
  bool const within = std::abs(difference.mean) <= thesis_C_difference + 2 * difference.se;
  return {fmt::format("heat capacity in the melt against vacuum, farthest of {}: {} at rho = {}",
                      chapter.melts.size(), melt.star.name(), melt.rho),
          fmt::format("{:+.1f} ± {:.1f} %", 100 * difference.mean, 100 * difference.se),
          "within 5 % (thesis, Figure 3.8)", within ? Verdict::passed : Verdict::failed};
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
  lines.push_back({fmt::format("<U1 U2>^r/<U>^2 of pairs in contact, nearer than {:.2g}", c.contact),
                   fmt::format("{}; configurational {}", with_error_text(c.contact_energy),
                               with_error_text(c.configurational.contact_energy)),
                   "not 1: the thesis sees the key approximation fail there", Verdict::noted});
  lines.push_back(heat_capacity_verdict(chapter));
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
              .caption =
                  fmt::format("{} stars at rho = {}. The thesis, for 6-3 stars at 0.3, gives no errors.",
                              melt.star.name(), melt.rho)};
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
              .caption = fmt::format("{} stars at rho = {}; everything at U = {:.4g}.", melt.star.name(),
                                     melt.rho, routes.U_mean)};
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
  auto const small = of_star(chapter, melt.star.name());
  section.content.emplace_back(Figure{{draw_svg(entropy_figure("fig36", small)), draw_svg(figure_3_7(small))},
                                      "Figures 3.6 and 3.7."});
  section.content.emplace_back(
      Figure{{draw_svg(figure_3_8(small)), draw_svg(heat_capacity_differences(all_of(chapter)))},
             "Figure 3.8, at each melt's mean energy, and all melts against vacuum; the thesis finds 5 %."});
  return section;
}

Section positions_section(Chapter const& chapter) {
  auto const& melt = chapter.melts.front();
  auto const small = of_star(chapter, melt.star.name());
  Section section{.title = "Positions and energies", .content = {}};
  section.content.emplace_back(Figure{{draw_svg(radial_figure("fig39", small))},
                                      "Figure 3.9: g (lines) and u (points), and u - g, by the energies "
                                      "themselves and by configurational ones."});
  section.content.emplace_back(Paragraph{
      "In equilibrium momenta do not depend on positions, so that the kinetic part of an energy is noise "
      "wherever positions are given. Configurational energies have it at its mean: they say the same with "
      "about a tenth of the variance."});
  section.content.emplace_back(Figure{
      {draw_svg(figure_3_10(melt))},
      fmt::format(
          "Figure 3.10. Pairs nearer than {:.2g} are in contact: g(r) < 1/2. The innermost point joins "
          "bins until 400 pairs are in.",
          melt.correlations.contact)});
  section.content.emplace_back(Figure{{draw_svg(figure_3_11(melt)), draw_svg(figure_3_12(melt))},
                                      "Figures 3.11 and 3.12, the latter in bins of equally many samples."});
  Table tests{.header = {"test", "deviation", "standard error", "in standard errors", ""},
              .caption =
                  fmt::format("The key approximation, {} stars at rho = {}.", melt.star.name(), melt.rho)};
  for (auto const& test : melt.correlations.tests)
    tests.rows.push_back({test.name, number_text(test.deviation.mean, 3), number_text(test.deviation.se, 2),
                          fmt::format("{:.1f}", test.in_se), test.statement});
  section.content.emplace_back(tests);
  return section;
}

Section larger_section(Chapter const& chapter) {
  Section section{.title = "Larger molecules", .content = {}};
  Figure entropies{{}, "Figure 3.14: entropies of the larger molecules."};
  for (auto const& name : larger_stars(chapter)) {
    auto const melts = of_star(chapter, name);
    auto const number = entropies.svgs.size();
    section.content.emplace_back(Figure{{draw_svg(radial_figure(fmt::format("fig313x{}", number), melts))},
                                        "Figure 3.13: g (lines) and u (points), and u - g."});
    entropies.svgs.push_back(draw_svg(entropy_figure(fmt::format("fig314x{}", number), melts)));
  }
  section.content.emplace_back(std::move(entropies));
  return section;
}

Section melts_section(Chapter const& chapter) {
  Table table{
      .header = {"melt", "rho", "beta", "C_KU", "C_UD", "contact energy", "C melt", "C vacuum", "difference"},
      .caption = "C_UD and <U1 U2>^r/<U>^2 of pairs in contact by configurational energies."};
  for (auto const& melt : chapter.melts) {
    auto const& c = melt.correlations;
    auto const difference = heat_capacity_difference(melt);
    table.rows.push_back(
        {melt.star.name(), fmt::format("{}", melt.rho), with_error_text(c.beta), with_error_text(c.C_KU),
         with_error_text(c.configurational.C_UD), with_error_text(c.configurational.contact_energy),
         with_error_text(melt.entropy.curve("melt")->C), with_error_text(melt.entropy.curve("vacuum")->C),
         fmt::format("{:+.1f} ± {:.1f} %", 100 * difference.mean, 100 * difference.se)});
  }
  return {.title = "All melts", .content = {table}};
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
      .provenance = {},
      .sources = {"Faure 2017", "Thompson et al. 2022", "Wolff 2004"}};
  report.sections = {momenta_section(melt), entropy_section(chapter), positions_section(chapter)};
  if (!larger_stars(chapter).empty())
    report.sections.push_back(larger_section(chapter));
  if (chapter.melts.size() > 1)
    report.sections.push_back(melts_section(chapter));
  return report;
}

} // namespace mesobridge::workflows
