#include "md/error.hpp"
#include "scratch_directory.hpp"
#include "workflows/report/embedded_svg.hpp"
#include "workflows/report/heat_map.hpp"
#include "workflows/report/number_text.hpp"
#include "workflows/report/plot.hpp"
#include "workflows/report/report.hpp"
#include "workflows/report/sources.hpp"
#include "workflows/sdpd/run_plots.hpp"
#include "workflows/summary.hpp"
#include "workflows/text_file.hpp"
#include <cstdlib>
#include <gtest/gtest.h>
#include <regex>
#include <set>

namespace mesobridge::workflows {

namespace {

Series series(std::string label, std::vector<double> y, SeriesStyle style, int colour) {
  return {.label = std::move(label),
          .x = {0.1, 0.2, 0.3},
          .y = std::move(y),
          .y_error = {},
          .style = style,
          .colour = colour};
}

Plot isotherms() {
  Plot plot;
  plot.name = "isotherms";
  plot.title = "Isotherms";
  plot.x.label = "ρ^*";
  plot.x.min = 0;
  auto& main = plot.panels.emplace_back();
  main.series = {series("MD", {1, 2, 3.5}, SeriesStyle::points, 0),
                 series("fit", {1, 2.1, 3.4}, SeriesStyle::lines, 1)};
  main.series[0].y_error = {0.1, 0.1, 0.2};
  main.y.label = "P^*";
  main.y.logarithmic = true;
  main.height = 3;
  auto& residuals = plot.panels.emplace_back();
  residuals.series = {series("", {0.3, -1.2, 0.5}, SeriesStyle::points, 0)};
  residuals.y.label = "residual / se";
  residuals.y.min = -3, residuals.y.max = 3;
  residuals.legend = Legend::none;
  residuals.level_lines = {0};
  return plot;
}

/// Whether every tag that is opened is closed in the right order; those that HTML leaves open need not be.
bool is_balanced(std::string const& xml) {
  static std::set<std::string> const never_closed{"meta", "br", "img"};
  static std::regex const tag(R"re(<(/?)([A-Za-z]\w*)([^<>]*?)(/?)>)re");
  std::vector<std::string> open;
  for (std::sregex_iterator match(xml.begin(), xml.end(), tag), end; match != end; ++match) {
    bool const closing = (*match)[1].length() > 0,
               empty = (*match)[4].length() > 0 || never_closed.contains((*match)[2]);
    if (closing && (open.empty() || open.back() != (*match)[2]))
      return false;
    if (closing)
      open.pop_back();
    else if (!empty)
      open.push_back((*match)[2]);
  }
  return open.empty();
}

int count(std::string const& text, std::string const& what) {
  int found = 0;
  for (auto at = text.find(what); at != text.npos; at = text.find(what, at + what.size()))
    ++found;
  return found;
}

TEST(Plot, IsAnSvgThatShowsEverySeriesAndLabel) {
  auto const svg = draw_svg(isotherms());
  EXPECT_TRUE(svg.starts_with("<svg"));
  EXPECT_TRUE(is_balanced(svg));
  EXPECT_FALSE(is_balanced(svg + "</g>"));
  EXPECT_NE(svg.find(">MD<"), std::string::npos);
  EXPECT_NE(svg.find(">fit<"), std::string::npos);
  EXPECT_NE(svg.find("residual / se"), std::string::npos);
  EXPECT_GE(count(svg, "xlink:href='#isothermsPt") + count(svg, "href='#gpPt"),
            6); // three points, three residuals
  for (auto const* colour : {"0, 114, 178", "213,  94,   0"})
    EXPECT_NE(svg.find(colour), std::string::npos) << colour;
}

TEST(Plot, EveryStyleDraws) {
  auto plot = isotherms();
  int ran = 0;
  for (auto const style :
       {SeriesStyle::points, SeriesStyle::lines, SeriesStyle::dashes, SeriesStyle::steps, SeriesStyle::band})
    for (auto const legend : {Legend::below, Legend::none}) {
      plot.panels[0].series[0].style = style;
      plot.panels[0].legend = legend;
      EXPECT_TRUE(is_balanced(draw_svg(plot)));
      ++ran;
    }
  EXPECT_EQ(ran, 10);
}

TEST(Plot, RefusesWhatCannotBeDrawn) {
  auto plot = isotherms();
  plot.panels[0].series[0].y[1] = std::nan("");
  EXPECT_THROW(draw_svg(plot), PhysicsError);
  plot.panels[0].series[0].y[1] = 0; // on a logarithmic axis
  EXPECT_THROW(draw_svg(plot), PhysicsError);
  plot.panels[0].series[0].y = {1};
  EXPECT_THROW(draw_svg(plot), std::logic_error);
  plot = isotherms();
  plot.x.min = plot.x.max = 5; // an empty range: gnuplot itself refuses
  try {
    draw_svg(plot);
    ADD_FAILURE() << "gnuplot's failure went unnoticed";
  } catch (EnvironmentError const& error) {
    EXPECT_NE(std::string(error.what()).find("gnuplot could not draw 'isotherms'"), std::string::npos)
        << error.what();
  }
}

TEST(Plot, AMissingGnuplotIsAnErrorOfTheEnvironment) {
  EXPECT_EXIT(
      {
        setenv("PATH", "/dev/null", 1); // no folder, so nothing is found in it
        try {
          draw_svg(isotherms());
        } catch (EnvironmentError const& error) {
          std::cerr << error.what();
          std::exit(4);
        }
      },
      testing::ExitedWithCode(4), "cannot run 'gnuplot': (No such file|Not a directory)");
}

TEST(Report, IsOneSelfContainedPage) {
  Report report{.title = "LJ <to> SDPD",
                .lead = "What `fit` & MD say.",
                .verdicts = {},
                .sections = {},
                .provenance = {}};
  report.provenance.command = "mesobridge workflow lj-to-sdpd";
  report.verdicts.push_back({"Pressure", "0.6814 ± 0.0003", "0.6810", Verdict::passed});
  report.verdicts.push_back({"Drift", "1", "0", Verdict::failed});
  report.sections.push_back(
      {"Isotherms",
       {Paragraph{"a < b"}, Figure{{draw_svg(isotherms())}, "the caption"},
        Table{comparison_header(), {comparison_row("P [GPa]", {0.6814, 0.0003, 50}, 0.6808)}, "numbers"}}});
  auto const html = report.html();
  EXPECT_NE(html.find("<h1>LJ &lt;to&gt; SDPD</h1>"), std::string::npos);
  EXPECT_NE(html.find("What <code>fit</code> &amp; MD say."), std::string::npos);
  EXPECT_NE(html.find("<td>0.68140 ± 0.00030</td><td>0.6808</td><td>+0.09 %</td><td>+2.0 se</td>"),
            std::string::npos);
  EXPECT_EQ(count(html, "class=\"pill passed\""), 1);
  EXPECT_EQ(count(html, "class=\"pill failed\""), 1);
  EXPECT_EQ(count(html, "<svg"), 1);
  EXPECT_TRUE(is_balanced(html));
  // Nothing is loaded from elsewhere: a page may name addresses, but only for readers who follow them.
  static std::regex const load(
      R"re(src\s*=|<link|<script|xlink:href=["'](?!#)|url\(\s*["']?(?!#)|@import)re");
  EXPECT_FALSE(std::regex_search(html, load));
  EXPECT_EQ(count(html, "<th scope=\"col\">"), 4 + 5) << "verdicts without deviations, and the table";
  EXPECT_EQ(count(html, "role=\"img\""), 1);
  EXPECT_NE(html.find("<title>Isotherms: P^*; residual / se against ρ^*</title>"), std::string::npos);
  report.sections[0].content.emplace_back(Table{{"a", "b"}, {{"1"}}, ""});
  EXPECT_THROW(report.html(), std::logic_error);
}

TEST(Report, WarnsFirstCitesItsSourcesAndLinksItsFiles) {
  Report report{.title = "t", .lead = "l", .verdicts = {}, .sections = {}, .provenance = {}};
  report.verdicts.push_back({"a", "b", "c", Verdict::passed, "+0.3 se; allowed 3.3"});
  report.warnings = {"T_kin and T_int are 77 % apart"};
  report.sources = {"Thol et al. 2016"};
  report.sections = {{"One", {}}, {"Two", {}}, {"Three", {Files{{{"run.h5", "samples"}}}}}};
  auto const html = report.html();
  EXPECT_TRUE(is_balanced(html));
  EXPECT_LT(html.find("77 % apart"), html.find("allowed 3.3"));
  EXPECT_NE(html.find("<a href=\"https://doi.org/10.1063/1.4945000\">"), std::string::npos);
  EXPECT_NE(html.find("<a href=\"run.h5\">run.h5</a>: samples"), std::string::npos);
  EXPECT_EQ(count(html, "<nav"), 1);
  EXPECT_EQ(count(html, "href=\"#s"), 3 + 1) << "three sections and the sources";
  report.sections.pop_back();
  EXPECT_EQ(count(report.html(), "<nav"), 0) << "nobody is lost in two sections";
  report.sources = {"Nobody 1900"};
  EXPECT_THROW(report.html(), std::logic_error);
}

TEST(Report, EverySourceIsWhole) {
  std::set<std::string_view> keys;
  for (auto const& [key, authors, title, where, year, link] : all_sources()) {
    keys.insert(key);
    EXPECT_GT(authors.size(), 5u) << key;
    EXPECT_GT(title.size(), 10u) << key;
    EXPECT_GT(where.size(), 10u) << key;
    EXPECT_NE(key.find(std::to_string(year)), key.npos) << key;
    EXPECT_TRUE(link.starts_with("https://")) << key;
  }
  EXPECT_GE(keys.size(), 12u);
  EXPECT_EQ(keys.size(), all_sources().size()) << "no key twice";
}

TEST(Report, DrawingsHaveOneSizeAndFontAndNamesOfTheirOwn) {
  auto flat = isotherms();
  flat.panels.resize(1);
  for (int k = 0; k < 9; ++k)
    flat.panels[0].series.push_back(
        series(fmt::format("a rather long label {}", k), {1, 2, 3}, SeriesStyle::lines, k));
  HeatMap const map{
      .title = "m", .x_label = "x", .y_label = "y", .value_label = "v", .x = {1}, .y = {1}, .value = {1.0}};
  std::string page;
  std::size_t number = 0;
  for (auto const& svg : {draw_svg(isotherms()), draw_svg(flat), draw_svg(map)}) {
    static std::regex const size("viewBox=[\"']0 0 640 480[\"']");
    EXPECT_TRUE(std::regex_search(svg, size));
    EXPECT_NE(svg.find("Arial"), std::string::npos);
    page += embedded_svg(svg, ++number);
  }
  EXPECT_TRUE(is_balanced(page));
  static std::regex const id(R"re(\bid=["']([^"']+)["'])re");
  std::set<std::string> names;
  std::size_t found = 0;
  for (std::sregex_iterator match(page.begin(), page.end(), id), end; match != end; ++match)
    names.insert((*match)[1]), ++found;
  EXPECT_GT(found, 40u);
  EXPECT_EQ(names.size(), found) << "a name is there twice";
  static std::regex const link(R"re(href=["']#([^"']+)["'])re");
  for (std::sregex_iterator match(page.begin(), page.end(), link), end; match != end; ++match)
    EXPECT_TRUE(names.contains((*match)[1])) << (*match)[1];
  EXPECT_EQ(page.find("rgb(  0, 114, 178)"), std::string::npos) << "colours follow the page";
  EXPECT_NE(page.find("var(--c0)"), std::string::npos);
}

// The first point of these data lies on the axis's end that gnuplot would choose.
TEST(Plot, LogarithmicAxesLeaveRoomAroundTheirPoints) {
  Plot plot;
  plot.name = "log";
  plot.x.logarithmic = true;
  auto& panel = plot.panels.emplace_back();
  panel.y.logarithmic = true;
  panel.series.push_back({.label = "", .x = {1, 100}, .y = {1, 100}, .y_error = {}});
  auto const svg = draw_svg(plot);
  static std::regex const point(R"re(translate\(([0-9.]+),([0-9.]+)\) scale)re");
  std::vector<std::pair<double, double>> places;
  for (std::sregex_iterator match(svg.begin(), svg.end(), point), end; match != end; ++match)
    places.emplace_back(std::stod((*match)[1]), std::stod((*match)[2]));
  ASSERT_EQ(places.size(), 2u);
  for (auto const& [x, y] : places) {
    EXPECT_GT(x, 104 + 10);
    EXPECT_LT(x, 640 - 24 - 10);
    EXPECT_GT(y, 16 + 10);
    EXPECT_LT(y, 480 - 64 - 10);
  }
}

TEST(RunPlots, ColumnsHaveAxesAndLongSeriesAreThinned) {
  struct Case {
    char const *column, *label;
    double factor;
  };
  int ran = 0;
  for (auto const& [column, label, factor] :
       {Case{"P_Pa", "P [GPa]", 1e-9}, Case{"rho_kg_m3", "rho [kg/m^3]", 1},
        Case{"T_kin_K", "T\\_kin [K]", 1}, Case{"velocity_m_s", "velocity [m/s]", 1},
        Case{"x_m", "x [nm]", 1e9}, Case{"P", "P", 1}}) {
    EXPECT_EQ(axis_of(column).label, label);
    EXPECT_EQ(axis_of(column).factor, factor);
    ++ran;
  }
  EXPECT_EQ(ran, 6);
  EXPECT_EQ(thinned({1, 2, 3}, 5), (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(thinned({1, 3, 5, 7, 9}, 3), (std::vector<double>{2, 6, 9}));
}

TEST(NumberText, TheErrorSetsTheDigits) {
  EXPECT_EQ(with_error_text({0.68139, 0.00031, 9}), "0.68139 ± 0.00031");
  EXPECT_EQ(with_error_text({1150.04, 12.3, 9}), "1150 ± 12");
  EXPECT_EQ(with_error_text({6.8139e8, 3.1e5, 9}), "(6.8139 ± 0.0031)e8");
  EXPECT_EQ(with_error_text({-2.6e-7, 1.2e-8, 9}), "(-2.60 ± 0.12)e-7");
  EXPECT_EQ(with_error_text({3, 0, 9}), "3");
}

TEST(Summary, UncertainQuantitiesHaveATwinAndNaNsAreRefused) {
  tests::ScratchDirectory const scratch;
  Json summary;
  put(summary, "P_Pa", {6.8e8, 1e5, 100});
  write_summary(scratch / "summary.json", summary);
  auto const read = Json::parse(read_text_file(scratch / "summary.json"));
  EXPECT_EQ(read["P_Pa"], 6.8e8);
  EXPECT_EQ(read["P_Pa_se"], 1e5);
  put(summary, "T_K", {std::numeric_limits<double>::infinity(), 1, 1});
  try {
    write_summary(scratch / "bad.json", summary);
    ADD_FAILURE() << "an infinity was written";
  } catch (PhysicsError const& error) {
    EXPECT_NE(std::string(error.what()).find("'T_K'"), std::string::npos);
  }
  EXPECT_FALSE(std::filesystem::exists(scratch / "bad.json"));
}

} // namespace

} // namespace mesobridge::workflows
