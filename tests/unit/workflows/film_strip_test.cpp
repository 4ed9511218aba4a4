#include "scratch_directory.hpp"
#include "workflows/report/colour_scale.hpp"
#include "workflows/report/film_strip.hpp"
#include "workflows/text_file.hpp"
#include <gtest/gtest.h>
#include <regex>

namespace mesobridge::workflows {
namespace {

FilmStrip two_frames() {
  FilmStrip strip{.name = "film",
                  .title = "T of <some> particles",
                  .x_label = "z [nm]",
                  .y_label = "x [nm]",
                  .value_label = "T [K]",
                  .x_from = 0,
                  .x_to = 10,
                  .y_from = 0,
                  .y_to = 2,
                  .value_from = 300,
                  .value_to = 900,
                  .point_size = 0.2,
                  .frames = {}};
  strip.frames.push_back({"t = 0 ps", {1, 5, 9, 20}, {1, 1, 1, 1}, {300, 600, 1000, 600}});
  strip.frames.push_back({"t = 3 ps", {2}, {0.5}, {200}});
  return strip;
}

int count(std::string const& text, std::string const& pattern) {
  std::regex const of(pattern);
  return static_cast<int>(std::distance(std::sregex_iterator(text.begin(), text.end(), of), {}));
}

TEST(FilmStrip, ShowsThePointsOfEachFrameOnceWithTitlesAndAScale) {
  auto const svg = draw_svg(two_frames());
  EXPECT_EQ(count(svg, "M[0-9.]+ [0-9.]+h0"), 4); // one lies outside
  for (auto const* text :
       {"t = 0 ps", "t = 3 ps", "&lt;some&gt;", ">z [nm]<", ">x [nm]<", ">T [K]<", ">300<", ">900<"})
    EXPECT_NE(svg.find(text), std::string::npos) << text;
  EXPECT_EQ(count(svg, "stroke='#8c959f'"), 2);
  EXPECT_TRUE(svg.starts_with("<svg") && svg.ends_with("</svg>\n"));
}

TEST(FilmStrip, ColoursByTheScaleAndBeyondItByItsEnds) {
  EXPECT_EQ(scale_colour(-1), "#440154");
  EXPECT_EQ(scale_colour(0.5), "#21918c");
  EXPECT_EQ(scale_colour(2), "#fde725");
  EXPECT_EQ(scale_colour(0.125), "#402a70"); // half way between the first two
  EXPECT_EQ(gnuplot_scale(), "defined (0 '#440154', 1 '#3b528b', 2 '#21918c', 3 '#5ec962', 4 '#fde725')");
}

TEST(FilmStrip, PutsPointsWhereTheyAre) {
  auto strip = two_frames();
  strip.frames = {{"t", {0, 10}, {0, 2}, {300, 900}}};
  std::regex const dot("M([0-9.]+) ([0-9.]+)h0");
  auto const svg = draw_svg(strip);
  std::vector<std::pair<double, double>> found;
  for (std::sregex_iterator it(svg.begin(), svg.end(), dot), end; it != end; ++it)
    found.emplace_back(std::stod((*it)[1]), std::stod((*it)[2]));
  ASSERT_EQ(found.size(), 2U);
  EXPECT_LT(found[0].first, found[1].first - 400);  // from left to right
  EXPECT_GT(found[0].second, found[1].second + 30); // upwards
}

TEST(FilmStrip, WritesAPng) {
  tests::ScratchDirectory const scratch;
  auto const file = scratch / "it's a frame.png";
  draw_png(two_frames(), 0, file.string());
  EXPECT_EQ(read_text_file(file).substr(1, 3), "PNG");
}

TEST(FilmStrip, RefusesFramesThatDoNotBelongTogether) {
  auto strip = two_frames();
  strip.frames[0].x.pop_back();
  EXPECT_THROW(draw_svg(strip), std::logic_error);
  strip.frames.clear();
  EXPECT_THROW(draw_svg(strip), std::logic_error);
}

} // namespace
} // namespace mesobridge::workflows
