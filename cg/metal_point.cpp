#include "cg/metal_point.hpp"
#include "cg/state_grid.hpp"
#include "md/units.hpp"
#include <algorithm>
#include <numeric>

namespace mesobridge::cg {
namespace {

constexpr double liquid_growth = 0.15;

/// Units in which Boltzmann's constant is 1, temperatures are kelvins and lengths are angstroms: those that
/// the analysis of Lennard-Jones states wants.
LjUnits analysis_units(double mass) {
  return {.sigma = 1e-10, .epsilon = k_B, .mass = mass};
}

/// Growth of the mean squared displacement from the middle of the samples to their end, each an average over
/// a tenth.
double growth(std::span<md::MetalSample const> samples) {
  std::size_t const n = samples.size(), tenth = std::max<std::size_t>(1, n / 10);
  auto const mean = [&](std::size_t first) {
    double sum = 0;
    for (auto const& sample : samples.subspan(first, tenth))
      sum += sample.displacement_2;
    return sum / double(tenth);
  };
  return mean(n - tenth) - mean(n / 2 - tenth / 2);
}

} // namespace

std::string_view name_of(Phase phase) {
  return phase == Phase::solid ? "solid" : "liquid";
}

MetalPoint analyse_metal(md::MetalState state, md::MetalSettings const& settings,
                         std::span<md::MetalSample const> samples, md::MetalEnd const& end) {
  double const mass = settings.potential.mass;
  auto const units = analysis_units(mass);
  std::vector<md::ThermoSample> reduced;
  for (auto const& sample : samples)
    reduced.push_back({sample.step, sample.T / units.temperature(), sample.e / units.specific_energy(),
                       sample.P / units.pressure()});
  md::CrystalBlock const block(settings.lattice, settings.least_atoms);
  StatePoint point;
  try {
    point = analyse_state(state.rho / units.density(), state.T / units.temperature(), block.atoms(), reduced);
  } catch (PhysicsError const& error) {
    throw PhysicsError(
        fmt::format("{} at {} kg/m^3, {} K: {} (there in atoms per cubic angstrom and kelvins)",
                    settings.potential.element, state.rho, state.T, error.what()));
  }
  double const distance = block.neighbour_distance(state.rho / mass);
  double const displacement_2 = growth(samples) / (distance * distance);
  return {.state = state,
          .T_kin = scaled(point.T_kin, units.temperature()),
          .P = scaled(point.P, units.pressure()),
          .e = scaled(point.U, units.specific_energy()),
          .c_v = scaled(point.c_v, k_B / mass),
          .cov_eP = point.cov_UP * units.specific_energy() * units.pressure(),
          .phase = displacement_2 > liquid_growth ? Phase::liquid : Phase::solid,
          .displacement_2 = displacement_2,
          .end = end,
          .samples = point.samples,
          .discarded = point.discarded};
}

} // namespace mesobridge::cg
