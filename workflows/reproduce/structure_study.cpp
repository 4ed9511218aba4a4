#include "workflows/reproduce/structure_study.hpp"
#include "md/error.hpp"
#include "md/processor_clock.hpp"
#include "sdpd/observe/health.hpp"
#include "sdpd/observe/pairing.hpp"
#include "sdpd/simulation.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/ranges.h>
#include <numbers>

namespace mesobridge::workflows {
namespace {

constexpr std::uint64_t looks = 64; ///< in the second half of a run

/// The fluid in a box that is wide enough for its range.
sdpd::SimulationSettings fluid_of(StructureCase const& of, StructurePlan const& plan, std::uint64_t seed) {
  double const h = std::cbrt(of.neighbours / (4 * std::numbers::pi / 3));
  auto const side = std::max(plan.side, static_cast<std::uint32_t>(std::ceil(2.4 * h)));
  bool const small = of.K < 50;
  return {.method = sdpd::Sdpd{.eos = fitting::material("argon").eos,
                               .K = of.K,
                               .kernel = of.kernel,
                               .h_factor = h,
                               .eta = 2e-3},
          .rho = 1150,
          .T = 1000,
          .lattice = {side, side, side},
          .melted = true,
          .dt = small ? 0.05 : 0.1,
          .scheme = {.pairs = small ? "ems" : "ssa", .keep_energy = true},
          .seed = seed};
}

void advance(sdpd::Simulation& simulation, std::uint64_t steps, std::function<bool()> const& keep_going) {
  constexpr std::uint64_t at_once = 32;
  for (std::uint64_t done = 0; done < steps; done += at_once) {
    simulation.advance(std::min(at_once, steps - done));
    if (!keep_going())
      throw Interrupted("stopped while the structure of a fluid was looked for");
  }
}

/// Ways of the particles, whose positions are not taken back into the box by less than half its edge at once.
class Ways {
 public:
  explicit Ways(sdpd::Simulation const& simulation)
      : last_(simulation.snapshot().q), way_(last_.size(), Vec3{}) {}

  void follow(sdpd::Simulation const& simulation) {
    auto const now = simulation.snapshot();
    for (std::size_t i = 0; i < last_.size(); ++i)
      way_[i] += simulation.box().minimum_image(now.q[i] - last_[i]), last_[i] = now.q[i];
  }

  /// Without the motion of all together; the error from the scatter of the particles.
  cg::Estimate mean_square() const {
    double const n = static_cast<double>(way_.size());
    Vec3 all{};
    for (auto const& way : way_)
      all += way / n;
    double sum = 0, squares = 0;
    for (auto const& way : way_) {
      double const square = norm2(way - all);
      sum += square, squares += square * square;
    }
    double const mean = sum / n;
    return {mean, std::sqrt((squares / n - mean * mean) / (n - 1)), n};
  }

 private:
  std::vector<Vec3> last_, way_;
};

FoundStructure look(sdpd::Simulation& simulation, std::uint64_t steps,
                    std::function<bool()> const& keep_going) {
  md::ProcessorClock const clock;
  advance(simulation, steps / 2, keep_going);
  double seconds = clock.seconds();
  Ways ways(simulation);
  std::vector<double> paired, crystal;
  std::uint64_t const between = std::max<std::uint64_t>(1, steps / (2 * looks));
  for (std::uint64_t k = 0; k < looks; ++k) {
    md::ProcessorClock const lap;
    advance(simulation, between, keep_going);
    seconds += lap.seconds();
    ways.follow(simulation);
    paired.push_back(simulation.pairing_fraction());
    crystal.push_back(simulation.crystal_fraction());
  }
  double const work =
      static_cast<double>(steps / 2 + looks * between) * static_cast<double>(simulation.size());
  return {.failure = {},
          .paired = cg::estimate_mean(paired),
          .crystal = cg::estimate_mean(crystal),
          .moved = ways.mean_square(),
          .us_per_particle_step = 1e6 * seconds / work};
}

} // namespace

std::string name_of(StructureKind kind) {
  switch (kind) {
  case StructureKind::fluid:
    return "fluid";
  case StructureKind::glass:
    return "glass";
  case StructureKind::paired:
    return "pairs";
  default:
    return "crystal";
  }
}

StructureKind structure_of(StructureCase const& of, FoundStructure const& found) {
  auto const surely = [](cg::Estimate const& share, double limit) {
    return share.mean - 2 * share.se > limit;
  };
  if (surely(found.paired, sdpd::tolerable_pairing(of.K)))
    return StructureKind::paired;
  if (surely(found.crystal, sdpd::HealthConditions{}.tolerable_crystal))
    return StructureKind::crystal;
  return found.moved.mean > cage ? StructureKind::fluid : StructureKind::glass;
}

StructureVerdict verdict_of(StructureCase const& of, std::span<FoundStructure const> runs) {
  StructureVerdict verdict{.runs = runs.size()};
  for (auto const& run : runs)
    ++(run.failure.empty() ? verdict.became[static_cast<std::size_t>(structure_of(of, run))]
                           : verdict.stopped);
  return verdict;
}

std::string StructureVerdict::text() const {
  std::vector<std::string> parts;
  auto const say = [&](std::string const& name, std::size_t count) {
    if (count == runs)
      parts.push_back(name);
    else if (count > 0)
      parts.push_back(fmt::format("{} {} of {}", name, count, runs));
  };
  using enum StructureKind;
  for (auto const kind : {crystal, paired, glass, fluid})
    say(name_of(kind), count(kind));
  say("stops", stopped);
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::optional<cg::Estimate> over_runs(std::span<FoundStructure const> runs,
                                      cg::Estimate FoundStructure::*quantity) {
  double n = 0, sum = 0, squares = 0, own = 0, n_eff = 0;
  for (auto const& run : runs)
    if (run.failure.empty()) {
      auto const& e = run.*quantity;
      ++n, sum += e.mean, squares += e.mean * e.mean, own += e.se * e.se, n_eff += e.n_eff;
    }
  if (n == 0)
    return std::nullopt;
  double const mean = sum / n, spread = n > 1 ? std::max(0.0, squares / n - mean * mean) / (n - 1) : 0;
  return cg::Estimate{mean, std::sqrt(std::max(own / (n * n), spread)), n_eff};
}

std::vector<StructureCase> cases_of(StructurePlan const& plan) {
  std::vector<StructureCase> cases;
  for (auto const& kernel : plan.kernels)
    for (double const neighbours : plan.neighbours)
      for (double const K : plan.K)
        cases.push_back({kernel, neighbours, K});
  return cases;
}

FoundStructure find_structure(StructureCase const& of, StructurePlan const& plan, std::uint64_t seed,
                              std::function<bool()> const& keep_going) {
  auto const settings = fluid_of(of, plan, seed);
  try {
    sdpd::Simulation simulation(settings);
    return look(simulation, static_cast<std::uint64_t>(plan.time / settings.dt), keep_going);
  } catch (PhysicsError const& error) {
    return {.failure = error.what()};
  }
}

} // namespace mesobridge::workflows
