#include "workflows/sdpd/flow.hpp"
#include "cg/equilibration.hpp"
#include "workflows/sdpd/duct_flow.hpp"
#include "workflows/sdpd/measured_series.hpp"
#include "workflows/sdpd/short_series.hpp"
#include "workflows/summary.hpp"
#include <algorithm>
#include <numbers>

namespace mesobridge::workflows {
namespace {

constexpr std::size_t least_frames = 40;

/// The velocities along the flow of all slices at all times.
struct Frames {
  std::vector<double> time, position;
  std::vector<double> velocity, number; ///< row after row
  double at(std::size_t frame, std::size_t slice) const { return velocity[frame * position.size() + slice]; }
  double count(std::size_t frame, std::size_t slice) const { return number[frame * position.size() + slice]; }
};

Frames frames_of(Store const& store, OutputUnits const& units, int along) {
  Frames frames{.time = store.read_doubles("profile/time" + units.time_key),
                .position = store.read_doubles("profile/position" + units.length_key),
                .velocity = {},
                .number = {}};
  auto const all = store.read_doubles("profile/velocity" + units.velocity_key);
  for (std::size_t k = static_cast<std::size_t>(along); k < all.size(); k += 3)
    frames.velocity.push_back(all[k]);
  for (auto const count : store.read_integers("profile/number"))
    frames.number.push_back(static_cast<double>(count));
  return frames;
}

/// Of each frame the least squares v = offset + slope shape(z) over the slices that are taken, weighted with
/// their particles.
struct Fits {
  std::vector<double> offset, slope;
};

template <class Shape, class Taken>
Fits fit(Frames const& frames, Shape const& shape, Taken const& taken) {
  Fits fits;
  for (std::size_t k = 0; k < frames.time.size(); ++k) {
    double n = 0, x = 0, v = 0, xx = 0, xv = 0;
    for (std::size_t s = 0; s < frames.position.size(); ++s)
      if (taken(frames.position[s])) {
        double const w = frames.count(k, s), at = shape(frames.position[s]);
        n += w, x += w * at, v += w * frames.at(k, s), xx += w * at * at, xv += w * at * frames.at(k, s);
      }
    double const slope = (n * xv - x * v) / (n * xx - x * x);
    fits.slope.push_back(slope), fits.offset.push_back((v - slope * x) / n);
  }
  return fits;
}

std::span<double const> from(std::vector<double> const& values, std::size_t first) {
  return std::span(values).subspan(first);
}

/// a/b with the error of independent means.
cg::Estimate ratio(cg::Estimate const& a, cg::Estimate const& b) {
  double const value = a.mean / b.mean;
  return {value, std::hypot(a.se / b.mean, value * b.se / b.mean), std::min(a.n_eff, b.n_eff)};
}

/// Momentum per area and time that goes from the upper wall through the fluid into the lower one.
std::optional<cg::Estimate> wall_stress(Store const& store, Scene const& scene, OutputUnits const& units,
                                        int along, double since, double area) {
  std::vector<double> lower, upper;
  for (auto const& one : measured_components(store, scene, units))
    if (one.of.name == "wall_drag") {
      if (one.component == static_cast<std::size_t>(along))
        lower = one.values;
      if (one.component == static_cast<std::size_t>(3 + along))
        upper = one.values;
    }
  if (lower.empty())
    return std::nullopt;
  auto const time = measured_times(store, units);
  std::vector<double> stress;
  for (std::size_t k = 1; k < time.size(); ++k)
    if (time[k - 1] >= since)
      stress.push_back(0.5 * (upper[k] - upper[k - 1] - lower[k] + lower[k - 1]) /
                       (area * (time[k] - time[k - 1])));
  if (stress.size() < least_frames)
    return std::nullopt;
  return cg::estimate_mean(stress);
}

bool is_duct(Scene::Box const& box) {
  return (box.x == "walls") + (box.y == "walls") + (box.z == "walls") == 2;
}

/// In a duct the profile may go along either width.
FlowAxes axes_of(Scene const& scene) {
  auto axes = flow_axes(scene);
  int const shown = scene.profile.axis[0] - 'x';
  if (is_duct(scene.box) && shown != axes.along)
    axes.across = shown;
  return axes;
}

/// One run while its flow is found.
class FlowSearch {
 public:
  FlowSearch(Store const& store, Scene const& scene, sdpd::SimulationSettings const& settings)
      : store_(store), scene_(scene), units_(settings.units(), scene.units), axes_(axes_of(scene)),
        frames_(frames_of(store, units_, axes_.along)), box_(sdpd::box_of(settings)),
        edge_(component(box_.edge, axes_.across) * units_.length), range_(settings.range() * units_.length) {}

