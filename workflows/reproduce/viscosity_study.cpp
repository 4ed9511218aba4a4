#include "workflows/reproduce/viscosity_study.hpp"
#include <numbers>

namespace mesobridge::workflows {
namespace {

/// In DPD particles fly half a cut-off, a spacing, before friction stops them: their wave is to be long.
constexpr std::array<std::uint32_t, 3> lattice{7, 7, 20}, long_lattice{7, 7, 40};

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
