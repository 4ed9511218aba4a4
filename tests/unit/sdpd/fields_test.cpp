#include "pair_fluid_fixtures.hpp"
#include "sdpd/neighbours/neighbours.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <set>

// What is asked of every field of the particles, whoever adds one.

namespace mesobridge::sdpd {
namespace {

auto const cases = one_fluid_of_each_method();

TEST(Fields, HaveNamesOfTheirOwn) {
  std::set<std::string_view> names;
  for (auto const& field : fields)
    EXPECT_TRUE(names.insert(field.name).second) << field.name;
  EXPECT_GE(names.size(), 5u);
}

TEST(Fields, AreThereWhereTheMethodHasThem) {
  for (auto const& [name, settings] : cases) {
    Simulation const simulation(settings);
    auto const now = simulation.snapshot();
    auto const checkpoint = simulation.checkpoint();
    for (auto const& field : fields) {
      std::size_t const n = settings.features().*field.feature ? simulation.size() : 0;
      EXPECT_EQ((now.*field.values).size(), n) << name << ", " << field.name;
      EXPECT_EQ((checkpoint.particles.*field.values).size(), field.checkpointed ? n : 0)
          << name << ", " << field.name;
    }
  }
}

// Each particle keeps its values when the order in memory changes.
TEST(Fields, GoWithTheirParticles) {
  int moved = 0;
  for (auto const& [name, settings] : cases) {
    Particles particles;
    auto has = settings.features();
    has.masses = has.reacts = true;
    particles.resize(729, has);
    for (std::uint32_t i = 0; i < particles.size(); ++i) {
      particles.id[i] = i;
      particles.q[i] = Vec3{std::fmod(7.3 * i, 9), std::fmod(3.1 * i, 9), std::fmod(5.7 * i, 9)};
      for (std::size_t k = 0; k < fields.size(); ++k)
        if (auto& values = particles.*fields[k].values; !values.empty())
          values[i] = i + 1000.0 * static_cast<double>(k);
    }
    Neighbours neighbours({{9, 9, 9}}, 2, 0.4, 1);
    neighbours.renew(particles);
    for (std::size_t i = 0; i < particles.size(); ++i) {
      moved += particles.id[i] != i;
      for (std::size_t k = 0; k < fields.size(); ++k) {
        auto const& values = particles.*fields[k].values;
        if (!values.empty()) {
          ASSERT_EQ(values[i], particles.id[i] + 1000.0 * static_cast<double>(k)) << name << fields[k].name;
        }
      }
    }
  }
  EXPECT_GT(moved, 1000);
}

// A checkpoint whose field was lost, cut or given a value that makes no sense is refused by the field's name.
TEST(Fields, AreCheckedWhenARunGoesOn) {
  int refused = 0;
  auto const error_of = [](Simulation& simulation, Checkpoint const& checkpoint) -> std::string {
    try {
      simulation.restore(checkpoint);
    } catch (InputError const& error) {
      return error.what();
    }
    return "";
  };
  for (auto const& [name, settings] : cases) {
    Simulation simulation(settings);
    for (auto const& field : fields) {
      if (!field.checkpointed || !(settings.features().*field.feature))
        continue;
      auto checkpoint = simulation.checkpoint();
      (checkpoint.particles.*field.values).pop_back();
      EXPECT_NE(error_of(simulation, checkpoint).find(field.name), std::string::npos) << name << field.name;
      ++refused;
      if (field.range.contains(-1))
        continue;
      checkpoint = simulation.checkpoint();
      (checkpoint.particles.*field.values)[3] = -1;
      EXPECT_NE(error_of(simulation, checkpoint).find(field.name), std::string::npos) << name << field.name;
    }
    EXPECT_EQ(error_of(simulation, simulation.checkpoint()), "");
  }
  EXPECT_GE(refused, 5);
}

} // namespace
} // namespace mesobridge::sdpd
