#include "workflows/reproduce/sound_wave.hpp"
#include "fitting/fluid.hpp"
#include "md/error.hpp"
#include "sdpd/simulation.hpp"
#include "workflows/sdpd/settings.hpp"
#include <numbers>

namespace mesobridge::workflows {
namespace {

/// What damps the wave, in its frequency.
constexpr double relative_damping = 0.02;

fitting::EosState state_of(std::string const& eos, double rho, double T) {
  return fitting::Fluid(fitting::material(eos).eos).at_temperature(rho, T);
}

/// Puts v sin(k z) on particles that were at rest.
void start_wave(sdpd::Simulation& simulation, double v, double k) {
  auto start = simulation.checkpoint();
  for (std::size_t i = 0; i < start.particles.size(); ++i)
    start.particles.p[i].z += start.particles.mass_of(i) * v * std::sin(k * start.particles.q[i].z);
  simulation.restore(start);
}

double amplitude(sdpd::Snapshot const& now, double k) {
  double sum = 0;
  for (std::size_t i = 0; i < now.q.size(); ++i)
    sum += now.p[i].z * std::sin(k * now.q[i].z);
  return 2 * sum / static_cast<double>(now.q.size());
}

/// Frequency and damping of a decaying oscillation, which obeys M_(n+1) = a M_n - b M_(n-1) at equal
/// intervals: least squares of a and b, b = exp(-2 Gamma tau), a = 2 exp(-Gamma tau) cos(omega tau).
std::pair<double, double> frequency_and_damping(std::vector<double> const& M, double tau) {
  double xx = 0, xy = 0, yy = 0, xz = 0, yz = 0;
  for (std::size_t n = 1; n + 1 < M.size(); ++n) {
    double const x = M[n], y = -M[n - 1], z = M[n + 1];
    xx += x * x, xy += x * y, yy += y * y, xz += x * z, yz += y * z;
  }
  double const determinant = xx * yy - xy * xy;
  double const a = (xz * yy - yz * xy) / determinant, b = (yz * xx - xz * xy) / determinant;
  return {std::acos(a / (2 * std::sqrt(b))) / tau, -std::log(b) / (2 * tau)};
}

} // namespace

Scene sound_scene(std::string const& eos, double rho, double T, std::int64_t n) {
  auto const state = state_of(eos, rho, T);
  constexpr double spacing = 1e-6; // nothing depends on it
  double const m0 =
      std::visit([](auto const& of) { return of.molecular_mass(); }, fitting::material(eos).eos);
  double const k = 2 * std::numbers::pi / (static_cast<double>(n) * spacing);
  Scene scene;
  scene.title = "A wave of sound";
  scene.fluid = {.eos = eos, .rho = rho, .T = T};
  scene.particles = {.N = 100 * n, .K = rho * std::pow(spacing, 3) / m0, .h_factor = 4, .disorder = 0};
  scene.particles.density = "plain";
  scene.box.lattice = {10, 10, n};
  scene.transport.eta = 0.75 * 2 * relative_damping * rho * state.sound_speed.value() / k;
  scene.method.name = "sph";
  scene.scheme.dt = {.value = 0.1 * spacing / state.sound_speed.value(), .reduced = false};
  return scene;
}

SoundWave measure_sound(Scene const& scene, std::int64_t n, int threads,
                        std::function<bool(double)> const& keep_going) {
  auto const settings = settings_of(scene, threads);
  auto const units = settings.units();
  sdpd::Simulation simulation(settings);
  double const edge = simulation.box().edge.z, k = 2 * std::numbers::pi / edge;
  auto const state = state_of(scene.fluid.eos, scene.fluid.rho, scene.fluid.T);
  double const c = state.sound_speed.value() / units.velocity();
  start_wave(simulation, 1e-3 * c, k);
  double const period = edge / c;
  auto const between = static_cast<std::uint64_t>(std::llround(period / 40 / settings.dt));
  constexpr int samples = 80;
  std::vector<double> M{amplitude(simulation.snapshot(), k)};
  for (int s = 0; s < samples; ++s) {
    if (!keep_going(static_cast<double>(s) / samples))
      throw Interrupted("stopped");
    simulation.advance(between);
    M.push_back(amplitude(simulation.snapshot(), k));
  }
  auto const [omega, damping] = frequency_and_damping(M, static_cast<double>(between) * settings.dt);
  double const undamped = std::sqrt(omega * omega + damping * damping);
  double const viscosity = (4 * scene.transport.eta / 3 + scene.transport.zeta) / units.viscosity();
  return {.n = n,
          .c = undamped / k * units.velocity(),
          .c_exact = state.sound_speed.value(),
          .damping = damping / units.time(),
          .damping_exact = 0.5 * k * k * viscosity / units.time()};
}

} // namespace mesobridge::workflows
