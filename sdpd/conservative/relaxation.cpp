#include "sdpd/conservative/relaxation.hpp"
#include "md/error.hpp"
#include "sdpd/conservative/conservative.hpp"
#include "sdpd/conservative/refresh.hpp"
#include <algorithm>
#include <cmath>
#include <gsl/gsl_fit.h>

namespace mesobridge::sdpd {
namespace {

constexpr int most_iterations = 20000;
constexpr double way = 0.1;     ///< that a particle goes at most in an iteration, in mean distances
constexpr double small = 1e-3;  ///< share of the thermal energy that may be left
constexpr int patience = 5;     ///< iterations downhill before the step grows
constexpr double mixing = 0.1;  ///< of the velocity with the force's direction, at first
constexpr double fading = 0.99; ///< of the mixing
constexpr double longer = 1.1, shorter = 0.5;

/// What the descent decides by; the momenta serve as velocities of unit masses.
struct Sums {
  double force2 = 0, velocity2 = 0, power = 0, largest_force = 0, largest_velocity = 0;
};

Sums sums_of(Particles const& particles) {
  Sums sums;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    Vec3 const &f = particles.f[i], &v = particles.p[i];
    sums.force2 += norm2(f), sums.velocity2 += norm2(v), sums.power += dot(f, v);
    sums.largest_force = std::max(sums.largest_force, norm(f));
    sums.largest_velocity = std::max(sums.largest_velocity, norm(v));
  }
  return sums;
}

/// Of pressures that depend on the particles' densities alone, by the law that was given.
class Descent {
 public:
  Descent(System& system, void (*find_pressures)(System&))
      : system_(system), spacing_(std::cbrt(system.box.volume() / static_cast<double>(system.size()))),
        find_pressures_(find_pressures) {
    stop();
    find_forces_at_rest();
    now_ = sums_of(system.particles);
  }

  Sums const& sums() const { return now_; }

  /// Until the sum of the squared forces is `enough`; the stiffness of the stiffest springs bounds the step.
  void run(double stiffness, double enough) {
    longest_dt_ = 1 / std::sqrt(stiffness), dt_ = 0.1 * longest_dt_;
    int iteration = 0;
    for (; now_.force2 > enough && iteration < most_iterations; ++iteration) {
      step(now_);
      now_ = sums_of(system_.particles);
    }
    if (iteration == most_iterations)
      throw PhysicsError(fmt::format("the start found no minimum of the free energy in {} iterations: the "
                                     "mean force is {:.3g} times what is small beside thermal ones",
                                     most_iterations, std::sqrt(now_.force2 / enough)));
    stop();
  }

 private:
  void stop() { std::fill(system_.particles.p.begin(), system_.particles.p.end(), Vec3{}); }

  void find_forces_at_rest() {
    refresh_lists(system_);
    refresh_by(system_, find_pressures_);
  }

  void step(Sums const& before) {
    if (before.power > 0) {
      if (++downhill_ > patience)
        dt_ = std::min(longer * dt_, longest_dt_), mixing_ *= fading;
    } else {
      stop();
      downhill_ = 0, dt_ *= shorter, mixing_ = mixing;
    }
    auto& particles = system_.particles;
    for (std::size_t i = 0; i < particles.size(); ++i)
      particles.p[i] += particles.f[i] * dt_;
    Sums const now = sums_of(particles);
    double const along = mixing_ * std::sqrt(now.velocity2 / now.force2);
    double const furthest = ((1 - mixing_) * now.largest_velocity + along * now.largest_force) * dt_;
    double const dt = dt_ * std::min(1.0, way * spacing_ / furthest);
    for (std::size_t i = 0; i < particles.size(); ++i) {
      particles.p[i] = (1 - mixing_) * particles.p[i] + along * particles.f[i];
      particles.q[i] += particles.p[i] * dt;
    }
    find_forces_at_rest();
  }

  System& system_;
  double spacing_;
  void (*find_pressures_)(System&);
  Sums now_;
  double dt_ = 0, longest_dt_ = 0, mixing_ = mixing;
  int downhill_ = 0;
};

/// Densities of a disordered start are those of no equation of state: they are evened out by P = rho^2 first,
/// until the forces are a hundredth of those of the start. Returns its stiffness: a force over the way that
/// it has to go.
double even_out(System& system) {
  constexpr double remainder = 0.01;
  auto const repulsion = [](System& of) {
    for (std::size_t i = 0; i < of.size(); ++i)
      of.particles.P[i] = of.particles.rho[i] * of.particles.rho[i];
  };
  Descent descent(system, repulsion);
  double const stiffness =
      descent.sums().largest_force / std::cbrt(system.box.volume() / static_cast<double>(system.size()));
  if (stiffness > 0)
    descent.run(stiffness, remainder * remainder * descent.sums().force2);
  return stiffness;
}

/// dP/drho of the particles, in the mean over them.
double compressibility_slope(Particles const& particles) {
  double offset, slope, cov_00, cov_01, cov_11, sum_of_squares;
  gsl_fit_linear(particles.rho.data(), 1, particles.P.data(), 1, particles.size(), &offset, &slope, &cov_00,
                 &cov_01, &cov_11, &sum_of_squares);
  return slope;
}

} // namespace

void relax(System& system) {
  double const of_repulsion = even_out(system), slope_of_repulsion = 2;
  if (of_repulsion == 0)
    return; // a perfect lattice
  Descent descent(system, response_from_temperature);
  double const slope = compressibility_slope(system.particles);
  if (!(slope > 0))
    throw PhysicsError(
        fmt::format("the start cannot settle: where the density rises, the pressure changes by "
                    "{:.3g} of it (reduced): such a fluid falls apart",
                    slope));
  double const stiffness = of_repulsion * slope / slope_of_repulsion;
  descent.run(stiffness, small * 3 * system.boltzmann * stiffness * static_cast<double>(system.size()));
}

} // namespace mesobridge::sdpd
