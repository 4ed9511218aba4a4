#pragma once
#include "sdpd/method/settings.hpp"
#include "sdpd/simulation.hpp"
#include "workflows/scene/driven.hpp"
#include "workflows/sdpd/run_scene.hpp"

namespace mesobridge::workflows {

/// What the samples of a finished run say against it (see sdpd/observe/health.hpp), and its scene: particles
/// that hardly meet another one.
std::vector<sdpd::Finding> findings_of(sdpd::EquilibriumSampler const& samples, RunResult const& result,
                                       sdpd::Simulation const& simulation);

/// [{"name": "equipartition", "severity": "failure", "text": ...}, ...]
Json findings_json(std::vector<sdpd::Finding> const& findings);

/// In one text, those which make the state another than the scene's; empty for a run without any.
std::string failure_of(std::vector<sdpd::Finding> const& findings);

/// What a scene's numbers alone say against it, before anything is run: warnings for people.
std::vector<sdpd::Finding> doubts_about(Scene const& scene, sdpd::SimulationSettings const& settings);

} // namespace mesobridge::workflows
