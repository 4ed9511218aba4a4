#include "sdpd/start/place.hpp"
#include "sdpd/state/random.hpp"

namespace mesobridge::sdpd {

std::vector<std::uint32_t> place(Particles& particles, Layout const& layout, double disorder,
                                 std::uint64_t seed) {
  NoiseSource const source(seed, Stream::initial_positions, 0);
  std::vector<std::uint32_t> regions;
  regions.reserve(layout.size());
  layout.for_each_place([&](Vec3 const& at, std::size_t region) {
    auto const id = static_cast<std::uint32_t>(regions.size());
    auto const& of = layout.regions()[region];
    auto const G = gaussians_reference(source, id, 0);
    particles.id[id] = id;
    particles.q[id] = at + of.spacing * disorder * Vec3{G[0], G[1], G[2]};
    if (!particles.T.empty())
      particles.T[id] = of.T;
    regions.push_back(static_cast<std::uint32_t>(region));
  });
  return regions;
}

void let_flow(Particles& particles, Layout const& layout, std::vector<std::uint32_t> const& regions) {
  for (std::size_t i = 0; i < particles.size(); ++i)
    particles.p[i] = particles.mass_of(i) * layout.velocity_at(regions[i], particles.q[i]);
}

namespace {

/// Sums over a group of particles.
struct Sums {
  Vec3 momentum{};
  double mass = 0, square = 0, count = 0;
};

} // namespace

void draw_momenta(Particles& particles, ThermalGroups const& groups, double boltzmann, std::uint64_t seed) {
  NoiseSource const source(seed, Stream::initial_velocities, 0);
  std::vector<Sums> sums(groups.T.size());
  auto const group = [&](std::size_t i) { return groups.of.empty() ? 0 : groups.of[i]; };
  std::vector<Vec3> thermal(particles.size());
  for (std::size_t i = 0; i < particles.size(); ++i) {
    auto const G = gaussians_reference(source, particles.id[i], 0);
    double const m = particles.mass_of(i);
    auto& sum = sums[group(i)];
    sum.momentum += thermal[i] = std::sqrt(m) * Vec3{G[0], G[1], G[2]}, sum.mass += m, ++sum.count;
  }
  for (std::size_t i = 0; i < particles.size(); ++i) {
    double const m = particles.mass_of(i);
    auto& sum = sums[group(i)];
    sum.square += norm2(thermal[i] -= m * (sum.momentum / sum.mass)) / m;
  }
  std::vector<double> scale;
  for (std::size_t g = 0; g < sums.size(); ++g) {
    double const energy = 3 * (sums[g].count - 1) * boltzmann * groups.T[g];
    scale.push_back(sums[g].count > 1 ? std::sqrt(energy / sums[g].square) : 0);
  }
  for (std::size_t i = 0; i < particles.size(); ++i)
    particles.p[i] += scale[group(i)] * thermal[i];
}

} // namespace mesobridge::sdpd