  std::optional<FlowOfRun> find(FlowKind kind) {
    if (frames_.time.size() < least_frames || !(edge_ > 2.5 * range_))
      return std::nullopt;
    FlowOfRun flow{.kind = kind,
                   .viscosity = {},
                   .slip_length = {},
                   .position = frames_.position,
                   .velocity = {},
                   .exact = {}};
    switch (kind) {
    case FlowKind::couette:
      couette(flow);
      break;
    case FlowKind::poiseuille:
      poiseuille(flow);
      break;
    case FlowKind::duct:
      duct(flow);
      break;
    case FlowKind::wave:
      wave(flow);
    }
    for (std::size_t s = 0; s < frames_.position.size(); ++s) {
      std::vector<double> seen;
      for (std::size_t k = first_; k < frames_.time.size(); ++k)
        if (frames_.count(k, s) > 0)
          seen.push_back(frames_.at(k, s));
      flow.velocity.push_back(seen.empty() ? cg::Estimate{} : mean_of_series(seen));
    }
    return flow;
  }

 private:
  double middle(double z) const { return z - edge_ / 2; }
  auto inside() const {
    return [this](double z) { return z > range_ && z < edge_ - range_; };
  }
  /// What comes after the start of the flow, which a sliding wall's slope in the middle hardly shows, but the
  /// velocity there does.
  void settle(FlowOfRun& flow, Fits const& fits) {
    first_ = std::max({cg::detect_equilibration(fits.slope).start,
                       cg::detect_equilibration(fits.offset).start, frames_.time.size() / 10});
    flow.from = frames_.time[first_];
  }

  void couette(FlowOfRun& flow) {
    double const slide = *scene_.box.slide;
    auto const fits = fit(
        frames_, [&](double z) { return middle(z); }, inside());
    settle(flow, fits);
    auto const slope = cg::estimate_mean(from(fits.slope, first_));
    double const area = box_.volume() * std::pow(units_.length, 3) / edge_;
    auto const stress = wall_stress(store_, scene_, units_, axes_.along, flow.from, area);
    flow.sees_stress = stress.has_value();
    if (stress)
      flow.viscosity = ratio(*stress, slope);
    double const reach = slide / slope.mean;
    flow.slip_length =
        cg::Estimate{(reach - edge_) / 2, std::abs(reach / 2 * slope.se / slope.mean), slope.n_eff};
    for (double const z : frames_.position)
      flow.exact.push_back(slide * z / edge_);
  }

  void poiseuille(FlowOfRun& flow) {
    auto const fits = fit(
        frames_, [&](double z) { return middle(z) * middle(z); }, inside());
    settle(flow, fits);
    auto const curvature = cg::estimate_mean(from(fits.slope, first_));
    double const force = scene_.fluid.rho * *scene_.box.body_force;
    flow.viscosity = ratio({-force / 2, 0, curvature.n_eff}, curvature);
    std::vector<double> at_wall;
    for (std::size_t k = first_; k < fits.slope.size(); ++k)
      at_wall.push_back(fits.offset[k] + fits.slope[k] * edge_ * edge_ / 4);
    flow.slip_length =
        ratio(cg::estimate_mean(at_wall), {-curvature.mean * edge_, curvature.se * edge_, curvature.n_eff});
    for (double const z : frames_.position)
      flow.exact.push_back(force / (2 * flow.viscosity.mean) * z * (edge_ - z));
  }

