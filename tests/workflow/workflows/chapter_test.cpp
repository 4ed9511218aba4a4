#include "md/error.hpp"
#include "scratch_directory.hpp"
#include "workflows/star/blob_file.hpp"
#include "workflows/star/chapter.hpp"
#include <gtest/gtest.h>

namespace mesobridge::workflows {
namespace {

using tests::ScratchDirectory;

/// Two molecules that are small enough for seconds. The first melt is planned far too short.
ChapterPlan small_plan() {
  return {.molecules = {{{.arms = 4, .beads = 1}, {{.rho = 0.5, .molecules = 125, .sampling_steps = 4000}}},
                        {{.arms = 3, .beads = 1}, {{.rho = 0.5, .molecules = 125, .sampling_steps = 16000}}}},
          .melt = {.dt = 0.005,
                   .squeeze_steps = 200,
                   .equilibration_steps = 2000,
                   .sample_every = 80,
                   .checkpoint_every = 4000,
                   .seed = 4},
          .vacuum = {.molecules = 96,
                     .dt = 0.005,
                     .redraw_every = 100,
                     .equilibration_steps = 500,
                     .sampling_steps = 4000,
                     .sample_every = 100,
                     .seed = 4},
          .microcanonical_steps = 1000};
}

Context on_one_rank() {
  Context context;
  context.options.ranks = 1;
  context.options.quiet = true;
  return context;
}

TEST(Chapter, IsSampledUntilItSufficesAndReported) {
  ScratchDirectory const scratch;
  auto const plan = small_plan();
  auto const chapter = run_chapter(plan, scratch.path(), on_one_rank());
  ASSERT_EQ(chapter.melts.size(), 2u);
  auto const summary = chapter_summary(chapter);
  EXPECT_EQ(summary["star"], "4-1");
  EXPECT_EQ(summary["melts"].size(), 2u);
  int keys = 0;
  for (std::string const key :
       {"beta", "C_KU", "C_UD", "U_mean", "heat_capacity_melt", "heat_capacity_vacuum",
        "heat_capacity_vacuum_equipartition", "contact_energy", "contact_energy_configurational"}) {
    EXPECT_TRUE(summary[key].is_number()) << key;
    EXPECT_GT(summary[key + "_se"].get<double>(), 0) << key;
    ++keys;
  }
  EXPECT_EQ(keys, 9);
  EXPECT_GT(summary["md"]["frames"].get<int>(), md::frames_of({.sampling_steps = 4000, .sample_every = 80}))
      << "eight blocks of six memory times were not in the planned length";
  for (auto const& melt : summary["melts"]) { // quadratic in the momenta and in some of the positions
    double const momenta = melt["star"] == "4-1" ? 6 : 4.5;
    EXPECT_GT(melt["heat_capacity_vacuum"], momenta) << melt["star"];
    EXPECT_LT(melt["heat_capacity_vacuum"], 2 * momenta) << melt["star"];
    EXPECT_NEAR(melt["beta"].get<double>(), 1, 0.1 + 4 * melt["beta_se"].get<double>());
  }
  auto report = chapter_report(chapter);
  report.provenance = {"mesobridge", 4, "", {}};
  auto const html = report.html();
  for (char const* text :
       {"Figures 3.2 and 3.3", "Figures 3.4 and 3.5", "Figures 3.6 and 3.7", "Figure 3.8", "Figure 3.9",
        "Figure 3.10", "Figures 3.11 and 3.12", "Figure 3.13", "Figure 3.14"})
    EXPECT_NE(html.find(text), std::string::npos) << text;

  // Once more: everything is there. A melt that stopped in between goes on to the same end.
  auto const blobs = scratch / "melt-4-1-0.5" / "blobs.h5";
  auto const made = std::filesystem::last_write_time(blobs);
  EXPECT_EQ(chapter_summary(run_chapter(plan, scratch.path(), on_one_rank())), summary);
  EXPECT_EQ(std::filesystem::last_write_time(blobs), made);
  // Other settings do not overwrite it.
  auto other = plan;
  other.melt.seed = 5;
  try {
    run_chapter(other, scratch.path(), on_one_rank());
    FAIL() << "accepted";
  } catch (InputError const& error) {
    EXPECT_NE(std::string(error.what()).find("choose another folder"), std::string::npos) << error.what();
  }
}

TEST(Chapter, StandardHasFiveDensitiesOfThreeMoleculesWithinItsBudget) {
  auto const plan = chapter_plan(md::Preset::standard, 1);
  ASSERT_EQ(plan.molecules.size(), 3u);
  double atom_steps = 0;
  int melts = 0;
  for (auto const& [star, list] : plan.molecules) {
    EXPECT_EQ(list.front().rho, 0.3);
    double densities = 0;
    for (auto const& melt : list) {
      auto const settings = melt_settings(plan, star, melt);
      EXPECT_NO_THROW(md::check(settings)) << star.name() << " at " << melt.rho;
      auto const last = md::plan(settings).back();
      atom_steps += double(melt.molecules) * star.atoms() * double(last.first_step + last.steps);
      densities += melt.rho, ++melts;
    }
    EXPECT_NEAR(densities, 1.5, 1e-12);
  }
  EXPECT_EQ(melts, 15);
  // Two quiet cores make 3.4e7 (rho = 0.5) to 6e7 (0.1) atom-steps a second.
  EXPECT_LT(atom_steps / 3.4e7, 1.75 * 3600);
}

} // namespace
} // namespace mesobridge::workflows
