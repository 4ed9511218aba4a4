#include "md/error.hpp"
#include "workflows/quantity.hpp"
#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace mesobridge::workflows {

namespace {

TEST(Quantity, ReadsUnitsIntoSI) {
  EXPECT_EQ(parse_quantity("500 m/s", Dimension::velocity), 500);
  EXPECT_EQ(parse_quantity("  1.15 g/cm^3 ", Dimension::density), 1150);
  EXPECT_EQ(parse_quantity("2e-3Pa*s", Dimension::viscosity), 2e-3);
  EXPECT_DOUBLE_EQ(parse_quantity("1.5 fs", Dimension::time), 1.5e-15);
  EXPECT_DOUBLE_EQ(parse_quantity("39.948 u", Dimension::mass), 39.948 * 1.66053906660e-27);
  EXPECT_EQ(parse_quantity("-3 K", Dimension::temperature), -3); // ranges are the keys' business
}

TEST(Quantity, RefusesWhatIsNone) {
  std::vector<std::pair<std::string, std::string>> const cases{
      {"500", "the unit is missing; allowed: m/s, km/s"},
      {"500 ms", "wrong unit 'ms'; allowed: m/s, km/s; did you mean 'm/s'?"},
      {"500 kg", "wrong unit 'kg'"},
      {"m/s", "not a finite number"},
      {"", "not a finite number"},
      {"nan m/s", "not a finite number"},
      {"inf m/s", "not a finite number"},
      {"1e999 m/s", "not a finite number"},
      {"1e307 km/s", "too large"},
      {"0x10 m/s", "wrong unit 'x10 m/s'"},
  };
  int ran = 0;
  for (auto const& [text, message] : cases) {
    try {
      parse_quantity(text, Dimension::velocity);
      ADD_FAILURE() << "'" << text << "' was taken";
    } catch (InputError const& error) {
      EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << error.what();
    }
    ++ran;
  }
  EXPECT_EQ(ran, 10);
}

TEST(Quantity, TextReadsBackExactly) {
  EXPECT_TRUE(rc::check("parse(text(x)) == x", [](double x) {
    RC_PRE(std::isfinite(x));
    RC_ASSERT(parse_quantity(quantity_text(x, Dimension::density), Dimension::density) == x);
  }));
}

} // namespace

} // namespace mesobridge::workflows
