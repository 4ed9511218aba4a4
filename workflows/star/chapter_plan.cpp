#include "md/error.hpp"
#include "workflows/star/chapter.hpp"
#include <algorithm>
#include <set>

namespace mesobridge::workflows {

ChapterPlan chapter_plan(md::Preset preset, std::uint64_t seed) {
  constexpr md::StarPolymer small{.arms = 6, .beads = 3}, middle{.arms = 6, .beads = 6},
      large{.arms = 6, .beads = 12};
  ChapterPlan plan{
      .molecules = {{small, {{.rho = 0.3, .molecules = 343, .sampling_steps = 300000}}}},
      .melt = {.equilibration_steps = 10000, .seed = seed},
      .vacuum = {.molecules = 600, .equilibration_steps = 5000, .sampling_steps = 60000, .seed = seed},
      .microcanonical_steps = 20000};
  if (preset == md::Preset::quick)
    return plan;
  plan.melt.equilibration_steps = 30000;
  plan.melt.sample_every = 200;
  plan.vacuum.sampling_steps = 100000;
  plan.microcanonical_steps = 30000;
  // Twice the thesis's: the energy still keeps to 1e-4 k_B T a bead.
  plan.melt.dt = plan.vacuum.dt = 0.002;
  // Boxes of the densest 6-12 melts are as small as they may be: their length is what they need most.
  // The energies of thin melts forget slowly, and so do the local densities of dense ones of large molecules
  // (100 time units for 6-12 stars at rho = 0.5): they are followed for longer, for 48 such times at least.
  // The first melt is the one in which pairs in contact are looked at closely.
  plan.molecules = {{small,
                     {{.rho = 0.3, .molecules = 1000, .sampling_steps = 1000000},
                      {.rho = 0.1, .molecules = 343, .sampling_steps = 600000},
                      {.rho = 0.2, .molecules = 500, .sampling_steps = 400000},
                      {.rho = 0.4, .molecules = 500, .sampling_steps = 300000},
                      {.rho = 0.5, .molecules = 500, .sampling_steps = 300000}}},
                    {middle,
                     {{.rho = 0.3, .molecules = 400, .sampling_steps = 300000},
                      {.rho = 0.1, .molecules = 216, .sampling_steps = 1000000},
                      {.rho = 0.2, .molecules = 343, .sampling_steps = 500000},
                      {.rho = 0.4, .molecules = 400, .sampling_steps = 300000},
                      {.rho = 0.5, .molecules = 400, .sampling_steps = 650000}}},
                    {large,
                     {{.rho = 0.3, .molecules = 343, .sampling_steps = 800000},
                      {.rho = 0.1, .molecules = 216, .sampling_steps = 1000000},
                      {.rho = 0.2, .molecules = 300, .sampling_steps = 550000},
                      {.rho = 0.4, .molecules = 160, .sampling_steps = 1650000},
                      {.rho = 0.5, .molecules = 160, .sampling_steps = 2850000}}}};
  if (preset == md::Preset::paper) {
    plan.melt.dt = plan.vacuum.dt = 0.001;
    plan.melt.equilibration_steps = 100000;
    plan.melt.sample_every = 500;
    plan.vacuum.sampling_steps = 1000000;
    plan.microcanonical_steps = 100000;
    for (auto& molecule : plan.molecules)
      for (auto& melt : molecule.melts)
        melt.molecules = std::max(melt.molecules, 1000), melt.sampling_steps = 5000000;
  }
  return plan;
}

md::StarMeltSettings melt_settings(ChapterPlan const& plan, md::StarPolymer const& star,
                                   ChapterPlan::Melt const& melt) {
  auto settings = plan.melt;
  settings.star = star;
  settings.rho = melt.rho;
  settings.molecules = melt.molecules;
  settings.sampling_steps = melt.sampling_steps;
  return settings;
}

void check(ChapterPlan const& plan) {
  std::set<std::pair<std::string, double>> seen;
  for (auto const& [star, melts] : plan.molecules) {
    auto vacuum = plan.vacuum;
    vacuum.star = star;
    md::check(vacuum);
    for (auto const& melt : melts) {
      md::check(melt_settings(plan, star, melt));
      require(seen.emplace(star.name(), melt.rho).second, "rho of " + star.name() + " stars", melt.rho,
              "must not be there twice");
    }
  }
}

} // namespace mesobridge::workflows
