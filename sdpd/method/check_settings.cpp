#include "sdpd/fluctuation/pair_scheme.hpp"
#include "sdpd/method/settings.hpp"
#include "sdpd/neighbours/cells.hpp"
#include "sdpd/thermodynamics/particle_eos.hpp"
#include <limits>

namespace mesobridge::sdpd {
namespace {

/// At the set density and temperature, in k_B. Throws PhysicsError when the model has no such state.
double heat_capacity_of_a_particle(SimulationSettings const& s, double K, fitting::AnyEos const& any) {
  double const bulk = std::visit(
      [&](auto const& eos) {
        return eos.heat_capacity(eos.energy_from_temperature(s.T, s.rho), s.rho) * eos.molecular_mass() /
               eos.boltzmann();
      },
      any);
  return K * bulk - (centre_of_mass_of(s) == CentreOfMass::free ? 1.5 : 0);
}

void check_size(SimulationSettings const& s, double K, fitting::AnyEos const& eos) {
  require(K >= 1 && std::isfinite(K), "particle size K", K, "must be >= 1 and finite");
  double const C = heat_capacity_of_a_particle(s, K, eos);
  require(
      C > least_heat_capacity, "particle size K", K,
      fmt::format("is too small: a particle has the heat capacity {:.4g} k_B at rho and T{}, and above {} "
                  "k_B is needed for a positive friction (sdpd/README.md, Eq. (S15))",
                  C, centre_of_mass_of(s) == CentreOfMass::free ? " without its centre of mass" : "",
                  least_heat_capacity));
}

template <class AnySpecies>
void check_shares(std::vector<AnySpecies> const& species) {
  double sum = 0;
  for (auto const& of : species) {
    require(of.share > 0 && of.share <= 1, fmt::format("share of species '{}'", of.name), of.share,
            "must be > 0 and <= 1");
    sum += of.share;
  }
  require(species.empty() || std::abs(sum - 1) < 1e-9, "sum of the species' shares", sum, "must be 1");
}

void check_sdpd(SimulationSettings const& s) {
  check_size(s, s.K, s.eos);
  check_shares(s.species);
  for (auto const& species : s.species)
    check_size(s, species.K, species.eos);
  require(s.h_factor >= 1 && s.h_factor <= 10, "kernel support h_factor", s.h_factor, "must lie in 1 ... 10");
  auto const& [scale, self] = s.density_correction;
  require(scale > 0 && std::isfinite(scale), "density correction scale", scale, "must be > 0 and finite");
  require(self < scale && self > -scale, "density correction self", self,
          "must lie between -scale and scale");
  make_kernel(s.kernel, s.h_factor);
  auto const units = s.units();
  SdpdFriction(s.eta / units.viscosity(), s.zeta / units.viscosity());
  require(s.kappa >= 0 && std::isfinite(s.kappa), "thermal conductivity kappa", s.kappa, "must be >= 0");
  if (!s.noise && s.scheme.pairs == PairScheme::ems)
    throw InputError("scheme ems without noise: there is nothing to put to a Metropolis test; take ssa");
}

void check_pair_fluid(SimulationSettings const& s) {
  check(*s.pair_fluid);
  check_shares(s.pair_fluid->species);
  require(s.noise, "noise", s.noise, "DPD and DPDE need their noise");
  require(s.kappa == 0, "thermal conductivity kappa", s.kappa, "is a property of SDPD's fluid");
  bool const rejects = s.scheme.pairs == PairScheme::ams || s.scheme.pairs == PairScheme::ems;
  if (s.scheme.pairs == PairScheme::entropy)
    throw InputError(
        "scheme entropy: is the original form of SDPD and serves no other method; take ssa or ser");
  if (s.scheme.pairs == PairScheme::ser_implicit && !s.pair_fluid->follows_energy())
    throw InputError("scheme ser-implicit: DPD has no internal energies, which it needs; take ssa or ser");
  require(s.pair_fluid->follows_energy() || !rejects, "scheme", rejects ? "ams or ems" : "",
          "DPD has no internal energies, so there is no step to reject: take ssa or ser");
  require(s.pair_fluid->follows_energy() || !s.scheme.keep_energy, "energy", "kept",
          "DPD has no internal energies that could give or take energy");
}

/// The momenta of a single particle cannot have a temperature and no sum.
void check_lattice(SimulationSettings const& s) {
  double particles = 1;
  for (auto const n : s.lattice) {
    require(n >= 1, "particles along an edge", n, "must be >= 1");
    particles *= n;
  }
  require(particles >= 2 && particles <= std::numeric_limits<Index>::max(), "particles", particles,
          fmt::format("must be 2 ... {}", std::numeric_limits<Index>::max()));
}

} // namespace

void require_one_species(SimulationSettings const& s, std::string_view asked) {
  require(!s.features().masses, "species", s.reduced_species().size(),
          fmt::format("must be one: the {} is known for one equation of state alone", asked));
}

void check_units(SimulationSettings const& s) {
  auto const units = s.units();
  for (auto const& [unit, value] : {std::pair("mass", units.mass()),
                                    {"length", units.length()},
                                    {"energy", units.energy()},
                                    {"time", units.time()},
                                    {"pressure", units.pressure()},
                                    {"viscosity", units.viscosity()}})
    require(
        value > 0 && std::isfinite(value), fmt::format("reduced unit of {}", unit), value,
        "must be > 0 and finite: a size, mass, density, temperature or cut-off is too small or too large");
  for (auto const& [length, value] :
       {std::pair("distance between particles", s.spacing()), {"range of the interaction", s.range()}})
    require(value > 0 && std::isfinite(value), length, value,
            "must be > 0 and finite in reduced units: the density or a cut-off is too small or too large");
}

void check(SimulationSettings const& s) {
  require(s.rho > 0 && std::isfinite(s.rho), "density rho", s.rho, "must be > 0 and finite");
  require(s.T > 0 && std::isfinite(s.T), "temperature T", s.T, "must be > 0 and finite");
  require(s.dt > 0 && std::isfinite(s.dt), "time step dt", s.dt, "must be > 0 and finite (reduced units)");
  require(s.skin >= 0 && std::isfinite(s.skin), "skin", s.skin, "must be >= 0");
  require(s.threads >= 1, "threads", s.threads, "must be >= 1");
  require(s.scheme.verlet_steps >= 1, "Verlet steps for one of fluctuation and dissipation",
          s.scheme.verlet_steps, "must be >= 1");
  require(s.disorder >= 0 && s.disorder <= 0.5, "disorder", s.disorder,
          "must lie in 0 ... 0.5 lattice spacings");
  check_lattice(s);
  require(s.bath_rate >= 0 && std::isfinite(s.bath_rate), "rate of the bath", s.bath_rate, "must be >= 0");
  require(s.noise || s.bath_rate == 0, "rate of the bath", s.bath_rate, "must be 0 without noise");
  s.pair_fluid ? check_pair_fluid(s) : check_sdpd(s);
  check_units(s);
  require_cells(box_of(s), s.range() + skin_of(s));
}

} // namespace mesobridge::sdpd
