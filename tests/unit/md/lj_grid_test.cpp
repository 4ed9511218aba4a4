#include "md/lj_grid.hpp"
#include "md/rank_launcher.hpp"
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <gtest/gtest.h>
#include <set>
#include <unistd.h>

namespace mesobridge::md::test {
namespace {

constexpr char const* output_variable = "MESOBRIDGE_TEST_OUTPUT";

LjFluidSettings small_settings(std::string const& name) {
  LjFluidSettings settings;
  settings.atoms = 108;
  settings.cutoff = 2.5;
  settings.sampling_steps = 200;
  auto const folder =
      std::filesystem::temp_directory_path() / fmt::format("mesobridge-{}-{}", name, ::getpid());
  std::filesystem::create_directory(folder);
  settings.log_file = folder / "lammps.log";
  return settings;
}

std::vector<LjState> const four_states{{0.6, 4.0}, {0.75, 3.0}, {0.6, 8.0}, {0.7, 5.0}};

/// All samples of a small grid, by state.
std::vector<std::vector<ThermoSample>> sample(MpiWorld const& world, LjFluidSettings const& settings) {
  std::vector<std::vector<ThermoSample>> samples(four_states.size());
  double fraction = 0;
  bool const complete =
      sample_lj_grid(world, four_states, settings,
                     {.samples =
                          [&](std::size_t index, std::span<ThermoSample const> batch) {
                            samples[index].insert(samples[index].end(), batch.begin(), batch.end());
                            return true;
                          },
                      .progress =
                          [&](double done) {
                            EXPECT_GE(done, fraction);
                            fraction = done;
                            return true;
                          }});
  EXPECT_TRUE(complete);
  if (world.is_root()) {
    EXPECT_DOUBLE_EQ(fraction, 1.0);
  }
  return samples;
}

/// Starts this very test again on two ranks. There it writes what rank 0 received; here it compares.
TEST(LjGrid, OneAndTwoRanksGiveTheSameBits) {
  if (char const* const output = std::getenv(output_variable); output && already_on_ranks()) {
    MpiWorld const world;
    auto settings = small_settings("two-ranks");
    auto const samples = sample(world, settings);
    if (world.is_root()) {
      ASSERT_EQ(world.size(), 2);
      std::ofstream file(output, std::ios::binary);
      for (auto const& series : samples)
        file.write(reinterpret_cast<char const*>(series.data()),
                   std::streamsize(series.size() * sizeof(ThermoSample)));
    }
    world.barrier();
    std::filesystem::remove_all(settings.log_file.parent_path());
    return;
  }
  auto const output =
      std::filesystem::temp_directory_path() / fmt::format("mesobridge-samples-{}", ::getpid());
  setenv(output_variable, output.c_str(), 1);
  auto const self = std::filesystem::read_symlink("/proc/self/exe");
  ASSERT_EQ(run_on_ranks(
                2, {self.string(), "--gtest_filter=LjGrid.OneAndTwoRanksGiveTheSameBits", "--gtest_brief=1"}),
            0);
  unsetenv(output_variable);

  MpiWorld const world;
  auto const settings = small_settings("one-rank");
  auto const here = sample(world, settings);
  std::ifstream file(output, std::ios::binary);
  int compared = 0;
  for (auto const& series : here) {
    ASSERT_EQ(series.size(), 20u);
    for (auto const& expected : series) {
      ThermoSample read;
      ASSERT_TRUE(file.read(reinterpret_cast<char*>(&read), sizeof read));
      EXPECT_EQ(std::memcmp(&read, &expected, sizeof read), 0);
      ++compared;
    }
  }
  EXPECT_EQ(compared, 80);
  EXPECT_NE(here[0][0].U, here[2][0].U);
  std::filesystem::remove(output);
  std::filesystem::remove_all(settings.log_file.parent_path());
}

/// How many times LAMMPS was told to run, from its log.
int runs_in(std::filesystem::path const& log) {
  std::ifstream lines(log);
  int runs = 0;
  for (std::string line; std::getline(lines, line);)
    runs += line.starts_with("Loop time");
  return runs;
}

TEST(LjGrid, AConsumerStopsAllRunsAtOnce) {
  MpiWorld const world;
  auto const settings = small_settings("stop");
  int batches = 0;
  EXPECT_FALSE(sample_lj_grid(world, four_states, settings,
                              {.samples = [&](std::size_t, auto) { return ++batches < 2; }, .progress = {}}));
  EXPECT_EQ(batches, 2);
  EXPECT_LT(runs_in(settings.log_file), 50) << "one state takes about 42 runs, all four 168";
  int calls = 0;
  EXPECT_FALSE(
      sample_lj_grid(world, four_states, settings, {.samples = {}, .progress = [&](double done) {
                                                      ++calls;
                                                      EXPECT_LT(done, 0.1); // while the first lattice melts
                                                      return false;
                                                    }}));
  EXPECT_EQ(calls, 1);
  EXPECT_LT(runs_in(settings.log_file), 10);
  std::filesystem::remove_all(settings.log_file.parent_path());
}

TEST(LjGrid, TheDefaultRegionHoldsTheStatesItIsMadeFor) {
  auto const holds = [](double rho, double T) {
    return rho > default_lj_region.rho_min && rho < default_lj_region.rho_max &&
           T > default_lj_region.T_min && T < default_lj_region.T_max;
  };
  EXPECT_TRUE(holds(0.684, 8.33)); // argon, 1000 K, 1150 kg/m^3
  EXPECT_TRUE(holds(0.684, 4.17)); // 500 K, before the shock
  EXPECT_TRUE(holds(0.915, 8.07)); // behind it
  EXPECT_FALSE(holds(0.684, 1.3));
  int cases = 0;
  for (auto [preset, count] :
       {std::pair{Preset::quick, 25u}, {Preset::standard, 64u}, {Preset::paper, 144u}}) {
    auto const states = default_lj_grid(preset);
    EXPECT_EQ(states.size(), count);
    auto settings = lj_fluid_settings(preset);
    for (auto const& state : states) {
      EXPECT_NO_THROW(check(state, settings));
      ++cases;
    }
    EXPECT_EQ(states.front().rho, default_lj_region.rho_min);
    EXPECT_NEAR(states.back().T, default_lj_region.T_max, 1e-12);
  }
  EXPECT_EQ(cases, 25 + 64 + 144);
}

TEST(LjGrid, SharesEveryStateOnceAndEvenly) {
  auto const states = default_lj_grid(Preset::quick);
  for (int ranks : {1, 2, 3, 40}) {
    auto const shares = share_states(states, ranks);
    ASSERT_EQ(shares.size(), std::size_t(ranks));
    std::multiset<std::size_t> all;
    double least = 1e9, most = 0;
    for (auto const& share : shares) {
      double work = 0;
      for (std::size_t index : share)
        all.insert(index), work += states[index].rho;
      least = std::min(least, work), most = std::max(most, work);
    }
    EXPECT_EQ(all.size(), 25u);
    EXPECT_EQ(std::set<std::size_t>(all.begin(), all.end()).size(), 25u);
    EXPECT_LE(most - least, 1.05 + 1e-12) << "no rank is ahead by more than one state";
  }
}

TEST(LjGrid, RefusesBadInputBeforeAnyRun) {
  EXPECT_THROW(lj_grid({.rho_min = 0.5, .rho_max = 0.4, .T_min = 3, .T_max = 4}, 2, 2), InputError);
  EXPECT_THROW(lj_grid({.rho_min = 0.5, .rho_max = 0.6, .T_min = std::nan(""), .T_max = 4}, 2, 2),
               InputError);
  EXPECT_THROW(lj_grid(default_lj_region, 1, 2), InputError);
  MpiWorld const world;
  EXPECT_THROW(sample_lj_grid(world, {}, LjFluidSettings{}, {}), InputError);
  LjState const state{.rho = 0.7, .T = 4};
  int cases = 0;
  auto const refuses = [&](LjState s, auto change) {
    LjFluidSettings settings;
    change(settings);
    EXPECT_THROW(check(s, settings), InputError);
    ++cases;
  };
  refuses({.rho = -0.7, .T = 4}, [](auto&) {});
  refuses({.rho = 0.7, .T = std::nan("")}, [](auto&) {});
  refuses(state, [](auto& s) { s.atoms = 501; });
  refuses(state, [](auto& s) { s.atoms = -4; });
  refuses(state, [](auto& s) { s.atoms = 108; }); // box edge 5.36 < 2 * 3
  refuses(state, [](auto& s) { s.cutoff = 2.0; });
  refuses(state, [](auto& s) { s.reduced_time_step = 0; });
  refuses(state, [](auto& s) { s.friction_time = 0.01; });
  refuses(state, [](auto& s) { s.sampling_steps = 5; });
  refuses(state, [](auto& s) { s.sample_every = 0; });
  EXPECT_EQ(cases, 10);
  EXPECT_NO_THROW(check(state, LjFluidSettings{}));
}

} // namespace
} // namespace mesobridge::md::test
