#include "fitting/taylor_wave.hpp"
#include "fitting/isentrope.hpp"
#include "fitting/root.hpp"

namespace mesobridge::fitting {

std::vector<TaylorPoint> taylor_wave(Fluid const& products, Shock const& chapman_jouguet, double wall,
                                     int points) {
  if (!(wall < chapman_jouguet.v_P))
    throw InputError(
        fmt::format("a wall at {:.6g} supports the detonation, whose products move at {:.6g}: no "
                    "rarefaction follows it",
                    wall, chapman_jouguet.v_P));
  auto const& cj = chapman_jouguet.behind;
  Isentrope const isentrope(products, cj);
  auto const u = [&](double rho) { return chapman_jouguet.v_P - isentrope.velocity_change(rho, cj.rho); };
  double thin = cj.rho;
  for (double u_thin = chapman_jouguet.v_P; u_thin > wall; u_thin = u(thin))
    thin *= 0.9;
  double const rest = bracketed_zero([&](double rho) { return u(rho) - wall; }, thin, u(thin) - wall, cj.rho,
                                     chapman_jouguet.v_P - wall);
  std::vector<TaylorPoint> wave;
  for (int k = 0; k < points; ++k) {
    double const rho = cj.rho + (rest - cj.rho) * k / (points - 1);
    auto const state = isentrope.at_density(rho);
    if (!state.sound_speed)
      throw PhysicsError(
          fmt::format("the products have no speed of sound at density {:.6g} of their release", rho));
    wave.push_back({(u(rho) + *state.sound_speed) / chapman_jouguet.v_S, u(rho), state});
  }
  return wave;
}

} // namespace mesobridge::fitting
