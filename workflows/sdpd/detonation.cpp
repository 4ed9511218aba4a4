#include "workflows/sdpd/detonation.hpp"
#include "workflows/sdpd/profile_rows.hpp"
#include "workflows/summary.hpp"
#include <algorithm>

namespace mesobridge::workflows {
namespace {

constexpr double start = 1.0 / 3; // share of the way that the wave may need to become steady

/// Kinetics of a uniform fluid; nothing for laws that go backwards, burn by pressure or as prescribed.
std::optional<fitting::Kinetics> uniform_kinetics(sdpd::SimulationSettings const& settings,
                                                  sdpd::Sdpd const& fluid) {
  fitting::Kinetics kinetics{.arrhenius = {}, .rho_bar = settings.rho};
  auto const arrhenius = [&](sdpd::Arrhenius const& forward, sdpd::Arrhenius const& back) {
    kinetics.arrhenius = {forward.Z, forward.T_a}; // the energy, before in_units()
    return !back.acts();
  };
  auto const* const pairs = std::get_if<sdpd::SecondOrder>(&fluid.reaction->kinetics);
  auto const* const alone = std::get_if<sdpd::FirstOrder>(&fluid.reaction->kinetics);
  if (alone) {
    kinetics.order = fitting::Kinetics::Order::first;
    return arrhenius(alone->forward, alone->back) ? std::optional(kinetics) : std::nullopt;
  }
  if (!pairs || !arrhenius(pairs->forward, pairs->back))
    return std::nullopt;
  bool const normalised = pairs->weights == sdpd::NeighbourWeights::normalised;
  kinetics.sum = normalised ? fitting::NeighbourSum::unit : fitting::NeighbourSum::density_minus_self;
  kinetics.self_weight = std::visit([](auto const& kernel) { return kernel.W(0.0); },
                                    sdpd::make_kernel(fluid.kernel, settings.range()));
  return kinetics;
}

/// The frames of a run as those of a wave towards larger coordinates, along the axis of the profiles.
std::vector<sdpd::DetonationFrame> frames_of(Store const& store, Scene const& scene, OutputUnits const& units,
                                             std::vector<double> const& position) {
  std::size_t const slices = position.size(), axis = static_cast<std::size_t>(scene.profile.axis[0] - 'x');
  auto const time = store.read_doubles("profile/time" + units.time_key);
  auto velocity = profile_rows(store, "velocity" + units.velocity_key, slices, 3, axis);
  auto rho = profile_rows(store, "rho" + units.density_key, slices),
       P = profile_rows(store, "P" + units.pressure_key, slices),
       T = profile_rows(store, "T_int" + units.temperature_key, slices),
       progress = profile_rows(store, "progress", slices);
  if (time.empty())
    return {};
  double along = 0;
  for (double const v : velocity.back())
    along += v;
  std::vector<sdpd::DetonationFrame> frames;
  for (std::size_t k = 0; k < time.size(); ++k) {
    if (along < 0) {
      for (auto* values : {&velocity[k], &rho[k], &P[k], &T[k], &progress[k]})
        std::ranges::reverse(*values);
      for (double& v : velocity[k])
        v = -v;
    }
    frames.push_back({{.time = time[k],
                       .piston = position.front(),
                       .velocity = velocity[k],
                       .rho = rho[k],
                       .P = P[k],
                       .T = T[k]},
                      progress[k]});
  }
  return frames;
}

bool has_profiles(Store const& store, OutputUnits const& units) {
  auto const names = {"velocity" + units.velocity_key, "rho" + units.density_key, "P" + units.pressure_key,
                      "T_int" + units.temperature_key, std::string("progress")};
  return std::ranges::all_of(names, [&](auto const& name) { return store.contains("profile/" + name); });
}

} // namespace

double DetonationTheory::zone_length() const {
  return zone.empty() ? 0 : fitting::zone_extent(zone).length;
}

std::optional<DetonationTheory> detonation_theory(sdpd::SimulationSettings const& settings) {
  auto const* const fluid = std::get_if<sdpd::Sdpd>(&settings.method);
  if (!fluid || !fluid->reaction)
    return std::nullopt;
  auto const& reaction = *fluid->reaction;
  try {
    auto const at_rest = std::visit(
        [&](auto const& eos) { return fitting::state_from_temperature(eos, settings.rho, settings.T); },
        fluid->eos);
    auto const law =
        reaction.additive_volumes ? fitting::VolumeLaw::additive_volume : fitting::VolumeLaw::paper;
    fitting::ReactiveFluid const explosive(fluid->eos, reaction.product, law, at_rest, reaction.heat);
    DetonationTheory theory{explosive, explosive.crussard().chapman_jouguet(), {}};
    if (auto const kinetics = uniform_kinetics(settings, *fluid))
      try {
        theory.zone = fitting::reaction_profile({explosive, theory.chapman_jouguet.v_S}, *kinetics,
                                                fitting::progress_to_draw(0.999));
      } catch (PhysicsError const&) {
        theory.zone.clear(); // a detonation without such a zone still has its velocity
      }
    return theory;
  } catch (PhysicsError const&) {
    return std::nullopt;
  }
}

bool DetonationOfRun::is_steady() const {
  auto const& [change, se, n] = measured.change_of_D;
  return std::abs(change) <= std::max(3 * se, 0.01 * measured.D.mean);
}

std::optional<DetonationFrames> detonation_frames(Store const& store, Scene const& scene,
                                                  sdpd::SimulationSettings const& settings,
                                                  DetonationTheory const& theory) {
  OutputUnits const units(settings.units(), scene.units);
  if (scene.profile.every == 0 || !has_profiles(store, units))
    return std::nullopt;
  auto const position = store.read_doubles("profile/position" + units.length_key);
  return DetonationFrames{frames_of(store, scene, units, position),
                          {position, theory.chapman_jouguet.v_P, settings.spacing() * units.length}};
}

namespace {

/// The velocity that the wall behind the wave keeps, in the scene's units.
std::optional<double> wall_behind(Scene const& scene, sdpd::SimulationSettings const& settings) {
  auto const& face = settings.faces[static_cast<std::size_t>(scene.profile.axis[0] - 'x')][0];
  double const velocity = face.motion.driving_velocity();
  if (face.kind != sdpd::FaceKind::wall || (face.motion.moves() && velocity == 0))
    return std::nullopt;
  return velocity;
}

ReleaseOfRun release_of(sdpd::DetonationFrame const& frame, double front, double zone,
                        std::vector<double> const& position) {
  double const begin = frame.flow.piston, sonic = front - zone;
  ReleaseOfRun found{.time = frame.flow.time, .place = {}, .P = {}};
  for (std::size_t s = 0; s < position.size(); ++s)
    if (position[s] > begin && position[s] < front && frame.flow.rho[s] > 0) {
      found.place.push_back((position[s] - begin) / (sonic - begin));
      found.P.push_back(frame.flow.P[s]);
    }
  return found;
}

} // namespace

std::optional<DetonationOfRun> detonation_of(Store const& store, Scene const& scene,
                                             sdpd::SimulationSettings const& settings) {
  auto theory = detonation_theory(settings);
  auto const all = theory ? detonation_frames(store, scene, settings, *theory) : std::nullopt;
  if (!all || all->frames.empty())
    return std::nullopt;
  auto const& [frames, scale] = *all;
  auto measured = sdpd::steady_detonation(frames, scale, start);
  if (!measured)
    return std::nullopt;
  std::size_t const last = measured->frames.back();
  DetonationOfRun found{std::move(*measured),        std::move(*theory), {}, {}, frames[last].flow.time, {},
                        wall_behind(scene, settings)};
  for (std::size_t s = scale.position.size(); s-- > 0;)
    if (scale.position[s] < found.measured.fronts.back() && frames[last].flow.rho[s] > 0) {
      found.rho.push_back(frames[last].flow.rho[s]);
      found.P.push_back(frames[last].flow.P[s]);
    }
  constexpr std::size_t instants = 4;
  for (std::size_t k = 1; k <= instants; ++k) {
    std::size_t const n = (found.measured.fronts.size() - 1) * k / instants;
    found.release.push_back(release_of(frames[found.measured.frames[n]], found.measured.fronts[n],
                                       found.measured.zone.mean, scale.position));
  }
  return found;
}

void put_detonation(Json& json, DetonationOfRun const& found, OutputUnits const& units) {
  put(json, "detonation_D" + units.velocity_key, found.measured.D);
  put(json, "detonation_change_of_D" + units.velocity_key, found.measured.change_of_D);
  put(json, "reaction_zone" + units.length_key, found.measured.zone);
  auto const& cj = found.theory.chapman_jouguet;
  json["chapman_jouguet"] = {{"D" + units.velocity_key, cj.v_S},
                             {"rho" + units.density_key, cj.behind.rho},
                             {"P" + units.pressure_key, cj.behind.P},
                             {"T" + units.temperature_key, cj.behind.T}};
  if (found.theory.zone.empty())
    return;
  auto const& spike = found.theory.spike();
  json["znd"] = {{"von_neumann_rho" + units.density_key, spike.rho},
                 {"von_neumann_P" + units.pressure_key, spike.state.P},
                 {"von_neumann_T" + units.temperature_key, spike.state.T},
                 {"zone" + units.length_key, found.theory.zone_length()}};
}

} // namespace mesobridge::workflows
