#pragma once
#include "cg/correlations.hpp"
#include "md/lj_fluid.hpp"
#include "workflows/report/report.hpp"
#include "workflows/star/blob_analysis.hpp"
#include "workflows/star/sample_melt.hpp"
#include "workflows/star/sample_vacuum.hpp"

namespace mesobridge::workflows {

/// The runs that chapter 3 of the thesis takes.
struct ChapterPlan {
  struct Melt {
    double rho = 0;
    int molecules = 0;
    std::int64_t sampling_steps = 0;
  };
  struct Molecule {
    md::StarPolymer star;
    std::vector<Melt> melts; ///< the first one is told in full
  };
  std::vector<Molecule> molecules;
  md::StarMeltSettings melt;     ///< but for star, density, molecules, length, directory
  md::StarVacuumSettings vacuum; ///< but for star, levels of energy, directory
  std::int64_t microcanonical_steps = 0;
};
ChapterPlan chapter_plan(md::Preset preset, std::uint64_t seed);
/// Throws InputError when a run of the plan cannot be made, or is there twice.
void check(ChapterPlan const& plan);
/// All settings of a melt but its directory.
md::StarMeltSettings melt_settings(ChapterPlan const& plan, md::StarPolymer const& star,
                                   ChapterPlan::Melt const& melt);

/// One melt and what came of it.
struct ChapterMelt {
  md::StarPolymer star;
  double rho = 0;
  cg::Correlations correlations;
  cg::EntropyRoutes entropy;
  Json run; ///< the summary of the MD
};

/// Everything measured for the chapter.
struct Chapter {
  std::vector<ChapterMelt> melts; ///< the first one is 6-3 at rho = 0.3
};

/// Makes the runs that are not there yet (an interrupted one goes on from its checkpoint) and analyses them.
/// Melts that turn out too short for standard errors go on for as long as they need.
Chapter run_chapter(ChapterPlan plan, std::filesystem::path const& directory, Context const& context);

/// C of the melt over that of the isolated molecule, minus 1.
cg::Estimate heat_capacity_difference(ChapterMelt const& melt);

Json chapter_summary(Chapter const& chapter);
/// The report without its provenance.
Report chapter_report(Chapter const& chapter);

} // namespace mesobridge::workflows
