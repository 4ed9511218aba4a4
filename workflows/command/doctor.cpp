#include "md/child_process.hpp"
#include "md/error.hpp"
#include "md/lammps_session.hpp"
#include "md/metal_potential.hpp"
#include "workflows/command.hpp"
#include "workflows/process.hpp"
#include "workflows/processors.hpp"
#include "workflows/store/store.hpp"
#include "workflows/version.hpp"
#include <filesystem>
#include <thread>

namespace mesobridge::workflows {

namespace {

struct Finding {
  std::string what;
  bool present;
  std::string found;  ///< version or figure
  std::string remedy; ///< what to do when it is missing
};

std::string first_line(std::string const& text) {
  return text.substr(0, text.find('\n'));
}

Finding examine_program(std::string const& name, std::string const& version_option,
                        std::string const& package, std::string const& needed_for) {
  Finding finding{name, md::program_file(name).has_value(), "",
                  fmt::format("needed for {}; apt-get install {}", needed_for, package)};
  if (finding.present) {
    auto const answer = run_process({name, version_option});
    finding.found = first_line(answer.output);
    finding.present = answer.status == 0;
  }
  return finding;
}

Finding examine_disk() {
  constexpr double needed_GB = 1;
  std::error_code error;
  auto const space = std::filesystem::space(".", error);
  double const free_GB = error ? 0 : static_cast<double>(space.available) / 1e9;
  return {"disk", free_GB >= needed_GB, fmt::format("{:.1f} GB free here", free_GB),
          fmt::format("a run wants at least {} GB; choose another disk with -o", needed_GB)};
}

Finding examine_lammps() {
  auto const installation = md::lammps_installation(md::MpiWorld());
  return {"LAMMPS", true,
          fmt::format("{} with {}", installation.version, fmt::join(installation.packages, ", ")), ""};
}

Finding examine_potentials() {
  auto const folder = md::packaged_potentials();
  std::error_code error;
  int files = 0;
  for (auto const& entry : std::filesystem::directory_iterator(folder, error))
    files += entry.path().filename().string().find(".eam") != std::string::npos;
  return {"potentials", files > 0, fmt::format("{} of the embedded-atom kind in {}", files, folder.string()),
          "needed for metals, unless you have a file of your own; apt-get install lammps-data"};
}

std::vector<Finding> examine() {
  return {
      {"mesobridge", true, fmt::format("{} ({})", version(), git_commit()), ""},
      examine_lammps(),
      examine_potentials(),
      examine_program("mpirun", "--version", "openmpi-bin", "molecular dynamics on several cores"),
      examine_program("gnuplot", "--version", "gnuplot-nox", "the plots of the report"),
      {"HDF5", true, store_library_version(), ""},
      {"processors", true,
       fmt::format("{} for this process, of {} in all", available_processors(),
                   std::thread::hardware_concurrency()),
       ""},
      examine_disk(),
  };
}

Result doctor(Context&) {
  Result result;
  std::string missing;
  for (auto const& finding : examine()) {
    result.json[finding.what] = {{"present", finding.present}, {"found", finding.found}};
    result.text += fmt::format("{:<12} {:<8} {}\n", finding.what, finding.present ? "ok" : "MISSING",
                               finding.present ? finding.found : finding.remedy);
    if (!finding.present) {
      result.json[finding.what]["remedy"] = finding.remedy;
      missing += (missing.empty() ? "" : ", ") + finding.what;
    }
  }
  if (!missing.empty())
    result.complaint = "missing or insufficient: " + missing;
  return result;
}

} // namespace

Command::Action doctor_command(CLI::App&) {
  return doctor;
}

} // namespace mesobridge::workflows
