#pragma once
#include "sdpd/method/settings.hpp"
#include "sdpd/observe/observation.hpp"
#include "workflows/sdpd/settings.hpp"
#include <filesystem>
#include <functional>

namespace mesobridge::workflows {

/// log.txt of a run, for people: what runs, where and when, a line of thermodynamics every so often,
/// warnings, and how it ended. A run that goes on appends to it. It is no result: a log that cannot be
/// written does not end a run.
class RunLog {
 public:
  /// Writes the head. `tell` gets the lines of thermodynamics too.
  RunLog(std::filesystem::path const& file, bool resume, std::string const& command, Scene const& scene,
         sdpd::SimulationSettings const& settings, std::function<void(std::string const&)> tell);

  /// Steps between two lines.
  std::int64_t every() const { return every_; }

  /// A line after `done` sampled steps, with the step and time that run.h5 gives them.
  void thermo(std::int64_t done, sdpd::Observation const& observed);

  /// A message with its time.
  void say(std::string const& message);

  /// The last lines: the results, or why there are none.
  void end(std::string const& text);

 private:
  void write(std::string const& text);
  void tell(std::string const& line);

  std::filesystem::path file_;
  OutputUnits units_;
  sdpd::Features features_;
  bool si_;
  double dt_, particles_;
  std::int64_t every_;
  bool titled_ = false;
  std::function<void(std::string const&)> tell_;
};

/// Steps between lines of thermodynamics, such that a run has about twenty, each of them at a sample.
std::int64_t thermo_every(Scene::Run const& run);

} // namespace mesobridge::workflows
