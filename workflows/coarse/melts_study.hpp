#pragma once
#include "workflows/coarse/stages.hpp"
#include "workflows/report/report.hpp"

namespace mesobridge::workflows {

/// Several melts of which each becomes a fluid of particles, in a folder of its own.
struct MeltsStudy {
  std::vector<std::string> stars; ///< "6-3"
  std::vector<double> densities;  ///< the first is that of the models that are run at the others, too
  std::vector<std::string> words; ///< what each chain is told besides
  bool transfer = false;          ///< whether they are
};

/// "6-3-rho-0.3"
std::string melt_folder(std::string const& star, double rho);

/// `workflow star-to-dpde` of one melt after the other.
std::vector<Stage> study_stages(MeltsStudy const& study, std::filesystem::path const& directory);

/// The summaries of all, with their stars and densities: `rows`. Throws InputError where one is not whole.
Json study_summary(MeltsStudy const& study, std::filesystem::path const& directory);

/// What the particles keep of each melt, over the densities.
Report study_report(MeltsStudy const& study, Json const& summary);

} // namespace mesobridge::workflows
