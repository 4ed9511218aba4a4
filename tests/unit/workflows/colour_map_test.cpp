#include "md/error.hpp"
#include "workflows/report/colour_map.hpp"
#include <gtest/gtest.h>
#include <limits>

namespace mesobridge::workflows {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

ColourMap small() {
  return {.name = "small",
          .title = "A small map",
          .x_label = "z [nm]",
          .y_label = "time [ps]",
          .colour_label = "P [GPa]",
          .x = {1, 2, 3},
          .y = {0, 1},
          .values = {{1, nothing, 3}, {2, 4, 8}}};
}

TEST(ColourMap, IsOneDrawingWithItsLabelsAndADescription) {
  auto const svg = draw_svg(small());
  EXPECT_TRUE(svg.starts_with("<svg"));
  for (auto const* part :
       {"role=\"img\"", "A small map: P [GPa] over z [nm] and time [ps]", "data:image/png;base64"})
    EXPECT_NE(svg.find(part), std::string::npos) << part;
}

TEST(ColourMap, RefusesWhatCannotBeDrawn) {
  auto ragged = small(), short_of_rows = small(), empty = small();
  ragged.values[1].pop_back();
  short_of_rows.y.push_back(2);
  empty.values = {{nothing, nothing, nothing}, {nothing, nothing, nothing}};
  EXPECT_THROW(draw_svg(ragged), std::logic_error);
  EXPECT_THROW(draw_svg(short_of_rows), std::logic_error);
  EXPECT_THROW(draw_svg(empty), PhysicsError);
}

} // namespace
} // namespace mesobridge::workflows
