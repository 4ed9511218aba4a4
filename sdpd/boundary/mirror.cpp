#include "sdpd/boundary/mirror.hpp"
#include "sdpd/system/masses.hpp"
#include <atomic>

namespace mesobridge::sdpd {
namespace {

/// What all images that one particle sees give it.
struct OfImages {
  Vec3 force;
  double virial = 0, energy = 0; ///< half of each: the other half is the images'
};

/// Adds the forces by the images of a layer, of_images(layer, k) for its k-th particle, and returns their
/// sum.
template <class F>
Vec3 add_forces(System& system, WallLayer const& layer, F const& of_images, double& energy) {
  thread_local std::vector<OfImages> of_caller; // kept so that no step allocates
  auto& of_each = of_caller;                    // the same for all threads of the loop below
  of_each.resize(layer.particles.size());
  for_each_index(of_each.size(), threads_for(system, layer), [&](std::size_t k) {
    of_each[k] = of_images(layer, k);
    system.particles.f[layer.particles[k]] += of_each[k].force;
  });
  Vec3 force;
  double virial = 0;
  for (auto const& one : of_each)
    force += one.force, virial += one.virial, energy += one.energy;
  system.virial += virial;
  return force;
}

/// The same of all layers, each with what prepare(layer) makes. An image behind several walls is pushed by
/// each along its normal (Eq. (S56)). Returns the energy.
template <class Prepare>
double add_forces(System& system, Prepare const& prepare) {
  double energy = 0;
  for (auto& wall : system.walls)
    wall.force = component(add_forces(system, wall.layer, prepare(wall.layer), energy), wall.axis);
  for (auto const& corner : system.corners) {
    Vec3 const force = add_forces(system, corner.layer, prepare(corner.layer), energy);
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

/// A number f(j) of each of a layer's candidates, and 0 of the phantom that fills up its lists. Returns where
/// they are.
template <class F>
double const* set_of_candidates(WallLayer const& layer, F const& f, std::vector<double>& values) {
  values.resize(layer.candidates.size() + 1);
  std::ranges::transform(layer.candidates, values.begin(), f);
  values.back() = 0;
  return values.data();
}

double const* set_weights(System const& system, WallLayer const& layer) {
  thread_local std::vector<double> values; // kept so that no step allocates
  return set_of_candidates(
      layer, [&](Index j) { return weight_of(system, j); }, values);
}

double const* set_pushes(System const& system, WallLayer const& layer) {
  thread_local std::vector<double> values;
  return set_of_candidates(
      layer, [&](Index j) { return push_of_pressure(system, j); }, values);
}

/// Eight images that a particle sees: whose, r from the image to it, r^2, |r| and 1/|r|.
struct ImageLanes {
  std::uint32_t const* of;
  Lanes x, y, z, r2;
  DistanceLanes distance;

  ImageLanes(WallImages const& images, std::size_t m)
      : of(&images.of[m]), x(load<Lanes>(&images.x[m])), y(load<Lanes>(&images.y[m])),
        z(load<Lanes>(&images.z[m])), r2(x * x + y * y + z * z), distance(r2) {}
};

/// Calls f(images) for what the k-th particle of a layer sees, eight at a time.
template <class F>
[[gnu::always_inline]] inline void for_each_group_of_images(WallLayer const& layer, std::size_t k,
                                                            F const& f) {
  auto const first = layer.begin[layer.places[k]];
  for (std::size_t m = first; m < first + layer.counts[k]; m += lane_count)
    f(ImageLanes(layer.images, m));
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
          double const* weight = set_weights(system, layer);
          for_each_index(layer.particles.size(), threads_for(system, layer), [&](std::size_t k) {
            Lanes rho{};
            for_each_group_of_images(layer, k, [&](ImageLanes const& at) {
              rho += gather(weight, at.of) * kernel.W(at.distance.r);
            });
            particles.rho[layer.particles[k]] += sum(rho);
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
        add_forces(system, [&](WallLayer const& prepared) {
          double const *weight = set_weights(system, prepared), *push = set_pushes(system, prepared);
          return [&kernel, weight, push](WallLayer const& layer, std::size_t k) {
            Lanes const weight_i = broadcast(weight[layer.places[k]]),
                        push_i = broadcast(push[layer.places[k]]);
            Lanes x{}, y{}, z{}, virial{};
            for_each_group_of_images(layer, k, [&](ImageLanes const& at) {
              Lanes const strength = weight_i * gather(weight, at.of) * (push_i + gather(push, at.of)) *
                                     kernel.F(at.distance.r, at.distance.inverse_r);
              x += strength * at.x, y += strength * at.y, z += strength * at.z, virial += strength * at.r2;
            });
            return OfImages{.force = {sum(x), sum(y), sum(z)}, .virial = 0.5 * sum(virial)};
          };
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
          system.potential_energy += add_forces(system, [&](WallLayer const&) {
            return [&](WallLayer const& layer, std::size_t k) {
              OfImages all;
              layer.for_each_image(k, [&](Index j, Vec3 const& r) {
                double const distance = norm(r);
                if (distance < potential.inner())
                  failure.report(system.particles.id[layer.particles[k]],
                                 too_near(system, j, distance, potential.inner()));
                if (!(distance < potential.cutoff()))
                  return;
                auto const pair = potential(distance, 1 / distance);
                all.force += pair.strength * r, all.virial += 0.5 * pair.strength * norm2(r);
                all.energy += 0.5 * pair.energy;
              });
              return all;
            };
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
              layer.for_each_image(k, [&](Index, Vec3 const& r) {
                if (double const distance = norm(r); distance < potential.cutoff())
                  virial[layer.particles[k]] += 0.5 * potential(distance, 1 / distance).strength * norm2(r);
              });
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
