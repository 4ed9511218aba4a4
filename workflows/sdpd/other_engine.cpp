#include "workflows/sdpd/other_engine.hpp"
#include "workflows/json_file.hpp"
#include <algorithm>
#include <chrono>

namespace mesobridge::workflows {

std::int64_t Slices::advance(sdpd::Simulation& simulation, std::int64_t most) {
  auto const now = std::min(steps_, most);
  if (!engine_) {
    simulation.advance(static_cast<std::uint64_t>(now));
    return now;
  }
  constexpr std::chrono::milliseconds long_enough(500);
  auto const begin = std::chrono::steady_clock::now();
  engine_->advance(simulation, static_cast<std::uint64_t>(now));
  if (now == steps_ && std::chrono::steady_clock::now() - begin < long_enough)
    steps_ *= 2;
  return now;
}

void tell_engine(Json& summary, std::optional<OtherEngine> const& engine, bool made_steps,
                 std::filesystem::path const& file) {
  if (made_steps && engine)
    summary["engine"] = engine->name, summary["ranks"] = engine->ranks;
  if (made_steps || !std::filesystem::exists(file))
    return;
  auto const before = read_json(file);
  for (char const* key : {"engine", "ranks"})
    if (before.contains(key))
      summary[key] = before[key];
}

} // namespace mesobridge::workflows
