#include "sdpd/setup/viscosity_wave.hpp"
#include "cg/equilibration.hpp"
#include "md/error.hpp"
#include "sdpd/method/mean_field_viscosity.hpp"
#include "sdpd/setup/equilibration.hpp"
#include <algorithm>
#include <numbers>
#include <numeric>

namespace mesobridge::sdpd {
namespace {

constexpr std::uint64_t steps_between_looks = 4;

/// Amplitudes of the wave of velocity and temperatures without it, look by look.
struct Looks {
  std::vector<double> amplitude, T_kin;
};

class Wave {
 public:
  Wave(SimulationSettings const& settings, int waves)
      : k_(2 * std::numbers::pi * waves / box_of(settings).edge.z),
        density_(std::pow(settings.spacing(), -3)), thermal_(1 / std::sqrt(settings.K())) {}

  double thermal() const { return thermal_; }
  /// The acceleration that a fluid of this viscosity answers with this amplitude.
  double force(double viscosity, double amplitude) const {
    return k_ * k_ * viscosity * amplitude / density_;
  }
  double viscosity(double force, double amplitude) const { return density_ * force / (k_ * k_ * amplitude); }

  void look(Simulation const& simulation, Looks& looks) const {
    auto const now = simulation.snapshot();
    auto const n = static_cast<double>(now.q.size());
    double c = 0, cc = 0, vc = 0, square = 0;
    for (std::size_t i = 0; i < now.q.size(); ++i) {
      double const cosine = std::cos(k_ * now.q[i].z);
      c += cosine, cc += cosine * cosine, vc += cosine * now.p[i].x;
      square += norm2(now.p[i]);
    }
    double const amplitude = vc / cc; // the sum of the momenta is zero
    looks.amplitude.push_back(amplitude);
    looks.T_kin.push_back((square - amplitude * vc) / (3 * (n - 1) * thermal_ * thermal_));
  }

 private:
  double k_, density_, thermal_;
};

Looks advance(Simulation& simulation, Wave const& wave, double time, double dt,
              std::function<bool()> const& keep_going) {
  Looks looks;
  auto const count =
      static_cast<std::size_t>(std::ceil(time / (dt * static_cast<double>(steps_between_looks))));
  for (std::size_t k = 0; k < count; ++k) {
    simulation.advance(steps_between_looks);
    wave.look(simulation, looks);
    if (!keep_going())
      throw Interrupted("stopped while a viscosity was measured");
  }
  return looks;
}

double mean_of(std::span<double const> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// The wave's force, of so much (reduced).
void push(SimulationSettings& settings, double force, int waves) {
  double const unit = settings.units().velocity() / settings.units().time();
  settings.body_force = {.acceleration = {force * unit, 0, 0}, .across = 2, .waves = waves};
}

/// Reduced.
double expected_viscosity(SimulationSettings const& settings, ViscosityWave const& of) {
  return of.expected.value_or(mean_field_viscosity(settings).sum()) / settings.units().viscosity();
}

} // namespace

double relaxation_time(SimulationSettings const& settings, ViscosityWave const& of) {
  return 1 / Wave(settings, of.waves).force(expected_viscosity(settings, of), 1);
}

Checkpoint state_before_waves(SimulationSettings settings, double time,
                              std::function<bool()> const& keep_going) {
  push(settings, 1, 1); // held until the equilibrium is found
  Simulation simulation(settings);
  equilibrate(simulation, static_cast<std::uint64_t>(std::ceil(time / settings.dt)), keep_going);
  return simulation.checkpoint();
}

MeasuredViscosity measure_viscosity(SimulationSettings settings, double time,
                                    std::function<bool()> const& keep_going, ViscosityWave const& of) {
  Wave const wave(settings, of.waves);
  double const wanted = of.amplitude * wave.thermal();
  double force = wave.force(expected_viscosity(settings, of), wanted);
  push(settings, force, of.waves);
  Simulation first(settings);
  if (of.start)
    first.begin_from(*of.start);
  else
    equilibrate(first, static_cast<std::uint64_t>(0.2 * time / settings.dt), keep_going);
  auto const before = first.step();
  auto const pilot = advance(first, wave, 0.25 * time, settings.dt, keep_going);
  double const found = mean_of(std::span(pilot.amplitude).subspan(pilot.amplitude.size() / 2));
  constexpr double most = 8;
  force *= found > 0 ? std::clamp(wanted / found, 1 / most, most) : most;
  push(settings, force, of.waves);
  Simulation simulation(settings);
  simulation.begin_from(first.checkpoint());
  auto const looks = advance(simulation, wave, time, settings.dt, keep_going);
  auto const start = std::max(cg::detect_equilibration(looks.amplitude).start, looks.amplitude.size() / 10);
  auto const amplitude = cg::estimate_mean(std::span(looks.amplitude).subspan(start)),
             T = cg::estimate_mean(std::span(looks.T_kin).subspan(start));
  if (!(amplitude.mean > 4 * amplitude.se))
    throw PhysicsError(
        fmt::format("it does not flow: the velocity that the force makes is {:.2g} ± {:.2g} of the "
                    "thermal one. Its particles have come to rest in an order of their own",
                    amplitude.mean / wave.thermal(), amplitude.se / wave.thermal()));
  double const eta = wave.viscosity(force, amplitude.mean) * settings.units().viscosity();
  return {.viscosity = {eta, eta * amplitude.se / amplitude.mean, amplitude.n_eff},
          .T_kin = T,
          .amplitude = amplitude.mean / wave.thermal(),
          .steps = simulation.step() - before};
}

} // namespace mesobridge::sdpd
