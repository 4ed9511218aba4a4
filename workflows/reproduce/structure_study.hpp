#pragma once
#include "cg/estimate.hpp"
#include "sdpd/method/settings.hpp"
#include <array>
#include <functional>
#include <optional>
#include <span>

namespace mesobridge::workflows {

/// One fluid of argon by SDPD whose structure is to be found.
struct StructureCase {
  std::string kernel;
  double neighbours = 0, K = 0;
};

/// What particles are after a while.
enum class StructureKind { fluid, glass, paired, crystal };
std::string name_of(StructureKind kind);

/// What a run has shown; failure: why it could not go on, with nothing else.
struct FoundStructure {
  std::string failure;
  cg::Estimate paired, crystal; ///< shares of the particles, over the second half of the run
  cg::Estimate moved;           ///< mean square displacement over that half, in squares of the mean distance
  double us_per_particle_step = 0; ///< processor time of one thread
};

/// Displacements of less than this, in squares of the mean distance, leave a particle among its neighbours.
inline constexpr double cage = 0.1;

/// By the shares that are surely above what may be, then by the displacements.
StructureKind structure_of(StructureCase const& of, FoundStructure const& found);

/// What the runs of one case have become: a kernel may freeze by chance.
struct StructureVerdict {
  std::size_t runs = 0, stopped = 0;   ///< stopped: could not go on
  std::array<std::size_t, 4> became{}; ///< in the order of StructureKind

  std::size_t count(StructureKind kind) const { return became[static_cast<std::size_t>(kind)]; }
  /// "glass" where all runs say so, else "crystal 2 of 3, glass 1 of 3".
  std::string text() const;
};
StructureVerdict verdict_of(StructureCase const& of, std::span<FoundStructure const> runs);

/// A share or displacement in the mean over the runs that went on; its error is the larger one of what they
/// say themselves and of what their spread says. Nothing where none went on.
std::optional<cg::Estimate> over_runs(std::span<FoundStructure const> runs,
                                      cg::Estimate FoundStructure::*quantity);

struct StructurePlan {
  std::vector<std::string> kernels;
  std::vector<double> neighbours, K;
  double time = 150;      ///< reduced, of a run
  std::uint32_t side = 7; ///< particles along an edge of the box, at least
  std::size_t runs = 1;   ///< of each case, with seeds one after the other
};

std::vector<StructureCase> cases_of(StructurePlan const& plan);

/// Runs one: argon at 1150 kg/m^3 and 1000 K, 2 mPa s, from the melted start (sdpd/README.md, Eq. (S83)).
/// Throws Interrupted when `keep_going` says no.
FoundStructure find_structure(StructureCase const& of, StructurePlan const& plan, std::uint64_t seed,
                              std::function<bool()> const& keep_going);

} // namespace mesobridge::workflows
