#include "sdpd/boundary/mirror.hpp"
#include "sdpd/system/masses.hpp"
#include <atomic>

namespace mesobridge::sdpd {
namespace {

/// What a law gives for a particle and an image: the force is strength * r.
struct OfImage {
  double strength = 0, energy = 0;
};

/// What all images that one particle sees give it.
struct OfImages {
  Vec3 force;
  double virial = 0, energy = 0;
};

/// Adds the forces by the images of a layer, law(i, j, r) each, and returns their sum. Half of their virial
/// and energy is the fluid's, the other half the images'.
template <class Law>
Vec3 add_forces(System& system, WallLayer const& layer, Law const& law, double& energy) {
  auto& particles = system.particles;
  auto const& near = layer.particles;
  thread_local std::vector<OfImages> of_caller; // kept so that no step allocates
  auto& of_each = of_caller;                    // the same for all threads of the loop below
  of_each.resize(near.size());
  for_each_index(near.size(), threads_for(system, layer), [&](std::size_t k) {
    Index const i = near[k];
    OfImages one;
    for (auto const& [j, r] : layer.images[k]) {
      auto const [strength, u] = law(i, j, r);
      one.force += strength * r, one.virial += 0.5 * strength * norm2(r), one.energy += 0.5 * u;
    }
    particles.f[i] += one.force;
    of_each[k] = one;
  });
  Vec3 force;
  double virial = 0;
  for (auto const& one : of_each)
    force += one.force, virial += one.virial, energy += one.energy;
  system.virial += virial;
  return force;
}

/// The same of all layers. An image behind several walls is pushed by each along its normal (Eq. (S56)).
/// Returns the energy.
template <class Law>
double add_forces(System& system, Law const& law) {
  double energy = 0;
  for (auto& wall : system.walls)
    wall.force = component(add_forces(system, wall.layer, law, energy), wall.axis);
  for (auto const& corner : system.corners) {
    Vec3 const force = add_forces(system, corner.layer, law, energy);
    for (auto const w : corner.walls)
      system.walls[w].force += component(force, system.walls[w].axis);
  }
  return energy;
}

/// Calls f(layer) for what is seen behind each wall, then behind several.
template <class F>
void for_each_layer(System const& system, F const& f) {
  for (auto const& wall : system.walls)
    f(wall.layer);
  for (auto const& corner : system.corners)
    f(corner.layer);
}

} // namespace

void add_wall_densities(System& system) {
  if (system.walls.empty())
    return;
  find_wall_images(system);
  auto& particles = system.particles;
  std::visit(
      [&](auto const& kernel) {
        for_each_layer(system, [&](WallLayer const& layer) {
          for_each_index(layer.particles.size(), threads_for(system, layer), [&](std::size_t k) {
            double rho = 0;
            for (auto const& [j, r] : layer.images[k])
              rho += weight_of(system, j) * kernel.W(norm(r));
            particles.rho[layer.particles[k]] += rho;
          });
        });
      },
      system.kernel);
}

void add_wall_forces(System& system) {
  if (system.walls.empty())
    return;
  std::visit(
      [&](auto const& kernel) {
        add_forces(system, [&](Index i, Index j, Vec3 const& r) {
          double const distance = norm(r);
          return OfImage{.strength = weight_of(system, i) * weight_of(system, j) *
                                     (push_of_pressure(system, i) + push_of_pressure(system, j)) *
                                     kernel.F(distance, 1 / distance)};
        });
      },
      system.kernel);
}

namespace {

std::string too_near(System const& system, Index j, double distance, double inner) {
  return fmt::format(
      "it is {:.6g} (reduced) from the image of particle {} behind a wall, nearer than {:.6g}, "
      "where the pair potential ends; take a shorter time step",
      distance, system.particles.id[j], inner);
}

} // namespace

void add_wall_pair_forces(System& system) {
  if (system.walls.empty())
    return;
  find_wall_images(system);
  Failure failure;
  std::visit(
      [&](auto const& potential) {
        if constexpr (requires { potential(1.0, 1.0); })
          system.potential_energy += add_forces(system, [&](Index i, Index j, Vec3 const& r) {
            double const distance = norm(r);
            if (distance < potential.inner())
              failure.report(system.particles.id[i], too_near(system, j, distance, potential.inner()));
            if (!(distance < potential.cutoff()))
              return OfImage{};
            auto const pair = potential(distance, 1 / distance);
            return OfImage{pair.strength, pair.energy};
          });
      },
      system.potential);
  system.stop_at(failure);
}

void add_wall_virials(System const& system, std::vector<double>& virial) {
  std::visit(
      [&](auto const& potential) {
        if constexpr (requires { potential(1.0, 1.0); })
          for_each_layer(system, [&](WallLayer const& layer) {
            for (std::size_t k = 0; k < layer.particles.size(); ++k)
              for (auto const& [j, r] : layer.images[k])
                if (double const distance = norm(r); distance < potential.cutoff())
                  virial[layer.particles[k]] += 0.5 * potential(distance, 1 / distance).strength * norm2(r);
          });
      },
      system.potential);
}

namespace {

bool some_came_through(System const& system, Wall const& wall) {
  std::atomic<bool> some = false;
  double const place = wall.position(system.wall_time);
  for_each_part(system.size(), system.threads, [&](std::size_t begin, std::size_t end) {
    bool found = false;
    for (std::size_t i = begin; i < end; ++i)
      found |= wall.upper ? component(system.particles.q[i], wall.axis) > place
                          : component(system.particles.q[i], wall.axis) < place;
    if (found)
      some.store(true, std::memory_order_relaxed);
  });
  return some;
}

/// Images keep most particles away from the wall; the fastest come through.
void bounce(System& system) {
  auto& particles = system.particles;
  for (auto& wall : system.walls) {
    if (!some_came_through(system, wall))
      continue;
    for (std::size_t i = 0; i < system.size(); ++i)
      if (double const depth = -wall.distance(particles.q[i], system.wall_time); depth > 0) {
        double const m = particles.mass_of(i), v = wall.motion.velocity_at(system.wall_time);
        double &q = component(particles.q[i], wall.axis), &p = component(particles.p[i], wall.axis);
        double const before = p;
        q += wall.upper ? -2 * depth : 2 * depth;
        if (wall.upper ? p > m * v : p < m * v)
          p = 2 * m * v - p;
        wall.impulse += p - before;
        wall.work += (p - before) * (p + before) / (2 * m);
      }
  }
}

} // namespace

void move_walls(System& system, double dt) {
  if (system.walls.empty())
    return;
  if (!system.walls_held)
    system.wall_time += dt;
  bounce(system);
}

void count_wall_impulses(System& system, double dt) {
  for (auto& wall : system.walls) {
    wall.impulse += wall.force * dt;
    wall.work += wall.force * dt * wall.motion.velocity_at(system.wall_time);
  }
}

} // namespace mesobridge::sdpd
