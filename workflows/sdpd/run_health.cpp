#include "workflows/sdpd/run_health.hpp"
#include "fitting/fluid.hpp"
#include "fitting/valid_range.hpp"
#include "sdpd/observe/pairing.hpp"
#include "workflows/sdpd/known_structure.hpp"
#include "workflows/sdpd/piston_shock.hpp"
#include <fmt/ranges.h>
#include <numbers>

namespace mesobridge::workflows {
namespace {

/// Fewer neighbours than this, and most of the time a particle is alone.
constexpr double least_neighbours = 1;

double neighbours_in_range(sdpd::SimulationSettings const& settings) {
  return 4 * std::numbers::pi / 3 * std::pow(settings.range() / settings.spacing(), 3);
}

/// Says so where the state behind a piston's shock will ripple.
std::optional<sdpd::Finding> ripples(sdpd::SimulationSettings const& settings) {
  auto const shock = shock_before_piston(settings);
  if (!shock)
    return std::nullopt;
  double const Re = front_reynolds_number(settings, *shock);
  if (Re <= smooth_front)
    return std::nullopt;
  double const viscosity =
      shock->ahead.rho * shock->v_S * settings.spacing() * settings.units().length() / smooth_front;
  return sdpd::Finding{
      "ripples", false,
      fmt::format(
          "the shock before the piston has Re_l = rho_0 v_S l/(4 eta/3 + zeta) = {:.3g}, l the mean "
          "distance between particles: above {:g} the state behind the front ripples, while its means "
          "over many particles stay right; for smooth profiles take transport.eta >= {:.2g}, or "
          "smaller particles",
          Re, smooth_front, 0.75 * viscosity)};
}

/// Says so where the shock comes to the far wall within the run.
std::optional<sdpd::Finding> reflection(Scene const& scene, sdpd::SimulationSettings const& settings) {
  auto const steps = steps_to_far_wall(settings);
  if (!steps || *steps >= static_cast<double>(scene.run.steps))
    return std::nullopt;
  return sdpd::Finding{
      "reflection", false,
      fmt::format("the shock before the piston comes to the far wall after about {:.0f} of run.steps = {} "
                  "steps of {:.3g} (reduced){}, and turns back there: take fewer steps or a longer box if "
                  "that is not wanted",
                  *steps, scene.run.steps, settings.dt,
                  scene.scheme.dt.automatic ? ", the largest that dt = \"auto\" may choose" : "")};
}

} // namespace

namespace {

/// Regions whose lattice is not of the density that was asked for.
void add_doubts_about(sdpd::Layout const& layout, std::vector<sdpd::Finding>& doubts) {
  constexpr double tolerable = 0.005;
  for (std::size_t r = 0; r < layout.regions().size(); ++r) {
    auto const& region = layout.regions()[r];
    if (double const excess = layout.excess(r); !region.vacuum && std::abs(excess) > tolerable)
      doubts.push_back(
          {"region", false,
           fmt::format(
               "{}: its lattice is {:.2g} % {} than its density, since whole cells must fill it: another "
               "size of the box or of the particles fits better",
               region.name, 100 * std::abs(excess), excess > 0 ? "denser" : "thinner")});
  }
}

/// Says so where errors rest on so few independent samples that they are rough themselves.
std::optional<sdpd::Finding> few_samples(sdpd::Equilibrium const& e) {
  constexpr double enough = 20;
  std::vector<std::string> few;
  for (auto const& [name, mean] :
       {std::pair("T_kin", e.T_kin), {"T_int", e.T_int}, {"P", e.P}, {"e", e.eps.mean}, {"rho", e.rho.mean}})
    if (mean.se > 0 && mean.n_eff < enough)
      few.push_back(fmt::format("{} ({:.1f})", name, mean.n_eff));
  if (few.empty())
    return std::nullopt;
  return sdpd::Finding{"few_samples", false,
                       fmt::format("means rest on few independent samples (n_eff): {}; errors of less than "
                                   "{:g} are rough: take more run.steps",
                                   fmt::join(few, ", "), enough)};
}

/// A fluid at rest that pulls together does not fill its box.
std::optional<sdpd::Finding> tension(fitting::EosModel const& model, double rho, double T) {
  double const P = fitting::Fluid(model.eos).at_temperature(rho, T).P;
  if (!(P < 0))
    return std::nullopt;
  return sdpd::Finding{
      "tension", false,
      fmt::format("the equation of state has P = {:.4g} at rho = {:.6g} and T = {:.6g}: a fluid in "
                  "tension breaks into drops, which no kernel prevents; take a greater density",
                  P, rho, T)};
}

} // namespace

std::vector<sdpd::Finding> doubts_about(Scene const& scene, sdpd::SimulationSettings const& settings) {
  std::vector<sdpd::Finding> doubts;
  for (auto const& note : scene.notes)
    doubts.push_back({"note", false, note});
  if (settings.features().densities)
    if (auto const doubt = fitting::extrapolation(eos_model_of(scene), settings.rho, settings.T))
      doubts.push_back({"range", false, fmt::format("fluid.eos: {}", *doubt)});
  if (settings.features().densities && settings.noise && !is_driven(scene))
    if (auto const doubt = tension(eos_model_of(scene), settings.rho, settings.T))
      doubts.push_back(*doubt);
  if (settings.layout)
    add_doubts_about(*settings.layout, doubts);
  if (double const neighbours = neighbours_in_range(settings); neighbours < least_neighbours)
    doubts.push_back(
        {"neighbours", false,
         fmt::format(
             "a particle has {:.2g} neighbours within the range of the interactions: it is mostly alone. "
             "fluid.rho = {:g} is the mass per volume; the number of particles per volume is rho/mass",
             neighbours, settings.rho)});
  if (auto const* const sdpd = std::get_if<sdpd::Sdpd>(&settings.method); sdpd && settings.noise)
    if (auto const known = known_structure(sdpd->kernel, neighbours_in_range(settings), settings.K()))
      doubts.push_back({"structure", false, *known});
  for (auto const& doubt : {ripples(settings), reflection(scene, settings)})
    if (doubt)
      doubts.push_back(*doubt);
  return doubts;
}

std::vector<sdpd::Finding> findings_of(sdpd::EquilibriumSampler const& samples, RunResult const& result,
                                       sdpd::Simulation const& simulation) {
  auto const& settings = result.settings;
  bool const keeps_energy = !simulation.has_thermostat();
  auto findings = doubts_about(result.scene, settings);
  if (is_driven(result.scene))
    return findings;
  auto const found =
      sdpd::examine(samples, result.equilibrium,
                    {.has_motion = settings.noise,
                     .keeps_energy = keeps_energy,
                     .was_equilibrated = result.scene.run.equilibrate > 0,
                     .gained_temperature = result.gained_temperature,
                     .thermal_energy = keeps_energy ? simulation.heat_capacity() / settings.K() : 0,
                     .thermal_pressure = std::pow(settings.spacing(), -3),
                     .tolerable_pairing = sdpd::tolerable_pairing(settings.K())});
  findings.insert(findings.end(), found.begin(), found.end());
  if (auto const doubt = few_samples(result.equilibrium))
    findings.push_back(*doubt);
  return findings;
}

Json findings_json(std::vector<sdpd::Finding> const& findings) {
  Json list = Json::array();
  for (auto const& [name, spoils, text] : findings)
    list.push_back({{"name", name}, {"severity", spoils ? "failure" : "warning"}, {"text", text}});
  return list;
}

std::string failure_of(std::vector<sdpd::Finding> const& findings) {
  std::vector<std::string> texts;
  for (auto const& finding : findings)
    if (finding.spoils)
      texts.push_back(finding.text);
  if (texts.empty())
    return "";
  return fmt::format("its state is not the scene's: {}", fmt::join(texts, "; "));
}

} // namespace mesobridge::workflows
