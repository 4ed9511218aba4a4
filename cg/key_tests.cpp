#include "cg/key_tests.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <stdexcept>

namespace mesobridge::cg {
namespace {

KeyTest test_of(std::string name, Estimate const& found, double expected, std::string statement) {
  return {.name = std::move(name),
          .deviation = {found.mean - expected, found.se, found.n_eff},
          .in_se = deviation(found, expected),
          .statement = std::move(statement)};
}

/// The bin of a profile that is farthest from 0 in standard errors, among those from x_low on.
KeyTest worst_bin(std::string name, Profile const& profile, double x_low, double expected,
                  std::string const& axis) {
  KeyTest worst{.name = std::move(name), .deviation = {}, .in_se = 0, .statement = ""};
  std::size_t bins = 0, beyond_3 = 0;
  double chi_2 = 0;
  for (std::size_t k = 0; k < profile.x.size(); ++k) {
    auto const& y = profile.y[k];
    if (profile.x[k] < x_low || !(y.se > 0))
      continue;
    double const z = (y.mean - expected) / y.se;
    ++bins, beyond_3 += std::abs(z) > 3, chi_2 += z * z;
    if (std::abs(z) > std::abs(worst.in_se)) {
      worst.deviation = {y.mean - expected, y.se, y.n_eff};
      worst.in_se = z;
      worst.statement = fmt::format("the farthest bin is at {} = {:.3g}", axis, profile.x[k]);
    }
  }
  worst.statement += fmt::format("; {} of {} bins are off by more than 3 standard errors, chi^2 a bin {:.2f}",
                                 beyond_3, bins, bins ? chi_2 / double(bins) : 0.0);
  return worst;
}

} // namespace

std::vector<KeyTest> key_tests(Correlations const& c) {
  std::vector<KeyTest> tests;
  tests.push_back(test_of("P_x is Maxwellian", c.kurtosis, 0, "excess of <P^4>/(3 <P^2>^2) over 1"));
  tests.push_back(test_of("C_KU = 0", c.C_KU, c.C_KU_expected,
                          fmt::format("the fixed total energy alone makes {:.1e}", c.C_KU_expected)));
  double const excess =
      std::max(0.0, c.map.typical * c.map.typical - c.map.typical_from_noise * c.map.typical_from_noise);
  double const blocks = double(c.blocks);
  tests.push_back({.name = "P(K,U) = P(K)P(U)",
                   .deviation = {std::sqrt(excess), c.map.typical_from_noise, blocks},
                   .in_se = c.map.typical_from_noise > 0 ? std::sqrt(excess) / c.map.typical_from_noise : 0,
                   .statement = fmt::format("typical relative error {:.3g}, of which noise makes {:.3g}",
                                            c.map.typical, c.map.typical_from_noise)});
  auto const& w = c.configurational;
  std::string const nearer = fmt::format("pairs nearer than {:.3g}", c.contact);
  tests.push_back(worst_bin("u(r) = g(r) beyond contact", c.pair_energy, c.contact, 1, "r"));
  tests.push_back(worst_bin("u(r) = g(r) beyond contact, configurational", w.pair_energy, c.contact, 1, "r"));
  tests.push_back(test_of("<U1 U2>^r = <U>^2 at contact", c.contact_energy, 1, nearer));
  tests.push_back(test_of("<U1 U2>^r = <U>^2 at contact, configurational", w.contact_energy, 1, nearer));
  tests.push_back(test_of("C_UD = 0", c.C_UD, 0, "intrinsic energy against local density"));
  tests.push_back(test_of("C_UD = 0, configurational", w.C_UD, 0, "the same with less noise"));
  tests.push_back(worst_bin("<U>^rho = <U>", c.U_of_density, -1, 0, "rho"));
  tests.push_back(worst_bin("<U>^rho = <U>, configurational", w.U_of_density, -1, 0, "rho"));
  return tests;
}

KeyTest const& Correlations::test(std::string const& name) const {
  auto const found = std::find_if(tests.begin(), tests.end(), [&](auto const& t) { return t.name == name; });
  if (found == tests.end())
    throw std::logic_error(fmt::format("there is no test '{}' of the key approximation", name));
  return *found;
}

} // namespace mesobridge::cg
