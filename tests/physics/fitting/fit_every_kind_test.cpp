#include "fitting/fit_family.hpp"
#include "unit/fitting/random_states.hpp"
#include "unit/fitting/synthetic_eos_data.hpp"
#include <gtest/gtest.h>

// Every model that describes itself with parameters to fit, whatever it is.

namespace mesobridge::fitting::test {
namespace {

/// Dense warm states of a material, each with its pressure and energy to 1 %.
template <class Model>
std::vector<Observation> measured(Model const& truth, std::uint64_t seed) {
  Laboratory<Model> laboratory(truth, seed);
  double const rho = typical_density(truth), densest = std::min(1.6 * rho, 0.9 * truth.rho_max());
  laboratory.measure_states(spaced(1.05 * rho, densest, 8), spaced(1000, 5000, 6),
                            {Quantity::P, Quantity::e});
  return laboratory.data;
}

TEST(FitEveryKind, FindsTheParametersWithinTheirErrorsAndSeesAWrongOne) {
  constexpr int repeats = 8;
  std::size_t kinds = 0;
  for_each_described_model([&]<class Model>() {
    auto const& description = Model::description();
    if (!description.fittable())
      return;
    SCOPED_TRACE(description.kind);
    Model const truth(description.materials.front().parameters);
    int compared = 0, within_2 = 0;
    double chi_2 = 0, degrees = 0, chi_2_wrong = 0;
    for (int repeat = 0; repeat < repeats; ++repeat) {
      auto const data = measured(truth, 100 + repeat);
      EosFitOptions options{.from = truth, .search = {.global_evaluations = 0}};
      auto const fit = fit_eos(family_of<Model>(data), data, options);
      auto const values = fit.family.values_of(truth);
      for (auto const i : fit.outcome.free) {
        double const value = i < values.size() ? values[i] : 0; // the zero of the energies
        double const off = std::abs(fit.outcome.values[i] - value);
        EXPECT_LT(off, 5 * fit.outcome.se(i)) << fit.outcome.parameters[static_cast<std::size_t>(i)].name;
        within_2 += off < 2 * fit.outcome.se(i);
        ++compared;
      }
      chi_2 += fit.outcome.chi_2();
      degrees += fit.outcome.degrees_of_freedom();
      options.fixed = {{"c_v", 1.1 * truth.c_v()}};
      chi_2_wrong += fit_eos(family_of<Model>(data), data, options).outcome.chi_2();
    }
    EXPECT_GE(compared, 3 * repeats);
    EXPECT_GE(within_2, 0.85 * compared);
    EXPECT_NEAR(chi_2 / degrees, 1, 4 * std::sqrt(2 / degrees));
    EXPECT_GT(chi_2_wrong / degrees, 1 + 8 * std::sqrt(2 / degrees));
    ++kinds;
  });
  EXPECT_EQ(kinds, fittable_kinds().size());
  EXPECT_GE(kinds, 3u);
}

} // namespace
} // namespace mesobridge::fitting::test
