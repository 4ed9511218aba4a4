#include "cg/estimate.hpp"
#include "pair_fluid_fixtures.hpp"
#include "sdpd/make_system.hpp"
#include "sdpd/observe/list.hpp"
#include "sdpd_fixtures.hpp"
#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <numbers>

namespace mesobridge::sdpd {
namespace {

using Tensor = std::vector<double>;

Measurement const& pressure_tensor() {
  return *std::ranges::find(measurements(), "pressure_tensor", &Measurement::name);
}

Tensor tensor_of(System const& system) {
  return std::get<Measurement::FromSystem>(pressure_tensor().values)(system);
}

Tensor products(Vec3 const& a, Vec3 const& b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z, a.x * b.y, a.x * b.z, a.y * b.z};
}

void add(Tensor& sum, double weight, Tensor const& of) {
  for (std::size_t c = 0; c < sum.size(); ++c)
    sum[c] += weight * of[c];
}

/// Calls f(i, j, r_ij) for all pairs of particles, nearest images.
template <class F>
void for_all_pairs(System const& system, F const& f) {
  auto nearest = [](double x, double edge) { return x - edge * std::round(x / edge); };
  auto const& q = system.particles.q;
  for (std::size_t i = 0; i < q.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      Vec3 const d = q[i] - q[j], edge = system.box.edge;
      f(i, j, Vec3{nearest(d.x, edge.x), nearest(d.y, edge.y), nearest(d.z, edge.z)});
    }
}

/// Groot and Warren's energy, and the force over the distance.
double soft_energy(double r) {
  return r < 1 ? 12.5 * (1 - r) * (1 - r) : 0;
}
double soft_strength(double r) {
  return r < 1 ? 25 * (1 - r) / r : 0;
}

/// The cubic spline W of support h, and F = -W'/r.
double spline(double r, double h) {
  double const u = r / h, of = 8 / (std::numbers::pi * h * h * h);
  return u >= 1 ? 0 : u <= 0.5 ? of * (1 - 6 * u * u * (1 - u)) : of * 2 * std::pow(1 - u, 3);
}
double spline_strength(double r, double h) {
  double const u = r / h, of = 48 / (std::numbers::pi * h * h * h * h * h);
  return u >= 1 ? 0 : u <= 0.5 ? of * (2 - 3 * u) : of * (1 - u) * (1 - u) / u;
}

/// strength(i, j, r) of f_ij = strength * r_ij summed over all pairs, with the motion beside the mean one.
template <class Strength>
Tensor by_two_loops(System const& system, Strength const& strength) {
  auto const& of = system.particles;
  double mass = 0;
  Vec3 momentum;
  for (std::size_t i = 0; i < of.size(); ++i)
    mass += of.mass_of(i), momentum += of.p[i];
  Tensor sum(6);
  auto const n = static_cast<double>(of.size());
  for (std::size_t i = 0; i < of.size(); ++i)
    add(sum, n / (n - 1) / of.mass_of(i), products(of.p[i], of.p[i]));
  add(sum, -n / (n - 1) / mass, products(momentum, momentum));
  for_all_pairs(system, [&](std::size_t i, std::size_t j, Vec3 const& r) {
    add(sum, strength(i, j, norm(r)), products(r, r));
  });
  for (double& one : sum)
    one /= system.box.volume();
  return sum;
}

struct Fluid {
  std::string name;
  SimulationSettings settings;
};

template <class Method, class Species>
SimulationSettings with_species(SimulationSettings settings, std::vector<Species> species) {
  settings.as<Method>().species = std::move(species);
  return settings;
}

/// Disordered fluids in an oblong box, of one species and of two masses.
std::vector<Fluid> fluids() {
  auto soft = dpd_fluid(), warm = dpde_fluid(60), argon = sdpd::argon(100, 0.03);
  soft.lattice = warm.lattice = {7, 8, 9}, argon.lattice = {7, 8, 9};
  argon.disorder = 0.15;
  auto const heat = warm.as<Dpde>().internal_energy;
  auto const eos = argon.as<Sdpd>().eos;
  return {{"dpd", soft},
          {"dpde", warm},
          {"sdpd", argon},
          {"dpd of two", with_species<Dpd, DpdSpecies>(soft, {{"light", 0.5, 1}, {"heavy", 0.5, 3}})},
          {"dpde of two",
           with_species<Dpde, DpdeSpecies>(warm, {{"light", 0.5, 1, heat}, {"heavy", 0.5, 3, heat}})},
          {"sdpd of two",
           with_species<Sdpd, SdpdSpecies>(argon, {{"small", 0.5, 60, eos}, {"large", 0.5, 180, eos}})}};
}

std::function<double(std::size_t, std::size_t, double)> strength_in(System const& system) {
  if (!system.has_densities())
    return [](std::size_t, std::size_t, double r) { return soft_strength(r); };
  return [&system](std::size_t i, std::size_t j, double r) {
    auto const& of = system.particles;
    auto push = [&](std::size_t k) { return of.P[k] / (of.rho[k] * of.rho[k]); };
    return of.mass_of(i) * of.mass_of(j) * (push(i) + push(j)) *
           spline_strength(r, system.neighbours.range());
  };
}

TEST(PressureTensor, IsTheSumOverAllPairsAndATraceOfThePressure) {
  int compared = 0;
  for (auto const& [name, settings] : fluids())
    for (Vec3 const drift : {Vec3{}, Vec3{3, -2, 1}}) { // motion of the whole is no pressure
      auto const system = make_system(settings);
      for (int k = 0; k < 20; ++k, ++system->step)
        step(*system, settings.scheme, settings.dt);
      for (std::size_t i = 0; i < system->size(); ++i)
        system->particles.p[i] += drift * system->particles.mass_of(i);
      auto const ours = tensor_of(*system), exact = by_two_loops(*system, strength_in(*system));
      double const P = observe(*system).P;
      ASSERT_EQ(ours.size(), 6u);
      for (std::size_t c = 0; c < 6; ++c) {
        EXPECT_NEAR(ours[c], exact[c], 1e-10 * P) << name << ", " << c;
        EXPECT_GT(std::abs(exact[c]), 1e-6 * P) << name << ", " << c; // none is right by being nothing
        ++compared;
      }
      EXPECT_NEAR((ours[0] + ours[1] + ours[2]) / 3, P, 1e-12 * P) << name;
    }
  EXPECT_EQ(compared, 6 * 2 * 6);
}

/// What the fluid's energy gains in an affine strain r -> r + strain e_a (e_b . r) at constant entropies, but
/// for terms of its square: the pair energy, or the work P d(m/rho) of the densities.
double energy_gained(System const& system, std::size_t component, double strain) {
  std::size_t const a = std::vector<std::size_t>{0, 1, 2, 0, 0, 1}[component],
                    b = std::vector<std::size_t>{0, 1, 2, 1, 2, 2}[component];
  auto length = [&](Vec3 const& r, double by) {
    double x[]{r.x, r.y, r.z};
    x[a] += by * x[b];
    return std::hypot(x[0], x[1], x[2]);
  };
  auto const& of = system.particles;
  double gained = 0;
  for_all_pairs(system, [&](std::size_t i, std::size_t j, Vec3 const& r) {
    if (!system.has_densities()) {
      gained += soft_energy(length(r, strain)) - soft_energy(norm(r));
      return;
    }
    double const h = system.neighbours.range(), change = spline(length(r, strain), h) - spline(norm(r), h);
    auto work = [&](std::size_t k) { return of.mass_of(k) * of.P[k] / (of.rho[k] * of.rho[k]); };
    gained += (work(i) * of.mass_of(j) + work(j) * of.mass_of(i)) * change;
  });
  return gained;
}

TEST(PressureTensor, IsMinusTheSlopeOfTheEnergyInStrain) {
  constexpr double strain = 1e-5;
  int compared = 0;
  for (auto const& [name, settings] : fluids()) {
    auto const system = make_system(settings);
    std::ranges::fill(system->particles.p, Vec3{});
    auto const P = tensor_of(*system);
    for (std::size_t c = 0; c < 6; ++c) {
      double const slope =
          (energy_gained(*system, c, strain) - energy_gained(*system, c, -strain)) / (2 * strain);
      EXPECT_NEAR(P[c], -slope / system->box.volume(), 1e-6 * P[0]) << name << ", " << c;
      EXPECT_GT(std::abs(slope / system->box.volume()), 1e-5 * P[0]) << name << ", " << c;
      ++compared;
    }
  }
  EXPECT_EQ(compared, 6 * 6);
}

TEST(PressureTensor, OfAFluidAtRestIsIsotropic) {
  auto settings = dpd_fluid();
  settings.lattice = {7, 7, 7}, settings.seed = 5;
  Simulation simulation(settings);
  simulation.advance(500);
  std::vector<std::vector<double>> components(6);
  std::vector<double> P;
  for (int k = 0; k < 400; ++k) {
    simulation.advance(10);
    auto const now = simulation.measure(pressure_tensor());
    for (std::size_t c = 0; c < 6; ++c)
      components[c].push_back(now[c]);
    P.push_back(simulation.observe().P);
  }
  auto const whole = cg::estimate_mean(P);
  for (std::size_t c = 0; c < 6; ++c) {
    auto const one = cg::estimate_mean(components[c]);
    double const exact = c < 3 ? whole.mean : 0;
    EXPECT_GT(one.n_eff, 50) << c;
    EXPECT_TRUE(cg::agrees(one, exact, 5)) << c << ": " << one.mean << " +- " << one.se;
    EXPECT_FALSE(cg::agrees(one, exact + 0.05 * whole.mean, 5)) << c;
  }
}

} // namespace
} // namespace mesobridge::sdpd
