#include "md/piston_drive.hpp"
#include "md/canonical_run.hpp"
#include <array>
#include <cmath>

namespace mesobridge::md {
namespace {

/// Sums over the atoms of each slice, and what LAMMPS makes them of.
constexpr std::array<std::pair<char const*, char const*>, 5> sums{{{"number", "v_one"},
                                                                   {"vz", "v_vz"},
                                                                   {"across", "v_across"},
                                                                   {"along", "v_along"},
                                                                   {"zz", "c_virial[3]"}}};

} // namespace

std::int64_t steps_to_far_end(double length, double spacing, double v_S, double dt) {
  constexpr double end_zone = 8; // in spacings
  return std::int64_t((length - end_zone * spacing) / (v_S * dt));
}

bool PistonDrive::settle(std::int64_t steps) {
  lammps_.command("run 0 post no");
  return run_in_pieces(
      steps, [&](std::int64_t n) { lammps_.command("run {} pre no post no", n); },
      [&](std::int64_t n) { return told(n); });
}

void PistonDrive::put_walls() {
  lammps_.command("change_box all boundary p p sf"); // a piston asks for a face that follows the atoms
  lammps_.command("reset_timestep 0");
  lammps_.command("timestep {}", box_.dt);
  lammps_.command("fix piston all wall/piston zlo pos 0.0 vel {} units box", box_.v_P);
  lammps_.command("fix wall all wall/reflect zhi {} units box", box_.length);
  declare_slices();
}

void PistonDrive::declare_slices() {
  double const width = box_.length / box_.slices;
  lammps_.command("compute slices all chunk/atom bin/1d z 0.0 {} units box bound z 0.0 {}", width,
                  box_.length - width / 2);
  lammps_.command("compute virial all stress/atom NULL virial");
  lammps_.command("variable one atom 1.0");
  lammps_.command("variable vz atom vz");
  lammps_.command("variable across atom vx*vx+vy*vy");
  lammps_.command("variable along atom vz*vz");
  for (auto const& [name, summed] : sums)
    lammps_.command("compute {} all reduce/chunk slices sum {}", name, summed);
  std::string columns; // what is printed is tallied in the step
  for (auto const& [name, summed] : sums)
    columns += fmt::format(" c_{}[1]", name);
  lammps_.command("thermo_style custom step temp{}", columns);
  lammps_.command("thermo {}", box_.sample_every);
}

bool PistonDrive::drive(std::int64_t steps, std::string const& what) {
  lammps_.command("run 0 post no");
  for (std::int64_t done = box_.sample_every; done <= steps; done += box_.sample_every) {
    // The piston counts its time from the start of what LAMMPS is told to be one run.
    lammps_.command("run {} pre no post no start 0 stop {}", box_.sample_every, steps);
    auto const slices = slices_at(done, what);
    if (!asked([&] { return !consumers_.slices || consumers_.slices(slices); }) || !told(box_.sample_every))
      return false;
  }
  return true;
}

std::vector<double> PistonDrive::sum(std::string const& name) {
  std::vector<double> values;
  for (int s = 0; s < box_.slices; ++s)
    values.push_back(lammps_.compute(name, s));
  return values;
}

PistonSlices PistonDrive::slices_at(std::int64_t step, std::string const& what) {
  double const time = static_cast<double>(step) * box_.dt;
  PistonSlices now{.step = step, .time = time, .piston = box_.v_P * time};
  auto const number = sum("number"), vz = sum("vz"), across = sum("across"), along = sum("along"),
             virial = sum("zz");
  double const volume = box_.area * box_.length / box_.slices, energy = units_.mass * units_.energy_of_mv2;
  for (std::size_t s = 0; s < number.size(); ++s) {
    double const n = number[s], v = n > 0 ? vz[s] / n : 0,
                 motion = n > 1 ? (along[s] - n * v * v) * n / (n - 1) : 0;
    now.velocity.push_back(v);
    now.T.push_back(n > 0 ? energy * across[s] / (2 * n) / units_.boltzmann : 0);
    now.P.push_back(n > 1 ? (motion * energy * units_.pressure_of_energy - virial[s]) / volume : 0);
    if (!std::isfinite(now.P.back()))
      throw PhysicsError(
          fmt::format("{} became unstable at step {} with the time step {}", what, step, box_.dt));
  }
  now.number = number;
  return now;
}

bool PistonDrive::told(std::int64_t steps) {
  steps_done_ += steps;
  return asked([&] { return !consumers_.steps || consumers_.steps(steps_done_); });
}

/// The consumers of rank 0 are asked and all ranks obey.
template <class Question>
bool PistonDrive::asked(Question const& question) {
  bool const answer = !world_.is_root() || question();
  return world_.root_says(answer);
}

} // namespace mesobridge::md