  /// The profile is a mean over the duct's other width.
  void duct(FlowOfRun& flow) {
    Duct const of{edge_, component(box_.edge, 3 - axes_.along - axes_.across) * units_.length};
    auto const fits = fit(
        frames_, [&](double z) { return of.velocity(z); }, inside());
    settle(flow, fits);
    auto const slope = cg::estimate_mean(from(fits.slope, first_)),
               offset = cg::estimate_mean(from(fits.offset, first_));
    double const force = scene_.fluid.rho * *scene_.box.body_force;
    flow.viscosity = ratio({force, 0, slope.n_eff}, slope);
    double const shear = of.a * of.b / (2 * (of.a + of.b)); // at the walls, in the mean over them
    flow.slip_length = ratio(offset, {slope.mean * shear, slope.se * shear, slope.n_eff});
    for (double const z : frames_.position)
      flow.exact.push_back(slope.mean * of.velocity(z));
  }

  void wave(FlowOfRun& flow) {
    double const k = 2 * std::numbers::pi * static_cast<double>(scene_.box.waves) / edge_,
                 half = k * edge_ / static_cast<double>(2 * frames_.position.size()),
                 in_slice = std::sin(half) / half; // what is left of a cosine in the mean over a slice
    auto const fits = fit(
        frames_, [&](double z) { return in_slice * std::cos(k * z); }, [](double) { return true; });
    settle(flow, fits);
    auto const amplitude = cg::estimate_mean(from(fits.slope, first_));
    double const force = scene_.fluid.rho * *scene_.box.body_force;
    flow.viscosity = ratio({force / (k * k), 0, amplitude.n_eff}, amplitude);
    for (double const z : frames_.position)
      flow.exact.push_back(amplitude.mean * std::cos(k * z));
  }

  Store const& store_;
  Scene const& scene_;
  OutputUnits units_;
  FlowAxes axes_;
  Frames frames_;
  Box box_;
  double edge_, range_;
  std::size_t first_ = 0;
};

std::optional<FlowKind> kind_of(Scene const& scene) {
  auto const& box = scene.box;
  bool const slides = box.slide.value_or(0) != 0, pushed = box.body_force.value_or(0) != 0;
  if (slides == pushed)
    return std::nullopt;
  bool const duct = is_duct(box);
  if (slides)
    return duct ? std::nullopt : std::optional(FlowKind::couette);
  if (box.waves > 0)
    return FlowKind::wave;
  if (box.slip != "none")
    return std::nullopt;
  return duct ? FlowKind::duct : FlowKind::poiseuille;
}

} // namespace

std::optional<FlowOfRun> flow_of(Store const& store, Scene const& scene,
                                 sdpd::SimulationSettings const& settings) {
  OutputUnits const units(settings.units(), scene.units);
  auto const kind = kind_of(scene);
  bool const across = scene.profile.axis[0] - 'x' == axes_of(scene).across;
  if (!kind || !across || scene.profile.every == 0 ||
      !store.contains("profile/velocity" + units.velocity_key))
    return std::nullopt;
  return FlowSearch(store, scene, settings).find(*kind);
}

void put_flow(Json& json, FlowOfRun const& flow, OutputUnits const& units) {
  if (flow.sees_stress)
    put(json, units.time_key.empty() ? "viscosity" : "viscosity_Pa_s", flow.viscosity);
  if (flow.slip_length)
    put(json, "slip_length" + units.length_key, *flow.slip_length);
  json["flow_steady_from" + units.time_key] = flow.from;
}

} // namespace mesobridge::workflows
