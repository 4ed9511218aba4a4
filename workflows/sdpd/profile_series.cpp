#include "workflows/sdpd/profile_series.hpp"
#include "workflows/scene/quantities.hpp"
#include "workflows/sdpd/last_step.hpp"
#include <algorithm>

namespace mesobridge::workflows {
namespace {

std::string const profile_group = "profile";

double edge_along(Box const& box, int axis) {
  return axis == 0 ? box.edge.x : axis == 1 ? box.edge.y : box.edge.z;
}

} // namespace

ProfileSeries::ProfileSeries(Store& store, Scene const& scene, OutputUnits const& units, double boltzmann)
    : store_(store), slices_{static_cast<int>(scene.profile.axis[0] - 'x'),
                             static_cast<std::size_t>(scene.profile.bins)},
      axis_(scene.profile.axis),
      quantities_(chosen(scene.profile.quantities, profile_quantities(), scene.features())), units_(units),
      boltzmann_(boltzmann), last_step_(workflows::last_step(store, profile_group + "/step")) {}

bool ProfileSeries::shows(std::string const& quantity) const {
  return std::ranges::find(quantities_, quantity) != quantities_.end();
}

/// What the rows mean, once.
void ProfileSeries::describe(Box const& box) {
  double const width = edge_along(box, slices_.axis) * units_.length / static_cast<double>(slices_.count);
  std::vector<double> centres(slices_.count);
  for (std::size_t s = 0; s < centres.size(); ++s)
    centres[s] = (static_cast<double>(s) + 0.5) * width;
  store_.write(profile_group + "/position" + units_.length_key, centres);
  store_.set_attribute(profile_group, "axis", axis_);
  store_.set_attribute(profile_group, "slice_width" + units_.length_key, width);
  store_.set_attribute(
      profile_group, "meaning",
      std::string("means over the particles of each slice at one instant; 0 where `number` is 0 "
                  "(T_kin: below 2)"));
}

void ProfileSeries::append(std::string const& quantity, sdpd::Profile const& profile) {
  auto put = [&](std::vector<double> values, double unit, std::string const& key) {
    for (double& value : values)
      value *= unit;
    store_.append(profile_group + "/" + quantity + key, values, {values.size()});
  };
  if (quantity == "velocity") {
    std::vector<double> components;
    for (auto const& v : profile.velocity)
      components.insert(components.end(),
                        {v.x * units_.velocity, v.y * units_.velocity, v.z * units_.velocity});
    store_.append(profile_group + "/velocity" + units_.velocity_key, components,
                  {profile.velocity.size(), 3});
  } else if (quantity == "rho")
    put(profile.rho, units_.density, units_.density_key);
  else if (quantity == "T_kin")
    put(profile.T_kin, units_.temperature, units_.temperature_key);
  else if (quantity == "T_int")
    put(profile.T_int, units_.temperature, units_.temperature_key);
  else if (quantity == "P_internal")
    put(profile.P_internal, units_.pressure, units_.pressure_key);
  else if (quantity == "P")
    put(profile.P, units_.pressure, units_.pressure_key);
  for (auto const& [field, means] : profile.means)
    if (quantity == field->name)
      put(means, units_.of(field->dimension).first, units_.of(field->dimension).second);
}

void ProfileSeries::append(sdpd::Snapshot const& now, Box const& box, std::int64_t step, double time) {
  if (step <= last_step_)
    return;
  auto const profile = sdpd::profile(now, box, slices_, boltzmann_);
  if (last_step_ < 0)
    describe(box);
  store_.append(profile_group + "/number", profile.number, {profile.number.size()});
  for (auto const& quantity : quantities_)
    append(quantity, profile);
  store_.append(profile_group + "/time" + units_.time_key, std::span(&time, 1));
  store_.append(profile_group + "/step", std::span(&step, 1));
  last_step_ = step;
  store_.flush();
}

} // namespace mesobridge::workflows
