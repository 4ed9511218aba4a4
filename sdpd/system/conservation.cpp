#include "sdpd/system/conservation.hpp"
#include "sdpd/system/sum_over_particles.hpp"
#include "sdpd/system/total_energy.hpp"

namespace mesobridge::sdpd {
namespace {

constexpr double round_off = 1e-11; ///< of a sum, in what it is made of

/// Numbers that are to stay as they are, each within the tolerance.
struct Amount {
  std::string_view name;
  std::vector<double> values;
  double tolerance = 0;
};

/// One number of each particle in the order of the ids, which no renewal of the lists changes.
template <class F>
void append_each(System const& system, std::vector<double>& values, F const& of) {
  std::size_t const begin = values.size();
  values.resize(begin + system.size());
  for (std::size_t i = 0; i < system.size(); ++i)
    values[begin + system.particles.id[i]] = of(i);
}
std::vector<double> each(System const& system, std::vector<double> const& of) {
  std::vector<double> values;
  if (!of.empty())
    append_each(system, values, [&](std::size_t i) { return of[i]; });
  return values;
}
std::vector<double> each(System const& system, std::vector<Vec3> const& of) {
  std::vector<double> values;
  for (auto const component : {&Vec3::x, &Vec3::y, &Vec3::z})
    append_each(system, values, [&](std::size_t i) { return of[i].*component; });
  return values;
}

/// Of a particle in thermal motion at least, so that a fluid at rest has a scale too.
double size_of_momenta(System const& system) {
  auto const& p = system.particles.p;
  return sum_over_particles(system, [&](std::size_t i) { return norm(p[i]) + std::sqrt(system.boltzmann); });
}
double size_of_internal_energies(System const& system) {
  auto const& eps = system.particles.eps;
  return sum_over_particles(system, [&](std::size_t i) { return std::abs(eps[i]); });
}

Amount momentum(System const& system) {
  auto const& p = system.particles.p;
  Vec3 const of_walls = system.wall_impulse();
  auto sum = [&](double Vec3::*component) {
    return sum_over_particles(system, [&](std::size_t i) { return p[i].*component; }) - of_walls.*component;
  };
  return {"the momentum", {sum(&Vec3::x), sum(&Vec3::y), sum(&Vec3::z)}, round_off * size_of_momenta(system)};
}

Amount internal_energy(System const& system) {
  auto const& eps = system.particles.eps;
  return {"the internal energy",
          {sum_over_particles(system, [&](std::size_t i) { return eps[i]; })},
          round_off * size_of_internal_energies(system)};
}

Amount energy(System const& system) {
  if (!system.has_energies())
    return {"the energy", {}};
  double const total = total_energy(system);
  double const size = std::abs(total) + std::abs(system.potential_energy) + size_of_internal_energies(system);
  return {"the energy", {total - system.energy_given()}, round_off * size};
}

Amount amount(Conserved what, System const& system) {
  auto const& particles = system.particles;
  switch (what) {
  case Conserved::positions:
    return {"each position", each(system, particles.q)};
  case Conserved::momenta:
    return {"each momentum", each(system, particles.p)};
  case Conserved::internal_energies:
    return {"each internal energy", each(system, particles.eps)};
  case Conserved::entropies:
    return {"each entropy", each(system, system.has_densities() ? particles.S : particles.eps)};
  case Conserved::momentum:
    return momentum(system);
  case Conserved::internal_energy:
    return internal_energy(system);
  case Conserved::energy:
    return energy(system);
  }
  throw std::logic_error("a quantity that nobody can measure");
}

} // namespace

void run_and_check(SubStep const& sub_step, System& system) {
  std::vector<Amount> before;
  for (auto const what : sub_step.conserves)
    before.push_back(amount(what, system));
  sub_step.run(system);
  for (std::size_t k = 0; k < before.size(); ++k) {
    auto const after = amount(sub_step.conserves[k], system);
    double const tolerance = std::max(before[k].tolerance, after.tolerance);
    for (std::size_t i = 0; i < after.values.size(); ++i)
      if (double const change = std::abs(after.values[i] - before[k].values[i]); change > tolerance)
        throw std::logic_error(fmt::format(
            "step {}: the sub-step '{}' conserves {}, it says, and changed it by {:.3g} (reduced)",
            system.step, sub_step.name, after.name, change));
  }
}

} // namespace mesobridge::sdpd
