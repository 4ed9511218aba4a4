#include "md/piston_drive.hpp"
#include "md/canonical_run.hpp"
#include <algorithm>
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

/// Of a molecule's centre of mass, all atoms of equal mass.
struct CentreMotion {
  double z = 0;
  Vec3 v;
};

/// On all ranks, from the atoms of each.
std::vector<CentreMotion> motion_of_molecules(MpiWorld const& world, LammpsSession& lammps,
                                              std::size_t molecules, int atoms_per_molecule) {
  std::vector<double> sums(4 * molecules);
  auto const atoms = lammps.owned_atoms("");
  for (std::size_t i = 0; i < atoms.ids.size(); ++i) {
    auto const m = 4 * std::size_t((atoms.ids[i] - 1) / atoms_per_molecule);
    auto const& v = atoms.v[i];
    sums[m] += atoms.q[i].z, sums[m + 1] += v.x, sums[m + 2] += v.y, sums[m + 3] += v.z;
  }
  world.add_up(sums);
  std::vector<CentreMotion> motion;
  for (std::size_t m = 0; m < sums.size(); m += 4)
    motion.push_back({sums[m] / atoms_per_molecule,
                      1.0 / atoms_per_molecule * Vec3{sums[m + 1], sums[m + 2], sums[m + 3]}});
  return motion;
}

} // namespace

std::int64_t steps_to_far_end(double length, double spacing, double v_S, double dt) {
  constexpr double end_zone = 8; // in spacings
  return std::int64_t((length - end_zone * spacing) / (v_S * dt));
}

bool PistonDrive::settle(std::int64_t steps) {
  // One run for fixes that follow the time from its start to its end.
  auto const times = fmt::format("start {} stop {}", lammps_.step(), lammps_.step() + steps);
  lammps_.command("run 0 post no {}", times);
  return run_in_pieces(
      steps, [&](std::int64_t n) { lammps_.command("run {} pre no post no {}", n, times); },
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
  lammps_.command("thermo_style custom step temp pe ke etotal{}", columns);
  lammps_.command("thermo_modify norm no");
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
    if (has_arrived(slices))
      return true;
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
  now.energy = lammps_.thermo("etotal");
  if (box_.atoms_per_molecule > 0)
    now.molecules = molecules_at();
  return now;
}

MoleculeSlices PistonDrive::molecules_at() {
  auto const n = box_.atoms_per_molecule;
  auto const slices = std::size_t(box_.slices);
  auto const molecules = std::size_t(lammps_.atoms()) / std::size_t(n);
  auto const motion = motion_of_molecules(world_, lammps_, molecules, n);
  MoleculeSlices now{.number = std::vector<double>(slices),
                     .velocity = std::vector<double>(slices),
                     .T = std::vector<double>(slices)};
  for (auto const& [z, v] : motion) {
    auto const s = std::size_t(std::clamp(z / box_.length * box_.slices, 0.0, box_.slices - 1.0));
    ++now.number[s], now.velocity[s] += v.z, now.T[s] += v.x * v.x + v.y * v.y;
  }
  double const kT = units_.mass * n * units_.energy_of_mv2 / units_.boltzmann / 2;
  for (std::size_t s = 0; s < slices; ++s)
    if (now.number[s] > 0)
      now.velocity[s] /= now.number[s], now.T[s] *= kT / now.number[s];
  return now;
}

bool PistonDrive::has_arrived(PistonSlices const& now) const {
  if (!box_.end)
    return false;
  double n = 0, momentum = 0;
  for (auto s = std::size_t(*box_.end / box_.length * box_.slices); s < now.number.size(); ++s)
    n += now.number[s], momentum += now.number[s] * now.velocity[s];
  return momentum > n * box_.v_P / 2;
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
