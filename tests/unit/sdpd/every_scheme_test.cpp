#include "pair_fluid_fixtures.hpp"
#include "sdpd/make_system.hpp"
#include "sdpd/scheme/list.hpp"
#include "sdpd/scheme/scheme.hpp"
#include "sdpd/system/conservation.hpp"
#include "sdpd_fixtures.hpp"
#include <algorithm>
#include <cstring>
#include <gtest/gtest.h>
#include <map>
#include <set>

// What is asked of every scheme that the lists make, on fluids of every method.

namespace mesobridge::sdpd {
namespace {

struct Fluid {
  std::string name;
  SimulationSettings settings;
};

/// Small ones, with time steps that every scheme bears.
std::vector<Fluid> fluids() {
  std::vector<Fluid> all{
      {"sdpd gas", ideal_gas(50, 0.005)},
      {"sdpd argon that conducts", with_conduction(argon(200, 0.002), 0.5)},
      {"dpde", dpde_fluid(60, 0.004, 2)},
      {"dpde that conducts", with_pair_conduction(dpde_fluid(60, 0.004), PowerFriction(20, 0, 1, 2))},
      {"dpd", dpd_fluid(0.01)}};
  for (auto& fluid : all)
    fluid.settings.lattice = {7, 7, 7}, fluid.settings.disorder = 0.15;
  return all;
}

/// Schemes of all pair integrators and of all those of the forces, each in every way to combine them.
std::vector<Scheme> schemes() {
  std::vector<Scheme> all;
  for (auto const& pairs : pair_integrators())
    for (auto const& conservative : conservative_integrators())
      for (auto const splitting : {Splitting::lie_trotter, Splitting::strang})
        all.push_back({.pairs = pairs.name,
                       .verlet_steps = all.size() % 3 == 0 ? 3u : 1u,
                       .splitting = splitting,
                       .conservative = conservative.name,
                       .keep_energy = all.size() % 2 == 0});
  return all;
}

/// Calls f(fluid, scheme) for all fluids and schemes that go together; returns which pair integrators did.
template <class F>
std::map<std::string, int> for_each_scheme(F const& f) {
  std::map<std::string, int> runs;
  for (auto const& fluid : fluids())
    for (auto scheme : schemes()) {
      scheme.keep_energy &= fluid.settings.features().energies;
      if (refusal(pair_integrator(scheme.pairs), fluid.settings.features()))
        continue;
      SCOPED_TRACE(fluid.name + ", " + scheme.pairs + ", " + scheme.conservative);
      auto settings = fluid.settings;
      settings.scheme = scheme;
      f(settings, scheme);
      ++runs[scheme.pairs];
    }
  return runs;
}

void expect_all_ran(std::map<std::string, int> const& runs) {
  EXPECT_EQ(runs.size(), pair_integrators().size());
  EXPECT_GE(runs.size(), 7u);
  EXPECT_GE(conservative_integrators().size(), 3u);
  for (auto const& [name, count] : runs)
    EXPECT_GE(static_cast<std::size_t>(count), 2 * conservative_integrators().size()) << name;
}

TEST(EveryScheme, ConservesInEverySubStepWhatTheSubStepSays) {
  std::set<std::string> names;
  expect_all_ran(for_each_scheme([&](SimulationSettings const& settings, Scheme const& scheme) {
    auto const system = make_system(settings);
    auto const list = sub_steps(scheme, *system, settings.dt);
    for (int k = 0; k < 12; ++k, ++system->step)
      for (auto const& part : list)
        if (part.turn.comes(system->step)) {
          ASSERT_NO_THROW(run_and_check(part, *system));
          names.insert(part.name);
          EXPECT_FALSE(part.conserves.empty()) << part.name;
        }
  }));
  EXPECT_GT(names.size(), pair_integrators().size() + 6);
}

TEST(EveryScheme, WouldBeCaughtIfASubStepDidNotConserveWhatItSays) {
  auto const system = make_system(dpde_fluid(60, 0.004));
  auto spoilt = [&](Conserved what, auto const& change) {
    SubStep const part{.name = "a spoilt one", .conserves = {what}, .noise = {}, .run = [&](System& s) {
                         change(s.particles);
                       }};
    EXPECT_THROW(run_and_check(part, *system), std::logic_error) << static_cast<int>(what);
  };
  constexpr double little = 1e-7;
  using enum Conserved;
  spoilt(positions, [](Particles& of) { of.q[5].y += little; });
  spoilt(momenta, [](Particles& of) { of.p[5].z += little, of.p[6].z -= little; });
  spoilt(internal_energies, [](Particles& of) { of.eps[5] += little, of.eps[6] -= little; });
  spoilt(entropies, [](Particles& of) { of.eps[5] += little; });
  spoilt(momentum, [](Particles& of) { of.p[5].x += little; });
  spoilt(internal_energy, [](Particles& of) { of.eps[5] += 100 * little; });
  spoilt(energy, [](Particles& of) { of.eps[5] += 100 * little; });
}

// Sub-steps whose noise were the same would not be independent of each other.
TEST(EveryScheme, DrawsFromNoStreamTwiceInAStep) {
  expect_all_ran(for_each_scheme([](SimulationSettings const& settings, Scheme const& scheme) {
    auto const system = make_system(settings);
    std::set<Stream> seen;
    for (auto const& part : sub_steps(scheme, *system, settings.dt))
      for (auto const stream : part.noise)
        EXPECT_TRUE(seen.insert(stream).second) << part.name;
    EXPECT_FALSE(seen.empty());
  }));
}

std::vector<double> state_of(System const& system) {
  std::vector<double> all(4 * system.size());
  for (std::size_t i = 0; i < system.size(); ++i) {
    auto const& [x, y, z] = system.particles.p[i];
    double const eps = system.has_energies() ? system.particles.eps[i] : 0;
    auto const id = 4 * system.particles.id[i];
    all[id] = x, all[id + 1] = y, all[id + 2] = z, all[id + 3] = eps;
  }
  return all;
}

// With another seed, a sub-step does the same if it draws no noise, and something else if it does.
TEST(EveryScheme, DrawsNoiseInThoseSubStepsAloneThatSaySo) {
  std::size_t with = 0, without = 0;
  expect_all_ran(for_each_scheme([&](SimulationSettings const& settings, Scheme const& scheme) {
    auto const system = make_system(settings), other = make_system(settings);
    for (auto const& part : sub_steps(scheme, *system, settings.dt)) {
      auto const before = other->particles;
      other->seed = system->seed + 1;
      part.run(*system), part.run(*other);
      bool const same = state_of(*system) == state_of(*other);
      EXPECT_EQ(same, part.noise.empty()) << part.name;
      ++(same ? without : with);
      other->seed = system->seed;
      if (!same)
        other->particles = before, part.run(*other);
    }
  }));
  EXPECT_GT(with, 100u);
  EXPECT_GT(without, 100u);
}

bool same_bits(std::vector<double> const& a, std::vector<double> const& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

TEST(EveryScheme, GivesTheSameBitsForAnyNumberOfThreads) {
  std::set<std::string> pairs, conservative;
  for_each_scheme([&](SimulationSettings settings, Scheme const& scheme) {
    if (scheme.conservative != "verlet" && scheme.pairs != "ssa")
      return; // each of them once
    std::vector<std::vector<double>> results;
    for (int const threads : {1, 2, 4}) {
      settings.threads = threads;
      auto const system = make_system(settings);
      for (int k = 0; k < 3; ++k)
        step(*system, scheme, settings.dt);
      results.push_back(state_of(*system));
    }
    EXPECT_TRUE(same_bits(results[0], results[1]));
    EXPECT_TRUE(same_bits(results[0], results[2]));
    pairs.insert(scheme.pairs), conservative.insert(scheme.conservative);
  });
  EXPECT_EQ(pairs.size(), pair_integrators().size());
  EXPECT_EQ(conservative.size(), conservative_integrators().size());
}

TEST(EveryScheme, IsRefusedByNameWhereItDoesNotServe) {
  std::size_t refused = 0;
  for (auto const& fluid : fluids())
    for (auto const& integrator : pair_integrators()) {
      auto settings = fluid.settings;
      settings.scheme.pairs = integrator.name;
      if (!refusal(integrator, settings.features())) {
        EXPECT_NO_THROW(check(settings)) << integrator.name;
        continue;
      }
      ++refused;
      try {
        check(settings);
        ADD_FAILURE() << integrator.name << " with " << fluid.name;
      } catch (InputError const& error) {
        EXPECT_NE(std::string(error.what()).find("scheme = " + integrator.name), std::string::npos)
            << error.what();
      }
    }
  EXPECT_GE(refused, 6u);
  auto settings = dpd_fluid();
  settings.scheme.pairs = "sssa";
  EXPECT_THROW(check(settings), InputError);
  settings.scheme = {.conservative = "euler"};
  EXPECT_THROW(check(settings), InputError);
}

} // namespace
} // namespace mesobridge::sdpd
