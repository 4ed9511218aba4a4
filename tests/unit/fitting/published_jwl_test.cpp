#include "fitting/published_jwl.hpp"
#include "md/error.hpp"
#include <gtest/gtest.h>

namespace mesobridge::fitting::test {
namespace {

constexpr double GPa = 1e9;

/// As Dobratz and Crawford print them (LLNL Explosives Handbook, 1985), to three or four digits.
constexpr PublishedJwl comp_b{.A = 524.2 * GPa,
                              .B = 7.678 * GPa,
                              .R_1 = 4.2,
                              .R_2 = 1.1,
                              .omega = 0.34,
                              .rho_0 = 1717,
                              .E_0 = 8.5 * GPa,
                              .D = 7980,
                              .P_CJ = 29.5 * GPa,
                              .C = 1.082 * GPa};
constexpr PublishedJwl tnt{.A = 371.2 * GPa,
                           .B = 3.231 * GPa,
                           .R_1 = 4.15,
                           .R_2 = 0.95,
                           .omega = 0.30,
                           .rho_0 = 1630,
                           .E_0 = 7.0 * GPa,
                           .D = 6930,
                           .P_CJ = 21 * GPa,
                           .C = 1.045 * GPa};

TEST(PublishedJwl, ItsNumbersAgreeToTheDigitsOfTheHandbook) {
  for (auto const& set : {comp_b, tnt}) {
    auto const implied = implied_by(set);
    EXPECT_NEAR(implied.C / *set.C, 1, 4e-3);
    EXPECT_NEAR(implied.E_0 / set.E_0, 1, 2e-3);
    EXPECT_NEAR(implied.D_of_slope / set.D, 1, 2e-4);
  }
}

TEST(PublishedJwl, AWrongDigitIsSeen) {
  auto set = comp_b;
  set.B *= 1.2;
  auto const implied = implied_by(set);
  EXPECT_GT(std::abs(implied.C / *set.C - 1), 0.1);
  EXPECT_GT(std::abs(implied.E_0 / set.E_0 - 1), 0.02);
}

TEST(PublishedJwl, RefusesWhatIsNoDetonation) {
  auto set = comp_b;
  set.P_CJ = 200 * GPa; // rho_0 D^2 is 109
  EXPECT_THROW(implied_by(set), InputError);
  set = comp_b, set.omega = 0;
  EXPECT_THROW(implied_by(set), InputError);
  set = comp_b, set.A = std::nan("");
  EXPECT_THROW(implied_by(set), InputError);
}

} // namespace
} // namespace mesobridge::fitting::test
