#include "workflows/sdpd/run_folder.hpp"
#include "md/error.hpp"
#include "workflows/earlier_results.hpp"
#include "workflows/sdpd/checkpoint_file.hpp"
#include "workflows/text_file.hpp"
#include <algorithm>
#include <array>
#include <fmt/ranges.h>
#include <fstream>

namespace mesobridge::workflows {
namespace {

namespace fs = std::filesystem;

std::string const scene_header = "# A scene as `mesobridge run` resolved it, with every key.\n";

/// Files that begin so are written by runs, with their journals.
constexpr std::array result_names{"scene.toml",        "run.h5",      "checkpoint.",  "trajectory.",
                                  "trajectory-frames", "report.html", "summary.json", "log.txt"};

/// A log alone, of a run that could not begin, is in nobody's way.
bool is_our_log(fs::path const& file) {
  std::string first_word;
  return file.filename() == "log.txt" && std::ifstream(file) >> first_word && first_word == "mesobridge";
}

/// A file that its writer did not live to complete is none yet.
bool is_result(std::string const& name) {
  return !name.ends_with(".new") &&
         std::ranges::any_of(result_names, [&](char const* of_run) { return name.starts_with(of_run); });
}

std::vector<std::string> names_of(std::vector<fs::path> const& files) {
  std::vector<std::string> names;
  for (auto const& file : files)
    names.push_back(file.filename().string());
  return names;
}

bool same_file(fs::path const& a, fs::path const& b) {
  std::error_code ignored;
  return fs::equivalent(a, b, ignored);
}

} // namespace

bool RunFolder::has_checkpoint() const {
  return checkpoint_exists(checkpoint());
}

std::vector<fs::path> RunFolder::results() const {
  std::vector<fs::path> found;
  for (auto const& entry : fs::directory_iterator(path_))
    if (is_result(entry.path().filename().string()) && !is_our_log(entry.path()))
      found.push_back(entry.path());
  std::ranges::sort(found);
  return found;
}

bool RunFolder::scene_is_ours() const {
  return has_checkpoint() || fs::exists(run_file()) || read_text_file(scene()).starts_with(scene_header);
}

bool RunFolder::holds_run() const {
  return has_checkpoint() || fs::exists(run_file()) || (fs::exists(scene()) && scene_is_ours());
}

std::string RunFolder::read_scene() const {
  auto const text = read_text_file(scene());
  return text.starts_with(scene_header) ? text.substr(scene_header.size()) : text;
}

void RunFolder::write_scene(std::string const& resolved) const {
  write_text_file(scene(), scene_header + resolved);
}

fs::path RunFolder::back_up() const {
  auto files = results();
  for (auto const& part : {calibration(), viscosity_trials(), time_step_study(), log(), path_ / "lammps.log"})
    files.push_back(part);
  return set_aside(path_, files);
}

ClaimedFolder claim(RunFolder const& folder, RunClaim const& how) {
  auto const there = folder.results();
  auto const where = folder.path().string();
  if (there.empty())
    return {false, how.resume ? fmt::format("nothing to resume in '{}': the run begins", where) : ""};
  auto const names = fmt::format("'{}'", fmt::join(names_of(there), "', '"));
  if (!folder.holds_run()) {
    if (!how.force || fs::exists(folder.scene()))
      throw InputError(fmt::format(
          "'{}' holds {}, which are of no run and would be overwritten: write into "
          "another folder with -o{}",
          where, names, fs::exists(folder.scene()) ? "" : ", or move them into a backup with --force"));
  } else if (how.resume)
    return {true, ""};
  else if (!how.force)
    throw InputError(fmt::format("'{}' holds {} ({}): go on with it by --resume, move it into a backup by "
                                 "--force, or write into another folder with -o",
                                 where, fs::exists(folder.summary()) ? "a finished run" : "a run", names));
  if (same_file(how.scene, folder.scene()))
    throw InputError(fmt::format("'{}' is the scene that is to run, and --force would move it into a backup: "
                                 "write into another folder with -o, or copy the scene to another place",
                                 how.scene.string()));
  return {false, fmt::format("what was in '{}' is in '{}' now", where, folder.back_up().string())};
}

} // namespace mesobridge::workflows
