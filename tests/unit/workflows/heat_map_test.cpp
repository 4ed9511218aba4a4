#include "workflows/report/heat_map.hpp"
#include <gtest/gtest.h>
#include <regex>
#include <stdexcept>

namespace mesobridge::workflows {
namespace {

/// Two columns, three rows; one cell without a value, one beyond the top.
HeatMap small_map() {
  return {.title = "error of <P> & K",
          .x_label = "K",
          .y_label = "U",
          .value_label = "relative error",
          .x = {1, 2},
          .y = {10, 20, 30},
          .value = {0.0, 0.5, 1.0, std::nullopt, 7.0, 0.25},
          .top = 1};
}

std::vector<std::string> fills(std::string const& svg) {
  std::vector<std::string> result;
  std::regex const fill("<rect x='([0-9.]+)' y='([0-9.]+)' width='[0-9.]+' height='[0-9.]+' fill='([^']+)'");
  for (std::sregex_iterator i(svg.begin(), svg.end(), fill), end; i != end; ++i)
    result.push_back((*i)[3]);
  return result;
}

TEST(HeatMap, EveryCellHasTheColourOfItsValue) {
  auto const colours = fills(draw_svg(small_map()));
  ASSERT_GT(colours.size(), 7u) << "the cells, the frame, the scale";
  EXPECT_EQ(colours[0], "#ffffff") << "0 is white";
  EXPECT_EQ(colours[1], "#0072b2") << "the middle is the palette's blue";
  EXPECT_EQ(colours[2], "#00142e");
  EXPECT_EQ(colours[3], "#c8ccd0") << "no value is grey";
  EXPECT_EQ(colours[4], colours[2]) << "more than the top has the darkest colour";
  EXPECT_NE(colours[5], colours[0]);
}

TEST(HeatMap, LaterRowsLieHigher) {
  auto const svg = draw_svg(small_map());
  std::regex const place("<rect x='([0-9.]+)' y='([0-9.]+)'");
  std::vector<std::pair<double, double>> at;
  for (std::sregex_iterator i(svg.begin(), svg.end(), place), end; i != end && at.size() < 6; ++i)
    at.emplace_back(std::stod((*i)[1]), std::stod((*i)[2]));
  ASSERT_EQ(at.size(), 6u);
  EXPECT_GT(at[0].second, at[1].second);
  EXPECT_GT(at[1].second, at[2].second);
  EXPECT_LT(at[0].first, at[3].first);
  EXPECT_EQ(at[0].second, at[3].second);
}

TEST(HeatMap, TextsAreThereAndEscaped) {
  auto const svg = draw_svg(small_map());
  int texts = 0;
  for (char const* text :
       {">error of &lt;P&gt; &amp; K<", ">K<", ">U<", ">relative error<", ">10<", ">30<", ">2<"}) {
    EXPECT_NE(svg.find(text), std::string::npos) << text;
    ++texts;
  }
  EXPECT_EQ(texts, 7);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
}

TEST(HeatMap, UnequalLengthsAreRefused) {
  auto map = small_map();
  map.value.pop_back();
  EXPECT_THROW(draw_svg(map), std::logic_error);
}

} // namespace
} // namespace mesobridge::workflows
