#include "unit/fitting/synthetic_eos_data.hpp"
#include <gtest/gtest.h>

namespace mesobridge::fitting::test {
namespace {

using enum Quantity;

/// How often the truth lies within two standard errors of the fits to independent noisy data.
struct Coverage {
  std::vector<std::string> names;
  std::vector<int> hits;
  int repeats = 0, all = 0, unconverged = 0, undetermined = 0;
  double chi_2 = 0, degrees = 0;

  void add(EosFit const& fit, Eigen::VectorXd const& truth) {
    auto const& outcome = fit.outcome;
    if (names.empty())
      for (auto const i : outcome.free)
        names.push_back(outcome.parameters[static_cast<std::size_t>(i)].name);
    hits.resize(names.size());
    for (std::size_t k = 0; k < names.size(); ++k) {
      auto const i = outcome.free[k];
      double const value = i < truth.size() ? truth[i] : 0; // the energy offset
      bool const hit = std::abs(outcome.values[i] - value) < 2 * outcome.se(i);
      hits[k] += hit;
      all += hit;
    }
    ++repeats;
    chi_2 += outcome.chi_2();
    degrees += outcome.degrees_of_freedom();
    unconverged += !outcome.converged;
    undetermined += !outcome.undetermined().empty();
  }

  void print(char const* title) const {
    std::printf("%s: %d repeats, chi^2/dof %.3f, %d unconverged, %d undetermined; within 2 se:", title,
                repeats, chi_2 / degrees, unconverged, undetermined);
    for (std::size_t k = 0; k < names.size(); ++k)
      std::printf(" %s %d", names[k].c_str(), hits[k]);
    std::printf("; overall %.1f %%\n", 100.0 * all / (repeats * static_cast<double>(names.size())));
  }
};

void expect_honest(Coverage const& coverage, int repeats) {
  EXPECT_EQ(coverage.repeats, repeats);
  EXPECT_EQ(coverage.unconverged, 0);
  EXPECT_EQ(coverage.undetermined, 0);
  for (std::size_t k = 0; k < coverage.names.size(); ++k)
    EXPECT_GE(coverage.hits[k], 0.9 * repeats) << coverage.names[k];
  EXPECT_NEAR(coverage.chi_2 / coverage.degrees, 1, 4 * std::sqrt(2 / coverage.degrees));
}

/// Repeats the experiment `measure(laboratory)` and the fit.
template <LinearModel Model, class Measure>
Coverage covered(Model const& truth, EosFamily (*family)(std::span<Observation const>), EosFitOptions options,
                 int repeats, Measure&& measure) {
  Coverage coverage;
  options.from = truth;
  for (int repeat = 0; repeat < repeats; ++repeat) {
    Laboratory<Model> laboratory(truth, 1000 + repeat);
    measure(laboratory);
    auto const fit = fit_eos(family(laboratory.data), laboratory.data, options);
    coverage.add(fit, fit.family.values_of(truth));
  }
  return coverage;
}

TEST(FitEos, RecoversMieGruneisenWithHonestErrors) {
  auto const coverage =
      covered(MieGruneisen(tin_parameters), mie_gruneisen_family, {.search = {.global_evaluations = 0}}, 100,
              [](auto& laboratory) {
                laboratory.measure_states(spaced(7500, 12000, 6), spaced(300, 6000, 5), {P, e});
                laboratory.measure_shocks(7290, 300, spaced(300, 4000, 10), {v_S, T});
              });
  coverage.print("Mie-Gruneisen");
  expect_honest(coverage, 100);
}

TEST(FitEos, RecoversHzWithHonestErrors) {
  auto const coverage =
      covered(Hz(nitromethane_parameters), hz_family, {.search = {.global_evaluations = 0}}, 100,
              [](auto& laboratory) {
                laboratory.measure_states(spaced(1150, 2000, 6), spaced(300, 2500, 5), {P, e});
                laboratory.measure_shocks(1125, 300, spaced(300, 3000, 10), {v_S, T});
              });
  coverage.print("HZ");
  expect_honest(coverage, 100);
}

TEST(FitEos, RecoversJwlWithHonestErrors) {
  Jwl const truth(nitromethane_products_parameters);
  auto const coverage =
      covered(truth, jwl_family, {.search = {.global_evaluations = 0}}, 100, [](auto& laboratory) {
        laboratory.measure_states(spaced(300, 2400, 8), spaced(1500, 6000, 4), {P, e});
        for (double const rho : spaced(1400, 50, 20))
          laboratory.measure({.path = DataPath::isentrope,
                              .start = StartState{.rho = 1568.81, .P = 1.25e10},
                              .given = {{Quantity::rho, rho}}},
                             {P});
        laboratory.measure({.path = DataPath::cj, .start = StartState{.rho = 1128, .e = 0.0, .P = 0.0}},
                           {v_S, rho, P, T});
      });
  coverage.print("JWL");
  expect_honest(coverage, 100);
}

} // namespace
} // namespace mesobridge::fitting::test
