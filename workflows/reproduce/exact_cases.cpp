#include "workflows/reproduce/exact_cases.hpp"
#include "fitting/riemann.hpp"
#include <algorithm>

namespace mesobridge::workflows {
namespace {

constexpr double length = 1e-3;                             ///< of the tube [m]; nothing depends on it
constexpr double R_air = 0.4 * fitting::air_parameters.c_v; ///< [J/(kg K)]
constexpr double rho_unit = 1, T_unit = 300;                ///< of the published numbers
double const u_unit = std::sqrt(R_air * T_unit);            ///< then P_unit = rho_unit u_unit^2

/// Air by density, velocity and pressure in the units above.
TubeSide air(double rho, double u, double P) {
  return {"air", rho * rho_unit, P / rho * T_unit, u * u_unit};
}

fitting::RiemannSide side_of(TubeSide const& side) {
  fitting::Fluid const fluid(fitting::material(side.eos).eos);
  return {fluid, fluid.at_temperature(side.rho, side.T), side.u};
}

/// Mass per area and time through the strongest shock; a tenth of that of sound where there is none.
double flux_of(fitting::RiemannSolution const& exact, fitting::RiemannSide const& left,
               fitting::RiemannSide const& right) {
  double flux = 0.1 * std::max(left.state.rho * left.state.sound_speed.value(),
                               right.state.rho * right.state.sound_speed.value());
  if (exact.left_shock())
    flux = std::max(flux, left.state.rho * (left.u - exact.left_wave().head));
  if (exact.right_shock())
    flux = std::max(flux, right.state.rho * (exact.right_wave().head - right.u));
  return flux;
}

/// Of tests/hydro_tests/test_adsod.py and adsod.dat of GANDALF: a time of 0.75, places from -1 to 1.
StatedError of_gandalf() {
  return {.program = "GANDALF",
          .where =
              "its test of this tube (github.com/gandalfcode/gandalf, tests/hydro_tests/test_adsod.py: "
              "512 and 128 particles along the halves, 227 of them in the rarefaction, where here 0.31 of "
              "those along the tube are)",
          .reach = u_unit / 0.75,
          .unit = u_unit,
          .below = 9e-3};
}

} // namespace

double error_as_stated(StatedError const& stated, RiemannComparison const& found, double membrane) {
  double mass = 0, sum = 0;
  for (std::size_t k = 0; k < found.place.size(); ++k)
    if (std::abs(found.place[k] - membrane) < stated.reach * found.time)
      mass += found.rho[k], sum += found.rho[k] * std::abs(found.u[k] - found.exact[k].u);
  return sum / mass / stated.unit;
}

std::vector<TubeCase> const& tube_cases() {
  static std::vector<TubeCase> const cases{
      {"sod", "Sod's shock tube", air(1, 0, 1), air(0.125, 0, 0.1)},
      {"double-rarefaction", "Two rarefactions that leave almost a vacuum (Toro's problem 2)",
       air(1, -2, 0.4), air(1, 2, 0.4)},
      {"blast", "A strong blast, pressures 1000 to 0.01 (Toro's problem 3)", air(1, 0, 1000),
       air(1, 0, 0.01)},
      {"noh", "Two streams of cold gas that meet (Noh)", air(1, 1, 1e-6), air(1, -1, 1e-6)},
      {"water-air", "Compressed water against air", {"water", 1100, 300, 0}, {"air", 50, 300, 0}},
      {"mild", "A milder tube, that of a test of GANDALF", air(1, 0, 1), air(0.25, 0, 0.1975), of_gandalf()}};
  return cases;
}

Scene tube_scene(TubeCase const& of, std::int64_t n) {
  auto const left = side_of(of.left), right = side_of(of.right);
  fitting::RiemannSolution const exact(left, right);
  double const spacing = length / static_cast<double>(n), mass = of.left.rho * std::pow(spacing, 3);
  auto const m0 = [](TubeSide const& side) {
    return std::visit([](auto const& eos) { return eos.molecular_mass(); }, fitting::material(side.eos).eos);
  };
  double fastest = std::max({exact.left_of_contact().sound_speed.value(),
                             exact.right_of_contact().sound_speed.value(), std::abs(exact.u())});
  for (auto const& side : {left, right})
    fastest = std::max({fastest, side.state.sound_speed.value(), std::abs(side.u)});
  double const first = RiemannProblem{2, 0.5 * length, length, exact, {}, 0}.end();
  double const time = 0.8 * first, dt = 0.1 * spacing / fastest;
  Scene scene;
  scene.title = of.title;
  scene.fluid = {.eos = of.left.eos, .rho = of.left.rho, .T = of.left.T};
  scene.particles = {.K = mass / m0(of.left), .h_factor = 3.3, .disorder = 0.2};
  scene.particles.density = "plain";
  scene.box.size = {9 * spacing, 9 * spacing, length};
  scene.box.z = of.left.u != 0 || of.right.u != 0 ? "open" : "walls";
  auto const region = [&](TubeSide const& side) {
    Scene::Region half{.name = side.u > 0 ? "up" : side.u < 0 ? "down" : "at rest", .shape = "slab"};
    half.eos = side.eos, half.rho = side.rho, half.T = side.T, half.velocity = {0, 0, side.u};
    half.K = side.rho * std::pow(spacing, 3) / m0(side);
    return half;
  };
  scene.regions = {region(of.left), region(of.right)};
  scene.regions[0].to = scene.regions[1].from = {{50, true}};
  scene.transport.eta = 0.75 * 0.5 * flux_of(exact, left, right) * spacing; // Re_l = 2
  auto const steps = static_cast<std::int64_t>(std::ceil(time / dt));
  scene.scheme.dt = {.value = time / static_cast<double>(steps), .reduced = false};
  scene.method.name = "sph";
  scene.run = {.steps = steps, .sample_every = std::max<std::int64_t>(1, steps / 40)};
  scene.profile = {.axis = "z", .bins = n / 2, .every = steps};
  return scene;
}

} // namespace mesobridge::workflows
