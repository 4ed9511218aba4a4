#include "md/error.hpp"
#include "scratch_directory.hpp"
#include "workflows/sdpd/histogram_series.hpp"
#include <cmath>
#include <gtest/gtest.h>

namespace mesobridge::workflows {
namespace {

/// What a histogram of these temperatures ends with, and the width of its bins.
std::pair<std::string, double> of_temperatures(std::vector<double> const& T) {
  tests::ScratchDirectory const scratch;
  Store store(scratch / "run.h5", Store::Mode::create);
  Scene scene;
  scene.histogram = {.bins = 50, .every = 1, .reach = 8, .quantities = {"T"}};
  OutputUnits const units({100, 6.6e-26, 1150, 500, 1.380649e-23}, UnitSystem::SI);
  HistogramSeries series(store, scene, units);
  sdpd::Snapshot now;
  now.T = T;
  try {
    series.append(now, 0, 0);
  } catch (PhysicsError const& error) {
    return {error.what(), 0};
  }
  auto const edges = store.read_doubles("histogram/T_K/edges");
  for (std::size_t b = 1; b < edges.size(); ++b)
    EXPECT_LT(edges[b - 1], edges[b]);
  return {"", edges[1] - edges[0]};
}

// Bins that round-off alone keeps apart have no densities that can be drawn.
TEST(HistogramSeries, RefusesParticlesThatAreAlikeButForRoundOff) {
  for (double const apart : {0.0, 2e-16, 1e-15, 1e-13}) {
    auto const [error, width] = of_temperatures({1, 1 + apart, 1, 1, 1 - apart, 1});
    EXPECT_TRUE(error.starts_with("histogram.quantities = T_K: all particles have the value 500")) << apart;
  }
  auto const [error, width] = of_temperatures({1, 1.001, 1, 1, 0.999, 1});
  EXPECT_EQ(error, "");
  EXPECT_NEAR(width, 500 * 16 * std::sqrt(2e-6 / 5) / 50, 1e-9); // 16 standard deviations
}

} // namespace
} // namespace mesobridge::workflows
