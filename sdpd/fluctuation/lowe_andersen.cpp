#include "sdpd/fluctuation/isothermal_sweep.hpp"
#include "sdpd/fluctuation/pair_integrator.hpp"

namespace mesobridge::sdpd {
namespace {

/// Draws the relative velocity of a pair anew from Maxwell's distribution, along the line of centres with the
/// chance 1 - alpha of its exact step, and across it with that of its friction there: one uniform number
/// decides both.
struct Redraw {
  using Steps = Bath<FloatLanes>::Directions;
  SweepNoise const& noise;
  float thermal; ///< variance of the velocity at equilibrium

  Steps operator()(Steps const& exact, PairGroup const& group) const {
    Steps drawn{};
    for (std::size_t l = 0; l < group.count; ++l) {
      auto const pair = group.pairs[l];
      auto anew = [&](OrnsteinUhlenbeck<FloatLanes> const& of, OrnsteinUhlenbeck<FloatLanes>& made) {
        if (happens(-of.decay[l], group.ids[pair.i], group.ids[pair.j], group.bits[l]))
          made.decay[l] = -1, made.variance[l] = thermal;
      };
      anew(exact.par, drawn.par), anew(exact.perp, drawn.perp);
    }
    return drawn;
  }

 private:
  /// Whether the pair's uniform number, whose first bits are spare ones, is below the chance.
  bool happens(double chance, std::uint32_t a, std::uint32_t b, std::uint32_t bits) const {
    double const level = chance * (1u << spare_bits);
    return bits + 1 <= level || (bits < level && noise.uniform(a, b, bits) < chance);
  }
};

template <class Law>
void redraw(System& system, Law const& law, double dt, bool second) {
  if constexpr (Law::has_energies) {
    throw std::logic_error("Lowe and Andersen's thermostat for particles with internal energies");
  } else {
    Sweep<Law> const sweep{law, dt, SweepNoise::of_fluctuation(system, second)};
    sweep_isothermal(system, sweep, Redraw{sweep.noise, law.template bath<FloatLanes>().thermal[0]});
  }
}

} // namespace

/// The thermostat of Lowe and Andersen (sdpd/README.md, Eq. (S35)).
PairIntegrator lowe_andersen_integrator() {
  using enum Conserved;
  return {.name = "lowe-andersen",
          .summary = "a pair's velocity is now and then drawn anew from Maxwell's distribution",
          .sweep =
              [](System& system, double dt, bool second) {
                std::visit([&](auto const& law) { redraw(system, law, dt, second); }, system.law);
              },
          .conserves = {positions, momentum},
          .noise = {fluctuation_noise, acceptance_noise},
          .needs = {.no_internal_energies = "they would not be given what the bath takes"}};
}

} // namespace mesobridge::sdpd
