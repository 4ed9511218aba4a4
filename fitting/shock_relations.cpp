#include "fitting/shock_relations.hpp"
#include "fitting/root.hpp"
#include <algorithm>

namespace mesobridge::fitting {
namespace {

// Solutions are looked for along z = rho/rho_0 - 1 by steps of this ratio. A fluid of gamma = 1.0001 can be
// compressed 20000-fold.
constexpr double step_ratio = 1.2;
constexpr double largest_z = 1e5;

// A weak shock is sonic on both sides to within z, and z itself is uncertain by the round-off of P: neither
// must make it a refusal.
double sonic_tolerance(double z) {
  constexpr double least = 1e-7, round_off = 1e-14;
  return least + round_off / z;
}

} // namespace

Hugoniot::Hugoniot(Fluid fluid, EosState const& ahead)
    : fluid_(std::move(fluid)), ahead_(ahead), q_(0), reacts_(false) {
  if (!(ahead.sound_speed_squared > 0))
    throw PhysicsError(
        fmt::format("no shock can run into density {}, temperature {}: the fluid is mechanically "
                    "unstable there, sound speed^2 = {}",
                    ahead.rho, ahead.T, ahead.sound_speed_squared));
}

Hugoniot::Hugoniot(EosState const& ahead, Fluid products, double q)
    : fluid_(std::move(products)), ahead_(ahead), q_(q), reacts_(true) {
  require(std::isfinite(q), "heat of reaction q", q, "must be finite");
}

void Hugoniot::refuse(std::string const& asked, std::string const& why) const {
  throw PhysicsError(fmt::format("no {} with {} into density {}, temperature {}: {}",
                                 reacts_ ? "detonation" : "shock", asked, ahead_.rho, ahead_.T, why));
}

double Hugoniot::greatest_compression() const {
  return std::min(largest_z, fluid_.domain().rho_max / ahead_.rho - 1);
}

Shock Hugoniot::shock(double rho, double e) const {
  auto const behind = fluid_.at_energy(rho, e);
  double const dP = behind.P - ahead_.P, dv = 1 / ahead_.rho - 1 / rho;
  if (!(dP > 0 && dv > 0))
    throw PhysicsError(fmt::format("density {}, pressure {} cannot be reached by a compression from density "
                                   "{}, pressure {}",
                                   rho, behind.P, ahead_.rho, ahead_.P));
  return {
      .ahead = ahead_, .behind = behind, .v_S = std::sqrt(dP / dv) / ahead_.rho, .v_P = std::sqrt(dP * dv)};
}

void Hugoniot::require_shock(Shock const& found, std::string const& asked) const {
  if (!found.behind.sound_speed)
    refuse(asked, "the fluid behind would be mechanically unstable");
  constexpr double entropy_round_off = 1e-9;
  double const ds = found.behind.s - found.ahead.s;
  if (!reacts_ && ds < -entropy_round_off * (std::abs(found.ahead.s) + found.ahead.c_v))
    refuse(asked, fmt::format("its entropy would fall by {} (the fluid is not convex)", -ds));
  double const tolerance = sonic_tolerance(found.behind.rho / found.ahead.rho - 1);
  double const mach_ahead = reacts_ ? 2 : found.v_S / *ahead_.sound_speed;
  double const mach_behind = (found.v_S - found.v_P) / *found.behind.sound_speed;
  if (!(mach_ahead > 1 - tolerance))
    refuse(asked, fmt::format("its Mach number ahead would be {} < 1 (the fluid is not convex)", mach_ahead));
  if (!(mach_behind < 1 + tolerance))
    refuse(asked, reacts_
                      ? fmt::format("it would be a weak one, its Mach number behind being {} > 1; a front "
                                    "driven less than the Chapman-Jouguet one runs like that one",
                                    mach_behind)
                      : fmt::format("its Mach number behind would be {} > 1 (the fluid is not convex)",
                                    mach_behind));
}

Shock Hugoniot::from_piston(double v_P) const {
  require(v_P > 0 && std::isfinite(v_P), "piston velocity v_P", v_P, "must be > 0 and finite");
  // Mass and momentum give P, and with it the energy, for each compression: one equation is left.
  auto const energy = [&](double z) { return ahead_.e + q_ + ahead_.P * volume_change(z) + 0.5 * v_P * v_P; };
  auto const excess = [&](double z) {
    return fluid_.pressure(density(z), energy(z)) - ahead_.P - v_P * v_P / volume_change(z);
  };
  double const first = 1e-3 * v_P / (v_P + ahead_.sound_speed.value_or(v_P));
  auto const z = first_rising_zero(excess, first, greatest_compression(), step_ratio);
  auto const asked = fmt::format("v_P = {}", v_P);
  if (!z)
    refuse(asked, "the state behind would lie outside the model; " + fluid_.domain().edge);
  auto found = shock(density(*z), energy(*z));
  // z fixes the velocities to round-off even where the pressure behind has lost digits.
  found.v_P = v_P;
  found.v_S = v_P * (1 + *z) / *z;
  require_shock(found, asked);
  return found;
}

Shock Hugoniot::from_speed(double v_S) const {
  require(v_S > 0 && std::isfinite(v_S), "shock velocity v_S", v_S, "must be > 0 and finite");
  auto const asked = fmt::format("v_S = {}", v_S);
  double first = 0;
  if (reacts_) {
    auto const cj = chapman_jouguet();
    if (v_S < cj.v_S)
      refuse(asked, fmt::format("the slowest detonation, that of Chapman and Jouguet, runs at {}", cj.v_S));
    first = cj.behind.rho / ahead_.rho - 1;
  } else {
    if (!(v_S > *ahead_.sound_speed))
      refuse(asked, fmt::format("it must exceed the sound speed {} ahead", *ahead_.sound_speed));
    first = 1e-3 * std::min(1.0, v_S / *ahead_.sound_speed - 1);
  }
  double const momentum = ahead_.rho * ahead_.rho * v_S * v_S;
  auto const energy = [&](double z) {
    double const dv = volume_change(z);
    return ahead_.e + q_ + (ahead_.P + 0.5 * momentum * dv) * dv;
  };
  auto const excess = [&](double z) {
    return fluid_.pressure(density(z), energy(z)) - ahead_.P - momentum * volume_change(z);
  };
  // At the Chapman-Jouguet velocity itself the line only touches the curve.
  if (reacts_ && excess(first) >= 0)
    return chapman_jouguet();
  auto const z = first_rising_zero(excess, first, greatest_compression(), step_ratio);
  if (!z)
    refuse(asked, "the state behind would lie outside the model; " + fluid_.domain().edge);
  auto found = shock(density(*z), energy(*z));
  found.v_S = v_S;
  found.v_P = v_S * *z / (1 + *z);
  require_shock(found, asked);
  return found;
}

Shock Hugoniot::from_pressure(double P) const {
  double const P_first = reacts_ ? constant_volume_state().P : ahead_.P;
  auto const asked = fmt::format("pressure {} behind", P);
  if (!(P > P_first && std::isfinite(P)))
    refuse(asked, fmt::format("the curve begins at pressure {}", P_first));
  auto const energy = [&](double z) { return ahead_.e + q_ + 0.5 * (ahead_.P + P) * volume_change(z); };
  auto const excess = [&](double z) { return fluid_.pressure(density(z), energy(z)) - P; };
  double const stiffness = reacts_ ? P : ahead_.rho * ahead_.sound_speed_squared;
  double const first = 1e-3 * (P - P_first) / (P - P_first + stiffness);
  auto const z = first_rising_zero(excess, first, greatest_compression(), step_ratio);
  if (!z)
    refuse(asked, "the state behind would lie outside the model; " + fluid_.domain().edge);
  auto found = shock(density(*z), energy(*z));
  found.v_P = std::sqrt((P - ahead_.P) * volume_change(*z));
  found.v_S = found.v_P * (1 + *z) / *z;
  if (!reacts_)
    require_shock(found, asked);
  return found;
}

Shock Hugoniot::at_compression(double z) const {
  double const rho = density(z);
  auto const asked = fmt::format("density {} behind", rho);
  // H(T) = e - e_0 - q - (P_0 + P)(v_0 - v)/2 rises from below zero: an isentropic compression falls short of
  // the heat of a shock. Products may have any temperature.
  constexpr double below_isentrope = 0.9, coldest = 1e-6, hottest = 1e9; // the latter two times T ahead
  double const T_isentropic = reacts_ ? coldest * ahead_.T : fluid_.at_entropy(rho, ahead_.s).T;
  auto const domain = fluid_.domain();
  double const first = std::max(domain.T_min, below_isentrope * T_isentropic);
  double const last = std::min(domain.T_max, hottest * (ahead_.T + T_isentropic));
  auto const excess = [&](double T) {
    auto const state = fluid_.at_temperature(rho, T);
    return state.e - ahead_.e - q_ - 0.5 * (ahead_.P + state.P) * volume_change(z);
  };
  auto const T = first_rising_zero(excess, first, last, step_ratio);
  if (!T)
    refuse(asked, reacts_ ? "the products would be below T = 0 or beyond their greatest compression"
                          : "it is beyond the greatest compression by one shock, or outside the model; " +
                                domain.edge);
  return shock(rho, fluid_.at_temperature(rho, *T).e);
}

Shock Hugoniot::from_density(double rho) const {
  auto const asked = fmt::format("density {} behind", rho);
  if (!(rho > ahead_.rho && rho <= fluid_.domain().rho_max))
    refuse(asked, fmt::format("it must lie above that ahead and up to {}", fluid_.domain().rho_max));
  auto const found = at_compression(rho / ahead_.rho - 1);
  if (!reacts_)
    require_shock(found, asked);
  return found;
}

EosState Hugoniot::constant_volume_state() const {
  return reacts_ ? fluid_.at_energy(ahead_.rho, ahead_.e + q_) : ahead_;
}

Shock Hugoniot::chapman_jouguet() const {
  if (!reacts_)
    throw std::logic_error("a Chapman-Jouguet state needs products and their heat of reaction");
  // On the way up from combustion at constant volume, where D is infinite, the products leave the front
  // faster than sound until the Chapman-Jouguet state is passed.
  auto const subsonic = [&](double z) {
    auto const at_z = at_compression(z);
    if (!at_z.behind.sound_speed)
      throw PhysicsError("the products are mechanically unstable");
    return 1 - (at_z.v_S - at_z.v_P) / *at_z.behind.sound_speed;
  };
  constexpr double first = 1e-4;
  auto const z = first_rising_zero(subsonic, first, greatest_compression(), step_ratio);
  if (!z)
    refuse("a sonic state of the products",
           fmt::format("with q = {} the Crussard curve has none inside the model; {}", q_,
                       fluid_.domain().edge));
  return at_compression(*z);
}

CjChecks Hugoniot::check(Shock const& cj) const {
  double const z = cj.behind.rho / ahead_.rho - 1;
  auto const D_excess = [&](double factor) { return at_compression(factor * z).v_S / cj.v_S - 1; };
  double neighbours = std::numeric_limits<double>::infinity();
  for (double const factor : {0.99, 0.999, 1.001, 1.01})
    neighbours = std::min(neighbours, D_excess(factor));
  double const h = 1e-4 * z;
  auto const below = at_compression(z - h).behind, above = at_compression(z + h).behind;
  double const curve = (above.P - below.P) / (1 / above.rho - 1 / below.rho);
  double const line = (cj.behind.P - ahead_.P) / (1 / cj.behind.rho - 1 / ahead_.rho);
  return {.tangency = curve / line - 1, .neighbours = neighbours};
}

double Hugoniot::rayleigh_pressure(double v_S, double rho) const {
  double const mass_flux = ahead_.rho * v_S;
  return ahead_.P + mass_flux * mass_flux * (1 / ahead_.rho - 1 / rho);
}

std::vector<Shock> Hugoniot::curve(double P_last, int points) const {
  require(points >= 2, "points of the curve", points, "must be >= 2");
  double const P_first = constant_volume_state().P;
  std::vector<Shock> shocks;
  for (int i = 1; i <= points; ++i)
    shocks.push_back(from_pressure(P_first + (P_last - P_first) * i / points));
  return shocks;
}

} // namespace mesobridge::fitting
