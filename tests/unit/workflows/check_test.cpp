#include "fitting/eos/evaluate.hpp"
#include "workflows/lj_to_sdpd/checks.hpp"
#include "workflows/report/check.hpp"
#include <gtest/gtest.h>
#include <random>

namespace mesobridge::workflows {
namespace {

Comparison comparison(double found, double se, double expected, double reference_se = 0) {
  return {"x", {found, se, 9}, {expected, reference_se, 0}};
}

TEST(Check, DeviationIsInTheCombinedError) {
  EXPECT_NEAR(deviation(comparison(1.5, 0.3, 1, 0.4)), 1, 1e-12);
  EXPECT_NEAR(deviation(comparison(0.5, 0.3, 1)), -0.5 / 0.3, 1e-12);
  EXPECT_EQ(deviation(comparison(1, 0, 1)), 0);
}

// Quantiles of the normal law: P(|z| > 3.2905) = 0.001; of 50, each 1 - 0.999^(1/50) = 2.001e-5: 4.2647.
TEST(Check, AllowsWhatRightValuesExceedOnceInAThousandReports) {
  EXPECT_NEAR(allowed_deviation(1), 3.2905, 1e-4);
  EXPECT_NEAR(allowed_deviation(50), 4.2647, 2e-3);
  std::mt19937_64 generator(5);
  std::normal_distribution<double> normal;
  int alarms = 0;
  constexpr int reports = 200000;
  for (int k = 0; k < reports; ++k) {
    double farthest = 0;
    for (int i = 0; i < 10; ++i)
      farthest = std::max(farthest, std::abs(normal(generator)));
    alarms += farthest > allowed_deviation(10);
  }
  EXPECT_NEAR(alarms, 1e-3 * reports, 5 * std::sqrt(1e-3 * reports));
}

TEST(Check, PassesWithinAndFailsBeyond) {
  EXPECT_EQ(check_line("a", {comparison(1.03, 0.01, 1)}).verdict, Verdict::passed);
  EXPECT_EQ(check_line("a", {comparison(1.04, 0.01, 1)}).verdict, Verdict::failed);
  EXPECT_EQ(check_line("a", {comparison(1.04, 0.01, 1, 0.01)}).verdict, Verdict::passed);
  EXPECT_EQ(check_line("a", {comparison(std::nan(""), 0.01, 1)}).verdict, Verdict::failed);
  EXPECT_EQ(check_line("a", {comparison(1, std::nan(""), 1)}).verdict, Verdict::failed);
  auto const line = check_line("two", {comparison(1, 0.1, 1), comparison(1.5, 0.1, 1)});
  EXPECT_EQ(line.verdict, Verdict::failed) << "one that is off is enough";
  EXPECT_NE(line.found.find("1.50"), std::string::npos) << "the farthest is shown";
  EXPECT_EQ(line.deviation, "+5.0 se (the farthest of 2); allowed 3.5");
  EXPECT_EQ(noted_line("a", {comparison(2, 0.01, 1)}).verdict, Verdict::noted);
  EXPECT_THROW(check_line("none", {}), std::logic_error);
}

/// Samples of 25 states with errors of 0.2 % in P and 0.1 % in U, from an equation of state times a factor.
std::vector<fitting::LjBwrFitPoint> sampled(std::string const& equation, double factor) {
  std::mt19937_64 generator(3);
  std::normal_distribution<double> normal;
  std::vector<fitting::LjBwrFitPoint> points;
  for (double const T : {2.75, 4.13, 6.2, 8.9, 14.0})
    for (double const rho : {0.45, 0.6, 0.75, 0.9, 1.05}) {
      fitting::LjBwrFitPoint p{};
      p.rho = rho, p.T = T;
      std::visit(
          [&](auto const& model) {
            auto const isochore = model.isochore(rho);
            p.U = isochore.energy(T), p.P = isochore.pressure(T);
          },
          fitting::material(equation).eos);
      p.U_se = 0.001 * std::max(std::abs(p.U), T), p.P_se = 0.002 * std::max(std::abs(p.P), rho * T);
      p.U = factor * p.U + p.U_se * normal(generator), p.P = factor * p.P + p.P_se * normal(generator);
      points.push_back(p);
    }
  return points;
}

TEST(ChainChecks, SamplesOfTheRightFluidAgreeAndOfAWrongOneDoNot) {
  auto verdict = [](std::string const& truth, double factor, std::string const& equation) {
    auto const points = sampled(truth, factor);
    return check_line("", data_against(points, equation, published_accuracy(points))).verdict;
  };
  EXPECT_EQ(verdict("lj-kn", 1, "lj-kn"), Verdict::passed);
  EXPECT_EQ(verdict("lj-kn", 1.01, "lj-kn"), Verdict::failed);
  EXPECT_EQ(verdict("lj-kn", 0.99, "lj-kn"), Verdict::failed);
  EXPECT_EQ(verdict("lj", 1, "lj-kn"), Verdict::failed) << "the energies of the 1993 set";
  auto const points = sampled("lj-kn", 1);
  EXPECT_EQ(data_against(points, "lj-kn", published_accuracy(points)).size(), 50u);
  EXPECT_EQ(data_against(points, "lj-thol", published_accuracy(points)).size(), 40u) << "valid up to T* = 9";
}

// Two equations that were fitted to different simulations; both claim some tenths of a per cent.
TEST(ChainChecks, PublishedEquationsAgreeToTenthsOfAPerCent) {
  auto const accuracy = published_accuracy(sampled("lj-kn", 1));
  EXPECT_GT(accuracy.P, 1e-4);
  EXPECT_LT(accuracy.P, 2e-3);
  EXPECT_GT(accuracy.U, 1e-4);
  EXPECT_LT(accuracy.U, 3e-3);
}

/// A run of argon whose pressure, density and temperatures are those of its equation of state times factors.
RunResult run_of_argon(double P, double rho, double T_kin, double T_int) {
  sdpd::Sdpd const argon{.eos = fitting::material("argon").eos, .K = 10};
  RunResult run{
      .scene = {}, .settings = {.method = argon, .rho = 1150, .T = 1000}, .equilibrium = {}, .summary = {}};
  double const P_eos = std::visit(
      [](auto const& eos) { return fitting::state_from_temperature(eos, 1150, 1000).P; }, argon.eos);
  auto& e = run.equilibrium;
  e.P = {P * P_eos / run.settings.units().pressure(), 1e-4 * P_eos / run.settings.units().pressure(), 100};
  e.rho.mean = {rho, 1e-4, 100};
  e.T_kin = {T_kin, 1e-3, 100}, e.T_int = {T_int, 1e-5, 100};
  return run;
}

TEST(ChainChecks, ARunFarFromItsEquationOfStateFails) {
  struct Case {
    double P, rho, T_kin, T_int;
    bool state, temperatures;
  };
  int ran = 0;
  for (auto const& [P, rho, T_kin, T_int, state, temperatures] :
       {Case{1, 1, 1, 1, true, true}, Case{0.9993, 1.0003, 0.998, 1.0001, true, true},
        Case{0.983, 1, 1, 1, false, true}, Case{1, 1.015, 1, 1, false, true},
        Case{1, 1, 0.99, 1, true, false}, Case{1, 1, 1, 1.005, true, false}}) {
    auto const run = run_of_argon(P, rho, T_kin, T_int);
    EXPECT_EQ(check_line("", state_of(run)).verdict == Verdict::passed, state) << P << ' ' << rho;
    EXPECT_EQ(check_line("", temperatures_of(run)).verdict == Verdict::passed, temperatures) << T_kin;
    ++ran;
  }
  EXPECT_EQ(ran, 6);
}

} // namespace
} // namespace mesobridge::workflows
