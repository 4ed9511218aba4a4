#include "workflows/sdpd/riemann_problem.hpp"
#include "workflows/sdpd/profile_rows.hpp"
#include <algorithm>
#include <limits>

namespace mesobridge::workflows {
namespace {

/// A slab across the whole box, of one region.
struct Slice {
  double begin; ///< reduced
  std::size_t region;
};

/// The regions along an axis, when they are slabs across it; nothing otherwise.
std::optional<std::vector<Slice>> slices_along(int axis, sdpd::Layout const& layout) {
  Vec3 const edge = layout.edge();
  std::vector<double> ends{0};
  for (auto const& region : layout.regions()) {
    auto const* const slab = std::get_if<sdpd::Cuboid>(&region.shape);
    if (!slab || region.outside || region.vacuum || region.along_x != Vec3{} || region.along_y != Vec3{} ||
        region.along_z != Vec3{})
      return std::nullopt;
    for (int other = 0; other < 3; ++other)
      if (other != axis &&
          (component(slab->from, other) > 0 || component(slab->to, other) < component(edge, other)))
        return std::nullopt;
    for (double const end : {component(slab->from, axis), component(slab->to, axis)})
      if (end > 0 && end < component(edge, axis))
        ends.push_back(end);
  }
  std::ranges::sort(ends);
  std::vector<Slice> slices;
  for (std::size_t k = 0; k < ends.size(); ++k) {
    double const next = k + 1 < ends.size() ? ends[k + 1] : component(edge, axis);
    Vec3 middle = 0.5 * edge;
    component(middle, axis) = 0.5 * (ends[k] + next);
    auto const region = layout.region_at(middle);
    if (next > ends[k] && (slices.empty() || slices.back().region != region))
      slices.push_back({ends[k], region});
  }
  return slices;
}

fitting::RiemannSide side_of(sdpd::SimulationSettings const& settings, std::size_t index, int axis) {
  auto const units = settings.units();
  auto const& fluid = settings.as<sdpd::Sdpd>();
  auto const& region = settings.layout->regions()[index];
  auto const& eos = fluid.species.empty() ? fluid.eos : fluid.species[region.species].eos;
  double const mass =
      settings.reduced_species().empty() ? 1 : settings.reduced_species()[region.species].mass;
  fitting::Fluid const model(eos);
  return {
      model,
      model.at_temperature(mass / std::pow(region.spacing, 3) * units.density, region.T * units.temperature),
      component(region.velocity, axis) * units.velocity()};
}

/// Means over a slice of the profile.
fitting::FlowState mean_over(RiemannProblem const& problem, double centre, double width, double time) {
  constexpr int points = 16;
  fitting::FlowState mean{};
  for (int k = 0; k < points; ++k) {
    auto const here = problem.at(centre + width * ((k + 0.5) / points - 0.5), time);
    mean.state.rho += here.state.rho / points, mean.state.P += here.state.P / points;
    mean.state.T += here.state.T / points, mean.u += here.u / points;
  }
  return mean;
}

} // namespace

fitting::FlowState RiemannProblem::at(double place, double time) const {
  return exact.at(time > 0 ? (place - membrane) / time
                           : std::copysign(std::numeric_limits<double>::max(), place - membrane));
}

double RiemannProblem::end() const {
  constexpr double never = std::numeric_limits<double>::infinity();
  auto const time_to = [&](double way, double head, double u_outer) {
    double const closing = std::max(head, head - u_outer); // on the end of the box, or of the fluid
    return closing > 0 ? way / closing : never;
  };
  double const far = std::numeric_limits<double>::max();
  return std::min(time_to(membrane, -exact.left_wave().head, -exact.at(-far).u),
                  time_to(length - membrane, exact.right_wave().head, exact.at(far).u));
}

std::pair<double, double> RiemannProblem::undisturbed(double time) const {
  double const far = std::numeric_limits<double>::max();
  auto const left = exact.at(-far), right = exact.at(far);
  double const up = held[0] ? 0 : std::max(0.0, (left.u + left.state.sound_speed.value()) * time) + margin;
  double const down =
      held[1] ? 0 : std::max(0.0, (right.state.sound_speed.value() - right.u) * time) + margin;
  return {up, length - down};
}

std::optional<RiemannProblem> riemann_problem(Scene const& scene, sdpd::SimulationSettings const& settings) {
  if (!settings.layout || !settings.features().densities || settings.features().reacts)
    return std::nullopt;
  int const axis = scene.profile.axis[0] - 'x';
  auto const slices = slices_along(axis, *settings.layout);
  if (!slices || slices->size() != 2)
    return std::nullopt;
  double const unit = settings.units().length();
  try {
    auto const left = side_of(settings, slices->front().region, axis),
               right = side_of(settings, slices->back().region, axis);
    auto const& faces = settings.faces[static_cast<std::size_t>(axis)];
    auto const held = [](sdpd::Face const& face, double u) {
      return face.kind == sdpd::FaceKind::wall && !face.motion.moves() && u == 0;
    };
    return RiemannProblem{axis,
                          slices->back().begin * unit,
                          component(settings.layout->edge(), axis) * unit,
                          fitting::RiemannSolution(left, right),
                          {held(faces[0], left.u), held(faces[1], right.u)},
                          settings.range() * unit};
  } catch (PhysicsError const&) { // a vacuum opens, or the model has no such wave: the run stands for itself
    return std::nullopt;
  }
}

RiemannComparison compare(RiemannProblem const& problem, RiemannComparison found) {
  double const width = problem.length / static_cast<double>(found.place.size());
  auto const [from, to] = problem.undisturbed(found.time);
  double count = 0;
  for (std::size_t s = 0; s < found.place.size(); ++s) {
    auto const exact = mean_over(problem, found.place[s], width, found.time);
    found.exact.push_back(exact);
    if (found.place[s] < from || found.place[s] > to)
      continue;
    ++count;
    found.rho_error += std::abs(found.rho[s] - exact.state.rho);
    found.u_error += std::abs(found.u[s] - exact.u);
    found.P_error += std::abs(found.P[s] - exact.state.P);
  }
  for (double* const error : {&found.rho_error, &found.u_error, &found.P_error})
    *error /= std::max(1.0, count);
  return found;
}

std::optional<RiemannComparison> compare(RiemannProblem const& problem, Store const& store,
                                         Scene const& scene, OutputUnits const& units) {
  std::string const velocity = "velocity" + units.velocity_key, rho = "rho" + units.density_key,
                    P = "P" + units.pressure_key, T = "T_int" + units.temperature_key;
  if (scene.profile.every == 0)
    return std::nullopt;
  for (auto const& name : {velocity, rho, P, T})
    if (!store.contains("profile/" + name))
      return std::nullopt;
  auto const times = store.read_doubles("profile/time" + units.time_key);
  auto const place = store.read_doubles("profile/position" + units.length_key);
  std::size_t k = times.size();
  while (k > 0 && times[k - 1] > problem.end())
    --k;
  if (k-- <= 1)
    return std::nullopt;
  auto const row = [&](std::string const& name, std::size_t components, std::size_t component) {
    return profile_rows(store, name, place.size(), components, component).at(k);
  };
  return compare(problem,
                 {times[k], place, row(rho, 1, 0), row(velocity, 3, static_cast<std::size_t>(problem.axis)),
                  row(P, 1, 0), row(T, 1, 0)});
}

void put_riemann(Json& json, RiemannProblem const& problem, RiemannComparison const& found,
                 OutputUnits const& units) {
  json["riemann_problem"] = {{"time" + units.time_key, found.time},
                             {"P_contact" + units.pressure_key, problem.exact.P()},
                             {"u_contact" + units.velocity_key, problem.exact.u()},
                             {"L1_rho" + units.density_key, found.rho_error},
                             {"L1_u" + units.velocity_key, found.u_error},
                             {"L1_P" + units.pressure_key, found.P_error}};
}

} // namespace mesobridge::workflows
