#include "pair_fluid_fixtures.hpp"
#include "sdpd/conservative/pair_forces.hpp"
#include "sdpd/make_system.hpp"
#include <gtest/gtest.h>

namespace mesobridge::sdpd {
namespace {

TabulatedPotential lj_table(bool with_force) {
  LennardJones const lj(1, 1, 2.5);
  std::vector<double> r, u, f;
  for (double x = 0.7; x < 2.5; x += 0.01) {
    auto const [energy, strength] = lj(x, 1 / x);
    r.push_back(x), u.push_back(energy), f.push_back(strength * x);
  }
  return with_force ? TabulatedPotential(r, u, f) : TabulatedPotential(r, u);
}

struct Case {
  char const* name;
  AnyPotential potential;
  double from; ///< smallest distance at which it is looked at
};

class EveryPotential : public ::testing::TestWithParam<Case> {};

TEST_P(EveryPotential, HasTheDerivativeOfItsEnergyAsForceAndEndsAtItsCutoff) {
  int looked_at = 0;
  std::visit(
      [&]<class P>(P const& u) {
        if constexpr (!std::is_same_v<P, NoPotential>) {
          double const h = 1e-6;
          for (double r = GetParam().from; r < u.cutoff() - h; r += 0.0137, ++looked_at) {
            double const slope = (u(r + h, 1 / (r + h)).energy - u(r - h, 1 / (r - h)).energy) / (2 * h);
            EXPECT_NEAR(-slope, u(r, 1 / r).strength * r, 1e-6 * (1 + std::abs(slope)));
          }
          EXPECT_NEAR(u(u.cutoff(), 1 / u.cutoff()).energy, 0, 1e-12);
        }
      },
      GetParam().potential);
  EXPECT_GT(looked_at, 20);
}

TEST_P(EveryPotential, IsTheSameInLanes) {
  int looked_at = 0;
  std::visit(
      [&]<class P>(P const& u) {
        if constexpr (!std::is_same_v<P, NoPotential>)
          for (double r = GetParam().from; r < u.cutoff(); r += 0.0137, ++looked_at) {
            auto const lanes = u(broadcast(r), broadcast(1 / r));
            auto const number = u(r, 1 / r);
            EXPECT_NEAR(lanes.energy[3], number.energy, 1e-13 * (1 + std::abs(number.energy)));
            EXPECT_NEAR(lanes.strength[5], number.strength, 1e-12 * (1 + std::abs(number.strength)));
          }
      },
      GetParam().potential);
  EXPECT_GT(looked_at, 20);
}

TEST_P(EveryPotential, IsTheSameInOtherUnits) {
  double const length = 3.7, energy = 0.21, r = GetParam().from + 0.1;
  std::visit(
      [&]<class P>(P const& u) {
        if constexpr (!std::is_same_v<P, NoPotential>) {
          auto const scaled = u.in_units(length, energy)(r / length, length / r), plain = u(r, 1 / r);
          EXPECT_NEAR(scaled.energy * energy, plain.energy, 1e-12 * (1 + std::abs(plain.energy)));
          EXPECT_NEAR(scaled.strength * energy / (length * length), plain.strength,
                      1e-12 * (1 + std::abs(plain.strength)));
        }
      },
      GetParam().potential);
}

/// A value of a potential's parameter that suits the others.
double usual(Parameter const& parameter) {
  if (!parameter.dimension)
    return parameter.range.min > 0 ? 2 * parameter.range.min : 1;
  return parameter.name == "cutoff" ? 2.5 : 1;
}

std::vector<double> usual_values(NamedPotential const& kind) {
  std::vector<double> values;
  for (auto const& parameter : kind.parameters)
    values.push_back(usual(parameter));
  return values;
}

/// Of the list, whatever is in it, and from tables.
std::vector<Case> const& cases() {
  static auto const all = [] {
    std::vector<Case> of{{"table", lj_table(false), 0.75}, {"table_with_force", lj_table(true), 0.75}};
    for (auto const& kind : potentials())
      if (kind.name != "none")
        of.push_back({kind.name.data(), kind.make(usual_values(kind)), 0.8});
    return of;
  }();
  return all;
}

std::string name_of(testing::TestParamInfo<Case> const& info) {
  std::string name = info.param.name;
  std::erase_if(name, [](unsigned char c) { return !std::isalnum(c) && c != '_'; });
  return name;
}

INSTANTIATE_TEST_SUITE_P(Potentials, EveryPotential, ::testing::ValuesIn(cases()), name_of);

TEST(PotentialKinds, RefuseWhatTheirParametersDoNotAllow) {
  int refused = 0;
  for (auto const& kind : potentials())
    for (std::size_t k = 0; k < kind.parameters.size(); ++k) {
      auto const& parameter = kind.parameters[k];
      auto const& range = parameter.range;
      for (double const wrong : {range.open ? range.min : range.min - 1, range.max * 1.01, std::nan("")}) {
        auto values = usual_values(kind);
        values[k] = wrong;
        try {
          kind.make(values);
          ADD_FAILURE() << kind.name << ", " << parameter.name << " = " << wrong;
        } catch (InputError const& error) {
          EXPECT_NE(std::string(error.what()).find(parameter.name), std::string::npos) << error.what();
          ++refused;
        }
      }
    }
  EXPECT_GE(refused, 33);
}

// Values on paper.
TEST(PairPotential, HasItsTextbookValues) {
  LennardJones const lj(2, 1.5, 6);
  double const minimum = std::pow(2.0, 1.0 / 6) * 1.5, shift = 8 * (std::pow(0.25, 12) - std::pow(0.25, 6));
  EXPECT_NEAR(lj(minimum, 1 / minimum).energy, -2 - shift, 1e-12);
  EXPECT_NEAR(lj(minimum, 1 / minimum).strength, 0, 1e-12);
  EXPECT_NEAR(LennardJones::wca(1, 1)(1.0, 1.0).energy, 1, 1e-12); // 4 (1 - 1) + epsilon
  EXPECT_NEAR(SoftPotential(25, 1)(0.4, 2.5).energy, 12.5 * 0.36, 1e-12);
  EXPECT_NEAR(SoftPotential(25, 1)(0.4, 2.5).strength * 0.4, 15, 1e-12);
  Exp6 const exp6(1, 1, 13, 10);
  EXPECT_NEAR(exp6(1.0, 1.0).energy, -1, 1e-4); // shifted by the little that is left at 10 r_m
  EXPECT_NEAR(exp6(1.0, 1.0).strength, 0, 1e-12);
  double const top = exp6.inner();
  EXPECT_NEAR(exp6(top, 1 / top).strength, 0, 1e-6);
  EXPECT_LT(exp6(top, 1 / top).strength, exp6(top + 0.01, 1 / (top + 0.01)).strength);
  EXPECT_GT(top, 0.1);
}

TEST(TabulatedPotential, IsItsOriginalBetweenThePoints) {
  LennardJones const lj(1, 1, 2.5);
  double worst_plain = 0, worst_hermite = 0;
  auto const plain = lj_table(false), hermite = lj_table(true);
  for (double r = 0.803; r < 2.4; r += 0.0071) {
    auto const exact = lj(r, 1 / r);
    double const shift = lj(plain.cutoff(), 1 / plain.cutoff()).energy, scale = 1 + std::abs(exact.strength);
    worst_plain = std::max(worst_plain, std::abs(plain(r, 1 / r).strength - exact.strength) / scale);
    worst_hermite = std::max(worst_hermite, std::abs(hermite(r, 1 / r).strength - exact.strength) / scale);
    EXPECT_NEAR(hermite(r, 1 / r).energy + shift, exact.energy, 1e-4 * scale);
  }
  EXPECT_LT(worst_plain, 1e-3);
  EXPECT_LT(worst_hermite, 1e-3);
  EXPECT_GT(worst_hermite, 1e-9); // it is a table
}

TEST(TabulatedPotential, RefusesAForceThatIsNotTheSlopeAndNamesTheRow) {
  LennardJones const lj(1, 1, 2.5);
  int refused = 0;
  for (double const spacing : {0.005, 0.01, 0.02})
    for (double const wrong : {-1.0, 0.5, 1.5}) {
      std::vector<double> r, u, f;
      for (double x = 0.8; x < 2.5; x += spacing) {
        auto const [energy, strength] = lj(x, 1 / x);
        r.push_back(x), u.push_back(energy), f.push_back(strength * x);
      }
      EXPECT_NO_THROW(TabulatedPotential(r, u, f)) << spacing;
      std::size_t const k = 3; // steep, so that the sign decides
      f[k] *= wrong;
      try {
        TabulatedPotential(r, u, f);
        ADD_FAILURE() << spacing << " " << wrong;
      } catch (InputError const& error) {
        EXPECT_NE(std::string(error.what()).find("row 4 "), std::string::npos) << error.what();
        ++refused;
      }
    }
  EXPECT_EQ(refused, 9);
}

TEST(TabulatedPotential, AcceptsCoarseRowsAndPrintedDigits) {
  LennardJones const lj(1, 1, 2.5);
  int accepted = 0;
  for (double const spacing : {0.001, 0.003, 0.01, 0.03, 0.06, 0.1, 0.15}) {
    std::vector<double> r, u, f;
    for (double x = 0.8; x < 2.5; x += spacing) {
      double const printed = std::stod(fmt::format("{:.6g}", x));
      auto const [energy, strength] = lj(printed, 1 / printed);
      r.push_back(printed), u.push_back(std::stod(fmt::format("{:.6g}", energy)));
      f.push_back(std::stod(fmt::format("{:.6g}", strength * printed)));
    }
    EXPECT_NO_THROW(TabulatedPotential(r, u, f)) << spacing;
    ++accepted;
  }
  EXPECT_EQ(accepted, 7);
}

TEST(TabulatedPotential, MayBeginAtZero) {
  std::vector<double> r, u, f;
  for (int k = 0; k <= 20; ++k) {
    double const x = 0.05 * k;
    r.push_back(x), u.push_back(12.5 * (1 - x) * (1 - x)), f.push_back(25 * (1 - x));
  }
  TabulatedPotential const table(r, u, f);
  EXPECT_EQ(table.inner(), 0);
  EXPECT_NEAR(table(0.02, 50.0).strength * 0.02, 24.5, 1e-9);
  EXPECT_THROW(TabulatedPotential({-0.1, 1, 2, 3}, {3, 2, 1, 0}), InputError);
}

TEST(TabulatedPotential, RefusesWhatIsNoTable) {
  EXPECT_THROW(TabulatedPotential({1, 2, 2, 3}, {3, 2, 1, 0}), InputError);
  EXPECT_THROW(TabulatedPotential({1, 2, 3}, {3, 2, 1}), InputError);
  EXPECT_THROW(TabulatedPotential({1, 2, 3, 4}, {3, std::nan(""), 1, 0}), InputError);
  EXPECT_THROW(Exp6(1, 1, 6.9, 3), InputError);
  EXPECT_THROW(Exp6(1, 1, 14, 0.1), InputError);
}

class PotentialInABox : public ::testing::TestWithParam<Case> {};

// Forces, energy and virial by cells, lists and lanes against a plain double loop with minimum images.
TEST_P(PotentialInABox, GivesWhatADirectDoubleLoopGives) {
  auto settings = dpd_fluid();
  settings.rho = 0.8, settings.lattice = {8, 8, 7}, settings.disorder = 0.05;
  settings.as<Dpd>().potential = GetParam().potential;
  settings.as<Dpd>().friction = PowerFriction(4.5, 0, 1, 2);
  auto const system = make_system(settings);
  auto const& particles = system->particles;
  std::size_t const n = particles.size();
  std::vector<Vec3> f(n);
  double energy = 0, virial = 0;
  std::size_t pairs = 0;
  std::visit(
      [&]<class P>(P const& u) {
        if constexpr (!std::is_same_v<P, NoPotential>)
          for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = 0; j < i; ++j) {
              Vec3 const r = system->box.minimum_image(particles.q[i] - particles.q[j]);
              if (norm(r) >= u.cutoff())
                continue;
              auto const pair = u(norm(r), 1 / norm(r));
              energy += pair.energy, virial += pair.strength * norm2(r), ++pairs;
              f[i] += pair.strength * r, f[j] -= pair.strength * r;
            }
      },
      GetParam().potential);
  EXPECT_GT(pairs, n);
  EXPECT_NEAR(system->potential_energy, energy, 1e-11 * (std::abs(energy) + 1));
  EXPECT_NEAR(system->virial, virial, 1e-11 * (std::abs(virial) + 1));
  double worst = 0, scale = 0;
  for (std::size_t i = 0; i < n; ++i)
    worst = std::max(worst, norm(particles.f[i] - f[i])), scale = std::max(scale, norm(f[i]));
  EXPECT_GT(scale, 0.1);
  EXPECT_LT(worst, 1e-11 * scale);
}

INSTANTIATE_TEST_SUITE_P(Potentials, PotentialInABox,
                         ::testing::Values(Case{"soft", SoftPotential(25, 1.6), 0},
                                           Case{"lj", LennardJones(1, 1, 2.5), 0},
                                           Case{"exp6", Exp6(1, 1.12, 14, 2.5), 0},
                                           Case{"table", lj_table(true), 0}),
                         [](auto const& info) { return info.param.name; });

TEST(PairForces, RefuseAPairInsideTheMaximumOfExp6) {
  auto settings = dpd_fluid();
  settings.rho = 0.5, settings.lattice = {8, 8, 8};
  settings.as<Dpd>().potential = Exp6(1, 1.12, 14, 2.5);
  auto const system = make_system(settings);
  system->particles.q[0] = system->particles.q[1] + Vec3{0.05, 0, 0};
  try {
    find_pair_forces(*system);
    FAIL();
  } catch (PhysicsError const& error) {
    EXPECT_NE(std::string(error.what()).find("where the pair potential ends"), std::string::npos);
  }
}

} // namespace
} // namespace mesobridge::sdpd
