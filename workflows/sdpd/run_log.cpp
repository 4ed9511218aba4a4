#include "workflows/sdpd/run_log.hpp"
#include "workflows/quantity.hpp"
#include "workflows/sdpd/measured_columns.hpp"
#include "workflows/version.hpp"
#include <algorithm>
#include <array>
#include <ctime>
#include <fmt/chrono.h>
#include <fstream>
#include <unistd.h>

namespace mesobridge::workflows {
namespace {

std::string now() {
  return fmt::format("{:%Y-%m-%d %H:%M:%S %z}", fmt::localtime(std::time(nullptr)));
}

std::string host() {
  std::array<char, 256> name{};
  return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "?";
}

/// "T_kin[K]": a column's title and its unit.
std::string column(std::string const& name, std::string const& unit) {
  return fmt::format(" {:>16}", unit.empty() ? name : name + "[" + unit + "]");
}

} // namespace

std::int64_t thermo_every(Scene::Run const& run) {
  constexpr std::int64_t lines = 20;
  return std::max<std::int64_t>(1, run.steps / lines / run.sample_every) * run.sample_every;
}

RunLog::RunLog(std::filesystem::path const& file, bool resume, std::string const& command, Scene const& scene,
               sdpd::SimulationSettings const& settings, std::function<void(std::string const&)> tell)
    : file_(file), units_(settings.units(), scene.units), features_(settings.features()),
      si_(scene.units == UnitSystem::SI), dt_(settings.dt),
      particles_(static_cast<double>(particles_of(scene))), every_(thermo_every(scene.run)),
      tell_(std::move(tell)) {
  if (!resume)
    std::ofstream(file_, std::ios::trunc);
  write(fmt::format("{}mesobridge {} ({}) on {}, process {}, {} thread(s)\n{}  {}\n{}  scene: {}\n",
                    resume ? "\n" : "", version(), git_commit(), host(), getpid(), settings.threads, now(),
                    command, now(), scene.title));
}

void RunLog::thermo(std::int64_t done, sdpd::Observation const& observed) {
  auto title = fmt::format("{:>12}", "Step") + column("Time", si_ ? "s" : ""),
       text = fmt::format("{:>12} {:>16.9g}", done, static_cast<double>(done) * dt_ * units_.time);
  for (auto const& measured : measured_in_every_run(features_))
    if (measured.logged) {
      title += column(std::string(measured.name), si_ ? std::string(si_unit(measured.dimension)) : "");
      double const value = std::get<sdpd::Measurement::FromSums>(measured.values)(observed).front();
      text += fmt::format(" {:>16.9g}", value * units_.of(measured.dimension).first);
    }
  title += column("E/N", si_ ? "J" : "");
  text += fmt::format(" {:>16.9g}", observed.energy() / particles_ * units_.energy);
  if (!titled_)
    tell(title);
  titled_ = true;
  tell(text);
}

/// A line for the file and for whoever listens.
void RunLog::tell(std::string const& line) {
  write(line + "\n");
  if (tell_)
    tell_(line);
}

void RunLog::say(std::string const& message) {
  write(fmt::format("{}  {}\n", now(), message));
}

void RunLog::end(std::string const& text) {
  write(fmt::format("{}{}{}  end\n", text, text.empty() || text.ends_with('\n') ? "" : "\n", now()));
}

/// Opened each time: the log survives whatever happens to the program, and a full disk costs no more than
/// lines.
void RunLog::write(std::string const& text) {
  std::ofstream(file_, std::ios::app) << text;
}

} // namespace mesobridge::workflows
