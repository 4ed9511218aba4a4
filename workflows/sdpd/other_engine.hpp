#pragma once
#include "sdpd/simulation.hpp"
#include "workflows/command.hpp"
#include <optional>

namespace mesobridge::workflows {

/// Another engine than the built-in one, which advances the simulation in its place.
struct OtherEngine {
  std::string name;
  int ranks = 1;
  std::function<void(sdpd::SimulationSettings const&)> settle; ///< told the run's own, before the first step
  std::function<void(sdpd::Simulation&, std::uint64_t steps)> advance;
};

/// Steps in slices, between which a run asks whether to go on. Another engine brings all particles here after
/// each of them: its slices grow to what takes half a second. Results do not depend on them.
class Slices {
 public:
  /// The first slice has so many steps, >= 1.
  Slices(std::int64_t steps, std::optional<OtherEngine> const& engine) : steps_(steps), engine_(engine) {}

  /// Advances by a slice or, if that is less, by `most` steps; returns how many.
  std::int64_t advance(sdpd::Simulation& simulation, std::int64_t most);

 private:
  std::int64_t steps_;
  std::optional<OtherEngine> const& engine_;
};

/// Writes `engine` and `ranks` into a summary: those of this call or, if it made no step, what the summary in
/// the file says of an earlier one; nothing of the built-in engine.
void tell_engine(Json& summary, std::optional<OtherEngine> const& engine, bool made_steps,
                 std::filesystem::path const& file);

} // namespace mesobridge::workflows
