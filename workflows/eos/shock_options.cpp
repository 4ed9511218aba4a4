#include "workflows/eos/shock_options.hpp"
#include "workflows/interrupt.hpp"
#include <CLI/CLI.hpp>

namespace mesobridge::workflows {

void ShockOptions::declare(CLI::App& app) {
  app.add_option("--vp", v_P, "Velocity of the piston, i.e. of the matter behind (SI: m/s)");
  app.add_option("--vs", v_S, "Instead: velocity of the front (SI: m/s)");
  app.add_option("--P", P, "Instead: pressure behind (SI: Pa)");
  app.add_option("--rho", rho, "Instead: density behind (SI: kg/m^3)");
  app.add_option("--P-max", P_max,
                 "Where the curve ends (SI: Pa); by default 1.2 times the pressure asked for");
  app.add_option("--points", points, "Points of the curve");
}

std::optional<fitting::Shock> ShockOptions::shock(fitting::Hugoniot const& hugoniot) const {
  int const given = int{v_P.has_value()} + int{v_S.has_value()} + int{P.has_value()} + int{rho.has_value()};
  require(given <= 1, "options --vp, --vs, --P, --rho", given, "at most one of them may be given");
  require(given == 1 || P_max, "options --vp, --vs, --P, --rho", given,
          "one of them must be given, or --P-max for the curve alone");
  require(points >= 2 && points <= 100000, "--points", points, "must lie between 2 and 100000");
  if (v_P)
    return hugoniot.from_piston(*v_P);
  if (v_S)
    return hugoniot.from_speed(*v_S);
  if (P)
    return hugoniot.from_pressure(*P);
  if (rho)
    return hugoniot.from_density(*rho);
  return std::nullopt;
}

std::vector<fitting::Shock> ShockOptions::curve(fitting::Hugoniot const& hugoniot,
                                                std::optional<fitting::Shock> const& asked) const {
  constexpr double further = 1.2;
  double const first = hugoniot.constant_volume_state().P, last = P_max ? *P_max : further * asked->behind.P;
  std::vector<fitting::Shock> shocks;
  for (int i = 1; i <= points; ++i) {
    throw_if_interrupted();
    shocks.push_back(hugoniot.from_pressure(first + (last - first) * i / points));
  }
  return shocks;
}

} // namespace mesobridge::workflows
