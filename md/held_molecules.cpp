#include "md/held_molecules.hpp"
#include <array>
#include <cmath>
#include <numeric>

namespace mesobridge::md {
namespace {

/// Of a molecule's velocity, in units of the thermal one of an atom: round-off leaves some 1e-13.
constexpr double most_velocity = 1e-8;

Vec3 row(std::vector<double> const& numbers, std::size_t k) {
  return {numbers[3 * k], numbers[3 * k + 1], numbers[3 * k + 2]};
}

} // namespace

HeldMolecules::HeldMolecules(MpiWorld const& world, LammpsSession& lammps, int molecules,
                             std::vector<double> masses)
    : world_(world), lammps_(lammps), masses_(std::move(masses)),
      mass_(std::accumulate(masses_.begin(), masses_.end(), 0.0)), net_(3 * std::size_t(molecules)) {}

void HeldMolecules::stop() {
  std::vector<double> momenta(net_.size());
  auto const atoms = lammps_.owned_atoms("");
  for (std::size_t i = 0; i < atoms.ids.size(); ++i) {
    std::size_t const m = molecule_of(atoms.ids[i]);
    Vec3 const p = masses_[atom_of(atoms.ids[i])] * atoms.v[i];
    momenta[3 * m] += p.x, momenta[3 * m + 1] += p.y, momenta[3 * m + 2] += p.z;
  }
  world_.add_up(momenta);
  lammps_.set_velocities(
      [&](std::int64_t id, Vec3 const& v) { return v - row(momenta, molecule_of(id)) / mass_; });
}

void HeldMolecules::set_temperature(double T) {
  auto const atoms = lammps_.owned_atoms("");
  std::array<double, 1> twice_energy{};
  for (std::size_t i = 0; i < atoms.ids.size(); ++i)
    twice_energy[0] += masses_[atom_of(atoms.ids[i])] * norm2(atoms.v[i]);
  world_.add_up(twice_energy);
  double const freedoms = double(net_.size()) * double(masses_.size() - 1);
  double const factor = std::sqrt(freedoms * T / twice_energy[0]);
  lammps_.set_velocities([&](std::int64_t, Vec3 const& v) { return factor * v; });
}

void HeldMolecules::hold() {
  lammps_.add_forces([this](ForcedAtoms const& atoms) { take_away(atoms); });
}

void HeldMolecules::take_away(ForcedAtoms const& atoms) {
  std::fill(net_.begin(), net_.end(), 0.0);
  for (std::size_t i = 0; i < atoms.ids.size(); ++i)
    for (std::size_t axis = 0; axis < 3; ++axis)
      net_[3 * molecule_of(atoms.ids[i]) + axis] += atoms.f[i][axis];
  world_.add_up(net_);
  for (std::size_t i = 0; i < atoms.ids.size(); ++i) {
    double const share = masses_[atom_of(atoms.ids[i])] / mass_;
    for (std::size_t axis = 0; axis < 3; ++axis)
      atoms.added[i][axis] = -share * net_[3 * molecule_of(atoms.ids[i]) + axis];
  }
}

void HeldMolecules::put_back(MoleculeFrame& frame) const {
  for (std::size_t m = 0; m < std::size_t(frame.molecules); ++m) {
    Vec3 momentum, force = row(net_, std::size_t(frame.first_molecule) + m);
    double heat = 0;
    for (std::size_t k = 0; k < masses_.size(); ++k) {
      std::size_t const i = m * masses_.size() + k;
      momentum += masses_[k] * frame.v[i], heat += masses_[k] * norm2(frame.v[i]);
      frame.f[i] += masses_[k] / mass_ * force;
    }
    if (double const P = norm(momentum); !(P <= most_velocity * std::sqrt(mass_ * heat)))
      throw PhysicsError(fmt::format("molecule {}, whose centre is held, has the momentum {:.3g} by step {}",
                                     std::size_t(frame.first_molecule) + m, P, frame.step));
  }
}

} // namespace mesobridge::md
