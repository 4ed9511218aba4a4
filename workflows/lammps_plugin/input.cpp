#include "workflows/lammps_plugin/input.hpp"
#include "md/error.hpp"
#include "sdpd/lammps/fluid_styles.hpp"
#include "sdpd/lammps/lammps_engine.hpp"
#include "workflows/lammps_plugin/texts.hpp"
#include "workflows/scene/resolved_lines.hpp"
#include "workflows/sdpd/scene_inputs.hpp"
#include "workflows/sdpd/settings.hpp"
#include "workflows/text_file.hpp"
#include <algorithm>
#include <fmt/ranges.h>

namespace mesobridge::workflows {
namespace {

namespace fs = std::filesystem;

/// A resolved scene in which one key, "section.name", has another text.
std::string with_value(std::string const& resolved, std::string const& key, std::string const& value) {
  std::string text;
  bool found = false;
  for_each_resolved_line(resolved, [&](auto const& line, auto const& path, auto const& old) {
    bool const other = path == key;
    text += other ? line.substr(0, line.size() - old.size()) + '"' + value + "\"\n" : line + "\n";
    found |= other;
  });
  if (!found)
    throw std::logic_error("a resolved scene does not say its file " + key);
  return text;
}

/// The scene as it was resolved, with the files that it names beside it.
void write_fluid(fs::path const& folder, Scene const& scene, std::string text) {
  for (auto const& [key, path] : scene_files(scene)) {
    auto name = key;
    std::ranges::replace(name, '.', '-');
    name += path.extension().string();
    fs::copy_file(path, folder / name, fs::copy_options::overwrite_existing);
    text = with_value(text, key, name);
  }
  write_text_file(folder / "fluid.toml", text);
}

/// Positions, momenta, and what fix property/atom gives each particle.
std::string data_text(sdpd::Particles const& particles, Vec3 const& edge) {
  auto const n = particles.size();
  fmt::memory_buffer text;
  auto const out = std::back_inserter(text);
  fmt::format_to(out, "particles of a fluid, in reduced units\n\n{} atoms\n1 atom types\n\n", n);
  fmt::format_to(out, "0 {} xlo xhi\n0 {} ylo yhi\n0 {} zlo zhi\n\nMasses\n\n1 1\n\nAtoms # atomic\n\n",
                 edge.x, edge.y, edge.z);
  for (std::size_t i = 0; i < n; ++i)
    fmt::format_to(out, "{} 1 {} {} {}\n", particles.id[i] + 1, particles.q[i].x, particles.q[i].y,
                   particles.q[i].z);
  fmt::format_to(out, "\nVelocities\n\n");
  for (std::size_t i = 0; i < n; ++i)
    fmt::format_to(out, "{} {} {} {}\n", particles.id[i] + 1, particles.p[i].x, particles.p[i].y,
                   particles.p[i].z);
  if (!particles.eps.empty()) {
    fmt::format_to(out, "\nEnergies\n\n");
    for (std::size_t i = 0; i < n; ++i)
      fmt::format_to(out, "{} {} {}\n", particles.id[i] + 1, particles.eps[i], particles.T[i]);
  }
  return fmt::to_string(text);
}

std::string input_text(sdpd::DecomposedFluid const& fluid, sdpd::ReducedUnits const& units,
                       sdpd::Checkpoint const& checkpoint, std::int64_t steps) {
  auto const commands = sdpd::fluid_commands(fluid);
  bool const energies = fluid.has_energies();
  auto const given = fmt::format("d_{} d_{}", sdpd::given_eps, sdpd::given_T);
  return fmt::format(
      "plugin load mesobridgeplugin.so\n\n{before}\n{energies}read_data particles.data{read}\n{after}\n\n"
      "pair_style {style} fluid.toml\npair_coeff * *\nfix fluid all {style}\nreset_timestep {step}\n\n"
      "variable T equal temp*{temperature}\nthermo_style custom step v_T ke{sum}\nthermo_modify norm no\n"
      "thermo 100\n"
      "dump particles all custom 1000 particles.lammpstrj id x y z vx vy vz{columns}\n"
      "dump_modify particles sort id\n"
      "restart 10000 fluid.1.restart fluid.2.restart\n\nrun {steps}\n",
      fmt::arg("before", fmt::join(commands.before, "\n")),
      fmt::arg("energies", energies ? "fix given all property/atom " + given + "\n" : ""),
      fmt::arg("read", energies ? " fix given NULL Energies" : ""),
      fmt::arg("after", fmt::join(commands.after, "\n")), fmt::arg("style", sdpd::fluid_style),
      fmt::arg("step", checkpoint.step), fmt::arg("temperature", units.temperature * units.K),
      fmt::arg("sum", energies ? " f_fluid" : ""),
      fmt::arg("columns", energies ? " f_fluid[1] f_fluid[2]" : ""), fmt::arg("steps", steps));
}

} // namespace

void write_lammps_input(fs::path const& folder, Scene const& scene, StoredCheckpoint const& stored,
                        std::int64_t steps) {
  auto const settings = settings_of(scene, 1);
  sdpd::refuse_for_lammps(settings);
  sdpd::DecomposedFluid const fluid(settings);
  auto const units = settings.units();
  fs::create_directories(folder);
  write_fluid(folder, scene, stored.scene);
  write_text_file(folder / "particles.data",
                  data_text(stored.checkpoint.particles, sdpd::box_of(settings).edge));
  write_text_file(folder / "in.fluid", input_text(fluid, units, stored.checkpoint, steps));
  write_text_file(folder / "batch.sh", batch_script());
  write_text_file(folder / "README.md", plugin_page(scene, units));
}

} // namespace mesobridge::workflows
