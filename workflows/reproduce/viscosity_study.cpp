#include "workflows/reproduce/viscosity_study.hpp"
#include "cg/equilibration.hpp"
#include "sdpd/method/mean_field_viscosity.hpp"
#include "sdpd/setup/equilibration.hpp"
#include "workflows/sdpd/short_series.hpp"
#include <numbers>

namespace mesobridge::workflows {
namespace {

/// In DPD particles fly half a cut-off, a spacing, before friction stops them: their wave is to be long.
constexpr std::array<std::uint32_t, 3> lattice{7, 7, 20}, long_lattice{7, 7, 40};
constexpr std::uint64_t every = 4;       ///< steps between two looks
constexpr double wanted_amplitude = 0.7; ///< of the flow, over the thermal velocity

/// Amplitudes of the wave of velocity and temperatures without it, look by look.
struct Looks {
  std::vector<double> amplitude, T_kin;
};

class Wave {
 public:
  explicit Wave(sdpd::SimulationSettings const& settings)
      : k_(2 * std::numbers::pi / sdpd::box_of(settings).edge.z), density_(std::pow(settings.spacing(), -3)),
        thermal_(1 / std::sqrt(settings.K())) {}

  double thermal() const { return thermal_; }
  /// The acceleration that a fluid of this viscosity answers with this amplitude.
  double force(double viscosity, double amplitude) const {
    return k_ * k_ * viscosity * amplitude / density_;
  }
  double viscosity(double force, double amplitude) const { return density_ * force / (k_ * k_ * amplitude); }

  void look(sdpd::Simulation const& simulation, Looks& looks) const {
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

Looks advance(sdpd::Simulation& simulation, Wave const& wave, double time, double dt,
              std::function<bool()> const& keep_going) {
  Looks looks;
  auto const count = static_cast<std::size_t>(std::ceil(time / (dt * static_cast<double>(every))));
  for (std::size_t k = 0; k < count; ++k) {
    simulation.advance(every);
    wave.look(simulation, looks);
    if (!keep_going())
      throw Interrupted("stopped while a viscosity was measured");
  }
  return looks;
}

cg::Estimate settled_mean(std::vector<double> const& series, std::size_t first) {
  return cg::estimate_mean(std::span(series).subspan(first));
}

sdpd::SimulationSettings argon(double K, double neighbours, double eta, std::uint64_t seed) {
  constexpr auto kernel = "wendland-c4";
  sdpd::Sdpd const fluid{.eos = fitting::material("argon").eos,
                         .K = K,
                         .kernel = kernel,
                         .density_correction = sdpd::glass_correction(kernel, neighbours),
                         .h_factor = std::cbrt(neighbours / (4 * std::numbers::pi / 3)),
                         .eta = eta};
  return {.method = fluid,
          .rho = 1150,
          .T = 1000,
          .lattice = lattice,
          .disorder = 0.15,
          .dt = K < 50 ? 0.03 : 0.05,
          .scheme = {.pairs = K < 50 ? "ems" : "ssa", .keep_energy = true},
          .seed = seed};
}

sdpd::PairFluid groot_and_warren() {
  return {.mass = 1, .potential = sdpd::SoftPotential(25, 1), .friction = sdpd::PowerFriction(4.5, 0, 1, 2)};
}

sdpd::SimulationSettings pair_fluid(sdpd::AnyMethod method, bool keep_energy, std::uint64_t seed) {
  return {.method = std::move(method),
          .rho = 3,
          .T = 1,
          .lattice = long_lattice,
          .disorder = 0.15,
          .dt = 0.02,
          .scheme = {.keep_energy = keep_energy},
          .seed = seed};
}

} // namespace

double relaxation_time(sdpd::SimulationSettings const& settings) {
  auto const viscosity = sdpd::mean_field_viscosity(settings).sum() / settings.units().viscosity();
  return 1 / Wave(settings).force(viscosity, 1);
}

MeasuredViscosity measure_viscosity(sdpd::SimulationSettings settings, double time,
                                    std::function<bool()> const& keep_going) {
  Wave const wave(settings);
  auto const units = settings.units();
  double const force_unit = units.velocity() / units.time();
  auto push = [&](double force) {
    settings.body_force = {.acceleration = {force * force_unit, 0, 0}, .across = 2, .waves = 1};
  };
  double force = wave.force(sdpd::mean_field_viscosity(settings).sum() / units.viscosity(),
                            wanted_amplitude * wave.thermal());
  push(force);
  sdpd::Simulation first(settings);
  sdpd::equilibrate(first, static_cast<std::uint64_t>(0.2 * time / settings.dt), keep_going);
  auto const pilot = advance(first, wave, 0.25 * time, settings.dt, keep_going);
  double const found = mean_of_series(std::span(pilot.amplitude).subspan(pilot.amplitude.size() / 2)).mean;
  constexpr double most = 8;
  force *= found > 0 ? std::clamp(wanted_amplitude * wave.thermal() / found, 1 / most, most) : most;
  push(force);
  sdpd::Simulation simulation(settings);
  simulation.begin_from(first.checkpoint());
  auto const looks = advance(simulation, wave, time, settings.dt, keep_going);
  auto const start = std::max(cg::detect_equilibration(looks.amplitude).start, looks.amplitude.size() / 10);
  auto const amplitude = settled_mean(looks.amplitude, start), T = settled_mean(looks.T_kin, start);
  if (!(amplitude.mean > 4 * amplitude.se))
    throw PhysicsError(
        fmt::format("it does not flow: the velocity that the force makes is {:.2g} ± {:.2g} of the "
                    "thermal one. Its particles have come to rest in an order of their own",
                    amplitude.mean / wave.thermal(), amplitude.se / wave.thermal()));
  double const eta = wave.viscosity(force, amplitude.mean) * units.viscosity();
  return {.viscosity = {eta, eta * amplitude.se / amplitude.mean, amplitude.n_eff},
          .T_kin = T,
          .amplitude = amplitude.mean / wave.thermal()};
}

std::vector<ViscosityCase> viscosity_cases(std::uint64_t seed) {
  std::vector<ViscosityCase> cases;
  for (double const eta : {2e-3, 2e-4})
    for (double const K : {10.0, 100.0, 1000.0})
      for (double const neighbours : {40.0, 65.0, 110.0})
        cases.push_back({"sdpd", K, neighbours, argon(K, neighbours, eta, seed)});
  double const neighbours = 4 * std::numbers::pi; // 3 per volume
  cases.push_back({"dpd", 0, neighbours, pair_fluid(sdpd::Dpd{groot_and_warren()}, false, seed)});
  cases.push_back(
      {"dpde", 0, neighbours,
       pair_fluid(sdpd::Dpde{groot_and_warren(), fitting::ConstantHeatCapacity(60)}, true, seed)});
  return cases;
}

} // namespace mesobridge::workflows
