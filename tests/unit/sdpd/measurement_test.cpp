#include "pair_fluid_fixtures.hpp"
#include "sdpd/observe/list.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <set>

// What is asked of every measurement, whoever adds one.

namespace mesobridge::sdpd {
namespace {

auto const cases = one_fluid_of_each_method();

TEST(Measurements, HaveNamesOfTheirOwn) {
  std::set<std::string> names;
  for (auto const& measured : measurements())
    for (auto const component : measured.components)
      EXPECT_TRUE(names.insert(std::string(measured.name) + std::string(component)).second) << measured.name;
  EXPECT_GE(names.size(), 13u);
}

TEST(Measurements, HaveANumberForEachComponentThatThreadsDoNotChange) {
  int asked = 0, of_every_run = 0;
  for (auto const& [name, settings] : cases) {
    auto two = settings;
    two.threads = 2;
    Simulation a(settings), b(two);
    a.advance(10), b.advance(10);
    for (auto const& measured : measurements()) {
      if (!measured.exists(settings.features()))
        continue;
      auto const values = a.measure(measured);
      EXPECT_EQ(values.size(), measured.components.size()) << name << ", " << measured.name;
      for (double const value : values)
        EXPECT_TRUE(std::isfinite(value)) << name << ", " << measured.name;
      EXPECT_EQ(values, b.measure(measured)) << name << ", " << measured.name;
      if (measured.expected) {
        EXPECT_EQ(measured.expected({}).size(), values.size()) << measured.name;
      }
      (measured.in_every_run() ? of_every_run : asked) += 1;
    }
  }
  EXPECT_EQ(of_every_run, 8 + 10 + 8 + 6); // of SDPD, DPDE, DPD
  EXPECT_GE(asked, 4);
}

} // namespace
} // namespace mesobridge::sdpd
