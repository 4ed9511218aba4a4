#pragma once
#include "moved_energy.hpp"
#include "sdpd/make_system.hpp"
#include "sdpd/simulation.hpp"
#include <gtest/gtest.h>

/// What is true of every fluid between walls, wherever they stand.
namespace mesobridge::sdpd {

/// The force on a particle, before anything was moved, is the slope of the energy of the fluid and its
/// images.
inline void expect_slope_of_energy(System& system, std::size_t i, Vec3 const& force) {
  double const step = 1e-5;
  for (int const axis : {0, 1, 2}) {
    Vec3 by;
    component(by, axis) = step;
    double const slope = (energy_with(system, i, by) - energy_with(system, i, -1.0 * by)) / (2 * step);
    EXPECT_NEAR(component(force, axis), -slope, 2e-5 * (norm(force) + 1)) << i << " " << axis;
  }
}

/// In 200 steps before a piston: momentum to round-off, energy up to this share of the piston's work.
inline void expect_balance_with_walls(SimulationSettings const& settings, double share) {
  Simulation simulation(settings);
  auto const before = simulation.observe();
  double const scale = std::sqrt(2 * before.kinetic * static_cast<double>(simulation.size()));
  simulation.advance(200);
  auto const after = simulation.observe();
  Vec3 impulse;
  double work = 0;
  for (auto const& wall : simulation.walls())
    component(impulse, wall.axis) += wall.impulse, work += wall.work;
  EXPECT_GT(norm(impulse) / scale, 1e-2);
  EXPECT_LT(norm(after.momentum - before.momentum - impulse) / scale, 1e-12);
  if (!settings.features().energies)
    return;
  EXPECT_GT(work / before.kinetic, 0.05);
  EXPECT_EQ(after.wall_work, work);
  EXPECT_LT(std::abs(after.energy() - before.energy()), share * work);
}

/// A fluid between walls and the periodic one, without walls, of which it is the half, the quarter or the
/// eighth that is its own mirror image along each of the axes.
struct MirroredFluid {
  std::unique_ptr<System> part, whole;
  std::vector<std::size_t> place; ///< in the whole, of an id
  std::size_t copies;

  MirroredFluid(SimulationSettings settings, std::vector<int> const& axes)
      : part(make_system(settings)), copies(std::size_t{1} << axes.size()) {
    settings.faces = {};
    for (int const axis : axes)
      settings.lattice[static_cast<std::size_t>(axis)] *= 2;
    whole = make_system(settings);
    place.resize(whole->size());
    find_places();
    for (std::size_t i = 0; i < part->size(); ++i)
      for (std::size_t copy = 0; copy < copies; ++copy) {
        auto q = part->particles.q[i];
        for (std::size_t a = 0; a < axes.size(); ++a)
          if (copy >> a & 1)
            component(q, axes[a]) = 2 * component(part->box.edge, axes[a]) - component(q, axes[a]);
        auto const k = place.at(copies * part->particles.id[i] + copy);
        whole->particles.q[k] = q;
        if (part->has_energies())
          whole->particles.eps[k] = part->particles.eps[i];
      }
    refresh(*whole), refresh(*part);
    find_places(); // the lists have sorted them anew
  }

  /// Forces, densities and pressures of the part's particles, and the energy.
  void expect_same(double density_error) const {
    ASSERT_EQ(whole->size(), copies * part->size());
    for (std::size_t i = 0; i < part->size(); ++i) {
      auto const k = place[copies * part->particles.id[i]];
      EXPECT_LT(norm(whole->particles.f[k] - part->particles.f[i]), 1e-7 * (1 + norm(part->particles.f[i])));
      if (part->has_densities()) {
        EXPECT_NEAR(whole->particles.rho[k], part->particles.rho[i], density_error);
        EXPECT_NEAR(whole->particles.P[k] / part->particles.P[i], 1, 1e-7);
      }
    }
    EXPECT_NEAR(whole->potential_energy, static_cast<double>(copies) * part->potential_energy,
                1e-9 * std::abs(whole->potential_energy));
  }

 private:
  void find_places() {
    for (std::size_t k = 0; k < whole->size(); ++k)
      place[whole->particles.id[k]] = k;
  }
};

} // namespace mesobridge::sdpd
