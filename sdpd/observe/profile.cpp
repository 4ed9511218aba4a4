#include "sdpd/observe/profile.hpp"
#include "md/error.hpp"
#include <algorithm>

namespace mesobridge::sdpd {
namespace {

/// The slice of every particle; the first and the last hold what lies beyond an open face.
std::vector<std::size_t> slices_of(Snapshot const& now, Box const& box, Slices const& slices) {
  double const per_length = static_cast<double>(slices.count) / component(box.edge, slices.axis);
  std::vector<std::size_t> slice(now.q.size());
  double const last = static_cast<double>(slices.count) - 1; // the product may round up to the count itself
  for (std::size_t i = 0; i < slice.size(); ++i)
    slice[i] = static_cast<std::size_t>(std::clamp(component(now.q[i], slices.axis) * per_length, 0.0, last));
  return slice;
}

/// Turns sums over the slices' particles into means.
template <class Value, class Weight>
void divide_by(std::vector<Value>& sums, std::vector<Weight> const& weight) {
  for (std::size_t s = 0; s < sums.size(); ++s)
    if (weight[s] > 0)
      sums[s] = sums[s] / static_cast<double>(weight[s]);
}

/// Means over the slices' particles of f(i); empty when there is nothing to take the mean of.
template <class F>
std::vector<double> means(bool there, std::vector<std::size_t> const& slice,
                          std::vector<std::int64_t> const& number, F const& f) {
  std::vector<double> result(there ? number.size() : 0);
  if (there)
    for (std::size_t i = 0; i < slice.size(); ++i)
      result[slice[i]] += f(i);
  divide_by(result, number);
  return result;
}

/// From the motion of each particle about the velocity of its slice.
std::vector<double> kinetic_temperatures(Snapshot const& now, std::vector<std::size_t> const& slice,
                                         Profile const& of, double boltzmann) {
  std::vector<double> T(of.number.size());
  for (std::size_t i = 0; i < slice.size(); ++i)
    T[slice[i]] += norm2(now.p[i] - now.mass_of(i) * of.velocity[slice[i]]) / now.mass_of(i);
  for (std::size_t s = 0; s < T.size(); ++s)
    T[s] = of.number[s] > 1 ? T[s] / (3 * static_cast<double>(of.number[s] - 1) * boltzmann) : 0;
  return T;
}

/// Of the particles' virials.
std::vector<double> virial_pressures(Snapshot const& now, std::vector<std::size_t> const& slice,
                                     std::size_t count, double volume) {
  std::vector<double> P(count);
  for (std::size_t i = 0; i < slice.size(); ++i)
    P[slice[i]] += now.virial[i] / (3 * volume);
  return P;
}

/// Adds what the moving particles carry, of which a slice has the mass `mass`.
void add_kinetic_pressures(Profile& of, std::vector<double> const& mass, double boltzmann) {
  for (std::size_t s = 0; s < of.P.size(); ++s)
    if (of.number[s] > 0)
      of.P[s] += of.rho[s] / (mass[s] / static_cast<double>(of.number[s])) * boltzmann * of.T_kin[s];
}

} // namespace

Profile profile(Snapshot const& now, Box const& box, Slices const& slices, double boltzmann) {
  require(slices.axis >= 0 && slices.axis <= 2, "axis of a profile", slices.axis, "must be 0, 1 or 2");
  require(slices.count >= 1, "slices of a profile", slices.count, "must be >= 1");
  bool const densities = !now.rho.empty(), energies = !now.T.empty();
  auto const slice = slices_of(now, box, slices);
  Profile of;
  of.number.resize(slices.count), of.velocity.resize(slices.count);
  std::vector<double> mass(slices.count);
  for (std::size_t i = 0; i < slice.size(); ++i)
    ++of.number[slice[i]], mass[slice[i]] += now.mass_of(i), of.velocity[slice[i]] += now.p[i];
  divide_by(of.velocity, mass);
  of.T_kin = kinetic_temperatures(now, slice, of, boltzmann);
  of.T_int =
      means(energies, slice, of.number, [&](std::size_t i) { return densities ? now.T[i] : 1 / now.T[i]; });
  if (!densities)
    for (double& T : of.T_int)
      T = T > 0 ? 1 / T : 0;
  of.rho = means(densities, slice, of.number, [&](std::size_t i) { return now.rho[i]; });
  of.P_internal = means(densities, slice, of.number, [&](std::size_t i) { return now.P[i]; });
  for (auto const& field : fields)
    if (auto const& values = now.*field.values; field.profiled && !values.empty())
      of.means.emplace_back(&field, means(true, slice, of.number, [&](std::size_t i) { return values[i]; }));
  double const volume = box.volume() / static_cast<double>(slices.count);
  if (densities)
    of.P = of.P_internal;
  else if (!now.virial.empty())
    of.P = virial_pressures(now, slice, slices.count, volume);
  if (!densities)
    for (double const m : mass)
      of.rho.push_back(m / volume);
  add_kinetic_pressures(of, mass, boltzmann);
  return of;
}

} // namespace mesobridge::sdpd
