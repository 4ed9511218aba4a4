#include "pair_fluid_fixtures.hpp"
#include "sdpd/conservative/conservative.hpp"
#include "sdpd/fluctuation/fluctuation.hpp"
#include "sdpd/make_system.hpp"
#include "sdpd/observe/canonical_energy.hpp"
#include "sdpd/scheme/list.hpp"
#include "sdpd/setup/calibrate_density.hpp"
#include "sdpd/state/species.hpp"
#include "sdpd/system/system.hpp"
#include "sdpd/system/total_energy.hpp"
#include "sdpd_fixtures.hpp"
#include <cstring>
#include <gtest/gtest.h>
#include <numeric>

namespace mesobridge::sdpd {
namespace {

SdpdSpecies sdpd_species(SimulationSettings const& s, double share, double K) {
  return {"of " + std::to_string(K), share, K, s.as<Sdpd>().eos};
}

DpdSpecies pair_species(Dpd const&, std::string const& name, double share, double mass) {
  return {name, share, mass};
}

DpdeSpecies pair_species(Dpde const& of, std::string const& name, double share, double mass) {
  return {name, share, mass, of.internal_energy};
}

template <class... F>
struct Overloaded : F... {
  using F::operator()...;
};

/// Every scheme with every fluid that it serves, also with conduction.
struct Case {
  std::string name;
  SimulationSettings settings;
};

std::vector<Case> cases() {
  std::vector<Case> all;
  auto conducting_dpde =
      with_pair_conduction(dpde_fluid(40, 0.01, 2), PowerFriction(20, 0, 1.3, 2)); // and friction across
  for (auto const& [fluid, settings] :
       {std::pair<std::string, SimulationSettings>{"ideal_gas", with_conduction(ideal_gas(320, 0.02), 0.5)},
        {"argon", argon(320, 0.02)},
        {"dpde", conducting_dpde},
        {"dpd", dpd_fluid()}})
    for (auto const& pairs : pair_integrators()) {
      if (refusal(pairs, settings.features()))
        continue;
      auto of = settings;
      of.scheme.pairs = pairs.name;
      of.disorder = 0.1;
      if (settings.features().densities)
        of.lattice = {8, 8, 8};
      auto name = fluid + "_" + pairs.name;
      std::ranges::replace(name, '-', '_');
      all.push_back({name, of});
    }
  return all;
}

/// The same fluid as one species of the mass 64 in units of the mass 1, which a power of two keeps exact.
SimulationSettings in_smaller_units(SimulationSettings s) {
  constexpr double mass = 64;
  bool const is_sdpd = s.features().densities;
  double const length = is_sdpd ? std::cbrt(mass) : 1, time = is_sdpd ? length : std::sqrt(mass);
  s.skin = skin_of(s) * length, s.dt *= time;
  std::visit(Overloaded{[&](Sdpd& of) {
                          of.K /= mass;
                          of.species = {sdpd_species(s, 1, mass * of.K)};
                        },
                        [](auto& of) {
                          of.species = {pair_species(of, "heavy", 1, of.mass)};
                          of.mass /= mass;
                        }},
             s.method);
  return s;
}

SimulationSettings with_twins(SimulationSettings s) {
  std::visit(Overloaded{[&](Sdpd& of) {
                          of.species = {sdpd_species(s, 0.5, of.K), sdpd_species(s, 0.5, of.K)};
                        },
                        [](auto& of) {
                          for (auto const* name : {"this", "that"})
                            of.species.push_back(pair_species(of, name, 0.5, of.mass));
                        }},
             s.method);
  return s;
}

class EverySpeciesCase : public ::testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(Schemes, EverySpeciesCase, ::testing::ValuesIn(cases()),
                         [](auto const& info) { return info.param.name; });

/// The largest difference of two runs' positions, velocities and energies, each in the second one's units.
double difference(Simulation const& a, Simulation const& b) {
  auto const x = a.snapshot(), y = b.snapshot();
  auto const &u = a.units(), &v = b.units();
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    double const m = x.mass_of(i);
    most = std::max(
        {most,
         norm(a.box().minimum_image(x.q[i] - y.q[i] * (v.length() / u.length()))) * (u.length() / v.length()),
         norm(x.p[i] / m * (u.velocity() / v.velocity()) - y.p[i] / y.mass_of(i))});
    if (!x.eps.empty())
      most = std::max({most, std::abs(x.eps[i] * (u.energy() / v.energy()) / y.eps[i] - 1)});
  }
  return most;
}

// Friction, noise, forces, densities, states, steps: every place where a mass belongs.
TEST_P(EverySpeciesCase, IsTheSameFluidInSmallerUnits) {
  auto const& settings = GetParam().settings;
  auto const smaller = in_smaller_units(settings);
  EXPECT_NEAR(smaller.units().mass() * 64, settings.units().mass(), 1e-9 * settings.units().mass());
  Simulation one(settings), other(smaller);
  one.advance(12), other.advance(12);
  EXPECT_LT(difference(other, one), 1e-9);
  Simulation start(settings);
  EXPECT_GT(difference(one, start), 1e-3); // they moved
}

TEST_P(EverySpeciesCase, IsTheSameFluidWhenEverySecondParticleIsOfATwinSpecies) {
  Simulation one(GetParam().settings), twins(with_twins(GetParam().settings));
  one.advance(12), twins.advance(12);
  EXPECT_LT(difference(twins, one), 1e-9);
  auto const species = twins.snapshot().species;
  ASSERT_EQ(species.size(), one.size());
  EXPECT_EQ(std::ranges::count(species, 0u), static_cast<std::ptrdiff_t>((one.size() + 1) / 2));
}

SimulationSettings mixture(SimulationSettings s) {
  std::visit(Overloaded{[&](Sdpd& of) {
                          of.species = {sdpd_species(s, 0.7, of.K), sdpd_species(s, 0.3, 3 * of.K)};
                        },
                        [&](auto& of) {
                          of.species = {pair_species(of, "light", 0.7, 1), pair_species(of, "heavy", 0.3, 3)};
                          if constexpr (requires { of.internal_energy; })
                            of.species[1].internal_energy = fitting::ConstantHeatCapacity(100);
                          s.rho *= 1.6; // as many particles as of the mass 1
                        }},
             s.method);
  return s;
}

TEST_P(EverySpeciesCase, AsAMixtureKeepsMomentumAndEnergyAndItsBitsOnAnyNumberOfThreads) {
  auto settings = mixture(GetParam().settings);
  settings.scheme.conservative = "none"; // whose energy error is no concern of the masses
  Snapshot first;
  for (int const threads : {1, 2, 4}) {
    settings.threads = threads;
    Simulation simulation(settings);
    double const before = simulation.observe().energy();
    simulation.advance(10);
    auto const now = simulation.observe();
    double const scale = std::sqrt(2 * now.kinetic * static_cast<double>(simulation.size()));
    EXPECT_LT(norm(now.momentum) / scale, 1e-13);
    if (settings.features().energies && settings.scheme.pairs != "entropy") {
      EXPECT_LT(std::abs(now.energy() / before - 1), 1e-13);
    }
    auto const here = simulation.snapshot();
    if (threads == 1)
      first = here;
    EXPECT_EQ(std::memcmp(here.p.data(), first.p.data(), here.p.size() * sizeof(Vec3)), 0);
    EXPECT_EQ(here.eps, first.eps);
  }
}

TEST_P(EverySpeciesCase, AsAMixtureGoesOnBitForBitFromACheckpoint) {
  auto const settings = mixture(GetParam().settings);
  Simulation unbroken(settings);
  unbroken.advance(45);
  auto const checkpoint = unbroken.checkpoint();
  unbroken.advance(15);
  Simulation resumed(settings);
  resumed.restore(checkpoint);
  resumed.advance(15);
  EXPECT_EQ(
      std::memcmp(unbroken.snapshot().q.data(), resumed.snapshot().q.data(), unbroken.size() * sizeof(Vec3)),
      0);
  EXPECT_EQ(unbroken.observe().energy(), resumed.observe().energy());
  EXPECT_GT(unbroken.list_renewals(), 1u);
}

// Densities, forces and friction of unlike masses, against sums over all pairs in double precision.
TEST(Species, HaveTheDensitiesForcesAndFrictionOfADirectSum) {
  auto settings = mixture(ideal_gas(20, 1e-5));
  settings.lattice = {7, 7, 7}, settings.disorder = 0.2, settings.noise = false;
  settings.as<Sdpd>().zeta = 0.5e-3;
  settings.scheme.conservative = "none";
  auto const system = make_system(settings);
  auto& particles = system->particles;
  for (std::size_t i = 0; i < system->size(); ++i) // a shear flow and a swirl
    particles.p[i] = particles.mass[i] * Vec3{std::sin(particles.q[i].y), 0.3 * particles.q[i].x, 0.1};
  auto const before = particles;
  auto const& kernel = std::get<CubicKernel>(system->kernel);
  auto const& fluid = settings.as<Sdpd>();
  double const eta = fluid.eta / settings.units().viscosity(),
               zeta = fluid.zeta / settings.units().viscosity();
  std::vector<double> rho(system->size());
  std::vector<Vec3> f(system->size()), friction(system->size());
  auto for_each_pair = [&](auto const& act) {
    for (std::size_t i = 0; i < system->size(); ++i)
      for (std::size_t j = 0; j < system->size(); ++j) {
        Vec3 const r = system->box.minimum_image(before.q[i] - before.q[j]);
        if (i == j || norm(r) < system->neighbours.range())
          act(i, j, r);
      }
  };
  for_each_pair(
      [&](std::size_t i, std::size_t j, Vec3 const& r) { rho[i] += before.mass[j] * kernel.W(norm(r)); });
  for_each_pair([&](std::size_t i, std::size_t j, Vec3 const& r) {
    if (i == j)
      return;
    double const masses = before.mass[i] * before.mass[j], F = kernel.F(norm(r), 1 / norm(r));
    f[i] += masses * (before.P[i] / (rho[i] * rho[i]) + before.P[j] / (rho[j] * rho[j])) * F * r;
    Vec3 const e = r / norm(r), v = before.p[i] / before.mass[i] - before.p[j] / before.mass[j];
    double const chi = masses * F / (rho[i] * rho[j]);
    friction[i] -=
        (5 * eta / 3 - zeta) * chi * (v - dot(e, v) * e) + (10 * eta / 3 + 4 * zeta) * chi * dot(e, v) * e;
  });
  fluctuate(*system, PairScheme::ssa, settings.dt);
  double density = 0, force = 0, step = 0, of_step = 0;
  for (std::size_t i = 0; i < system->size(); ++i) {
    density = std::max(density, std::abs(before.rho[i] / rho[i] - 1));
    force = std::max(force, norm(before.f[i] - f[i]) / norm(f[i]));
    step = std::max(step, norm((particles.p[i] - before.p[i]) / settings.dt - friction[i]));
    of_step = std::max(of_step, norm(friction[i]));
  }
  EXPECT_LT(density, 1e-12);
  EXPECT_LT(force, 1e-9);
  EXPECT_LT(step / of_step, 1e-3); // of single precision and the time step
}

TEST(Species, AreAsManyAsTheirSharesSay) {
  std::vector<Species> const three{{"a", 0.5, 1}, {"b", 0.301, 2}, {"c", 0.199, 5}};
  EXPECT_EQ(species_counts(three, 1000), (std::vector<std::size_t>{500, 301, 199}));
  EXPECT_EQ(species_counts(three, 7), (std::vector<std::size_t>{4, 2, 1})); // 3.5, 2.107, 1.393
  EXPECT_DOUBLE_EQ(mean_mass(three, 7), (4 * 1 + 2 * 2 + 1 * 5) / 7.0);
  auto const drawn = draw_species(three, 1000, 1);
  for (std::uint32_t s = 0; s < 3; ++s)
    EXPECT_EQ(std::ranges::count(drawn, s), (std::array{500, 301, 199}[s]));
  EXPECT_NE(drawn, draw_species(three, 1000, 2));
  EXPECT_EQ(drawn, draw_species(three, 1000, 1));
  // Neighbours on the lattice are alike as often as chance has it: 0.5^2 + 0.301^2 + 0.199^2 = 0.380.
  int alike = 0;
  for (std::size_t i = 0; i + 1 < drawn.size(); ++i)
    alike += drawn[i] == drawn[i + 1];
  EXPECT_NEAR(alike, 380, 4 * std::sqrt(1000 * 0.38 * 0.62));
}

TEST(Species, AreNotJudgedByOneEquationOfState) {
  auto const gas = mixture(ideal_gas(50, 0.02));
  EXPECT_THROW(CanonicalEnergy{gas}, InputError);
  EXPECT_THROW(check_calibration(gas, ScaleCondition::response), InputError);
  EXPECT_THROW(suitable_condition(gas), InputError);
  EXPECT_NO_THROW(CanonicalEnergy{ideal_gas(50, 0.02)});
}

TEST(Species, KeepTheMeanDensity) {
  auto const settings = mixture(ideal_gas(50, 0.02));
  auto const system = make_system(settings);
  double const mass = std::accumulate(system->particles.mass.begin(), system->particles.mass.end(), 0.0);
  EXPECT_NEAR(mass / system->box.volume(), 1, 1e-12); // in rho
}

std::string error_of(SimulationSettings const& settings) {
  try {
    check(settings);
    return "";
  } catch (InputError const& error) {
    return error.what();
  }
}

TEST(Species, ThatAreNotAllowedAreRefusedByName) {
  auto with = [](auto change) {
    auto settings = mixture(ideal_gas(20, 0.02));
    change(settings.as<Sdpd>().species);
    return error_of(settings);
  };
  EXPECT_EQ(with([](auto&) {}), "");
  EXPECT_NE(with([](auto& s) { s[1].share = 0.4; }).find("sum of the species' shares = 1.1"),
            std::string::npos);
  EXPECT_NE(with([](auto& s) { s[1].share = -0.3; }).find("share of species 'of 60"), std::string::npos);
  EXPECT_NE(with([](auto& s) { s[1].share = NAN; }).find("share of species 'of 60"), std::string::npos);
  EXPECT_NE(with([](auto& s) { s[0].K = 0.5; }).find("particle size K = 0.5"), std::string::npos);
  auto dpd = mixture(dpd_fluid());
  EXPECT_EQ(error_of(dpd), "");
  dpd.as<Dpd>().species[0].share = 2;
  EXPECT_NE(error_of(dpd).find("share of species 'light' = 2"), std::string::npos);
  auto dpde = mixture(dpde_fluid(20));
  dpde.as<Dpde>().species[1].mass = -1;
  EXPECT_NE(error_of(dpde).find("mass of species 'heavy' = -1"), std::string::npos);
}

} // namespace
} // namespace mesobridge::sdpd
