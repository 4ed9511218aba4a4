#pragma once
#include "cg/transverse_currents.hpp"
#include <cmath>
#include <numbers>
#include <random>

namespace mesobridge::cg {

/// Molecules on a lattice, whose momenta are waves: each transverse one dies away as x of x' = -(a/T)^1/2 y,
/// y' = (a/T)^1/2 x - y/T + noise, whose <x x(t)> is the viscoelastic decay with the rate a = eta(k) k^2/rho
/// and the memory T; the longitudinal ones die away otherwise. By exact steps.
struct HydrodynamicModes {
  double eta = 1.3, slope = -0.15, memory = 0.4, mass = 2.5, kT = 1.7, interval = 0.2;
  std::size_t frames = 4000;
  Vec3 edge = {6, 6, 6}, drift = {};
  int sites = 6; ///< along each edge

  double density() const { return mass * std::pow(sites, 3) / (edge.x * edge.y * edge.z); }
  double eta_of(double k) const { return eta + slope * k * k; }

  /// x and y of one mode, of variance one each.
  class Mode {
   public:
    Mode(double rate, double memory, double interval, std::mt19937_64& generator) {
      double const g = std::sqrt(rate / memory), h = interval / 1024; // the exponential by ten doublings
      double m[4] = {0, -g * h, g * h, -h / memory};
      double step[4] = {1 + m[0] + m[1] * m[2] / 2, m[1] + m[1] * m[3] / 2, m[2] + m[3] * m[2] / 2,
                        1 + m[3] + (m[2] * m[1] + m[3] * m[3]) / 2};
      for (int doubling = 0; doubling < 10; ++doubling) {
        double const a = step[0], b = step[1], c = step[2], d = step[3];
        step[0] = a * a + b * c, step[1] = a * b + b * d, step[2] = c * a + d * c, step[3] = c * b + d * d;
      }
      for (int entry = 0; entry < 4; ++entry)
        E[entry] = step[entry];
      double const xx = 1 - E[0] * E[0] - E[1] * E[1], xy = -E[0] * E[2] - E[1] * E[3],
                   yy = 1 - E[2] * E[2] - E[3] * E[3];
      L[0] = std::sqrt(xx), L[1] = xy / L[0], L[2] = std::sqrt(std::max(0.0, yy - L[1] * L[1]));
      x = G(generator), y = G(generator);
    }
    double next(std::mt19937_64& generator) {
      double const now = x, before = y, g = G(generator), h = G(generator);
      x = E[0] * now + E[1] * before + L[0] * g;
      y = E[2] * now + E[3] * before + L[1] * g + L[2] * h;
      return now;
    }

   private:
    double E[4], L[3], x, y;
    std::normal_distribution<double> G;
  };

  BlobSeries series(unsigned seed) const {
    std::mt19937_64 generator(seed);
    Box const box{edge};
    std::size_t const N = std::size_t(sites * sites * sites);
    BlobSeries all{.molecules = N, .atoms = 1, .mass = mass};
    std::vector<Vec3> place;
    for (int x = 0; x < sites; ++x)
      for (int y = 0; y < sites; ++y)
        for (int z = 0; z < sites; ++z)
          place.push_back({edge.x * x / sites, edge.y * y / sites, edge.z * z / sites});
    std::vector<Mode> modes;
    std::vector<std::vector<Vec3>> shapes; // of each mode at each site
    double const amplitude = std::sqrt(2 * mass * kT / double(N));
    for (auto const& shell : wave_shells(box, 2))
      for (auto const& n : shell.vectors) {
        double const turn = 2 * std::numbers::pi;
        Vec3 const k{turn * n[0] / edge.x, turn * n[1] / edge.y, turn * n[2] / edge.z}, along = k / norm(k);
        Vec3 first = Vec3{0.3, 0.5, -0.8} - dot(Vec3{0.3, 0.5, -0.8}, along) * along;
        first = first / norm(first);
        Vec3 const second{along.y * first.z - along.z * first.y, along.z * first.x - along.x * first.z,
                          along.x * first.y - along.y * first.x};
        for (Vec3 const& direction : {first, second, 3 * along})
          for (double const phase : {0.0, 0.5 * std::numbers::pi}) {
            bool const is_transverse = direction == first || direction == second;
            modes.emplace_back(is_transverse ? eta_of(norm(k)) * dot(k, k) / density() : 7.0, memory,
                               interval, generator);
            auto& shape = shapes.emplace_back();
            for (Vec3 const& R : place)
              shape.push_back(amplitude * std::cos(dot(k, R) + phase) * direction);
          }
      }
    for (std::size_t f = 0; f < frames; ++f) {
      all.times.push_back(interval * double(f)), all.boxes.push_back(box);
      std::vector<Vec3> P(N, mass * drift);
      for (std::size_t m = 0; m < modes.size(); ++m) {
        double const now = modes[m].next(generator);
        for (std::size_t i = 0; i < N; ++i)
          P[i] += now * shapes[m][i];
      }
      all.P.insert(all.P.end(), P.begin(), P.end());
      for (auto const& R : place)
        all.R.push_back(box.wrap(R + drift * (interval * double(f))));
    }
    return all;
  }
};

} // namespace mesobridge::cg
