#include "fitting/root.hpp"
#include <gtest/gtest.h>

namespace mesobridge::fitting::test {
namespace {

TEST(BracketedZero, IsExactToRoundOffInFewEvaluations) {
  struct Case {
    double (*f)(double);
    double a, b, zero;
  };
  Case const cases[] = {
      {[](double x) { return std::cos(x) - x; }, 0, 1, 0.7390851332151607},
      {[](double x) { return x * x * x - 2; }, 0, 100, std::cbrt(2.0)},
      {[](double x) { return std::exp(x) - 1e-8; }, -50, 50, std::log(1e-8)},
      {[](double x) { return 1 / x - 1e7; }, 1, 1e-9, 1e-7},
      {[](double x) { return x < 0.3 ? -1.0 : 1.0; }, 0, 1, 0.3},
      {[](double x) { return std::pow(x - 1, 9); }, 0, 3, 1},
  };
  int ran = 0;
  for (auto const& c : cases) {
    int evaluations = 0;
    auto const counted = [&](double x) {
      ++evaluations;
      return c.f(x);
    };
    EXPECT_NEAR(bracketed_zero(counted, c.a, c.b) / c.zero, 1, 1e-15) << ran;
    EXPECT_LT(evaluations, 130) << ran;
    ++ran;
  }
  EXPECT_EQ(ran, 6);
  EXPECT_THROW(bracketed_zero([](double x) { return x; }, 1.0, 2.0), std::logic_error);
}

TEST(FirstRisingZero, FindsTheFirstOneAndTheEdgeOfTheModel) {
  auto const wave = [](double x) { return -std::cos(x); };
  EXPECT_NEAR(*first_rising_zero(wave, 0.1, 100, 1.1), std::acos(-1) / 2, 1e-15);
  EXPECT_NEAR(*first_rising_zero(wave, 20.0, 0.1, 1.1), 5.5 * std::acos(-1), 1e-14); // downwards
  EXPECT_FALSE(first_rising_zero([](double) { return 1.0; }, 0.1, 100, 1.1));
  // The model ends at 5: a zero just below is found, one beyond is not.
  auto const ending = [](double zero) {
    return [zero](double x) { return x > 5 ? throw PhysicsError("outside") : x - zero; };
  };
  EXPECT_NEAR(*first_rising_zero(ending(4.9999), 0.1, 100, 1.5), 4.9999, 1e-14);
  EXPECT_FALSE(first_rising_zero(ending(5.0001), 0.1, 100, 1.5));
  // The last step ends at the last point.
  EXPECT_NEAR(*first_rising_zero([](double x) { return x - 99; }, 0.1, 100, 7), 99, 1e-13);
  EXPECT_FALSE(first_rising_zero([](double x) { return x - 101; }, 0.1, 100, 7));
  // The model begins at 2.
  auto const beginning = [](double x) { return x < 2 ? throw PhysicsError("outside") : x - 3; };
  EXPECT_NEAR(*first_rising_zero(beginning, 0.1, 100, 1.1), 3, 1e-15);
}

} // namespace
} // namespace mesobridge::fitting::test
