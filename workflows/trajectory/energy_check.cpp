#include "workflows/trajectory/energy_check.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <gsl/gsl_statistics_double.h>

namespace mesobridge::workflows {

namespace {

/// Energies of two programs that compute the same differ by the digits of the dump only.
constexpr double close_enough = 1e-3;

/// A good time step keeps the energy to a few per cent of what its kinetic part varies; a thermostat, or
/// forces that are not the run's, vary it as much as that.
constexpr double most_wander = 0.2;

/// In units of the largest value, whose square may be beyond all numbers.
double sd(std::vector<double> values) {
  auto const by_size = [](double a, double b) { return std::abs(a) < std::abs(b); };
  double const largest = std::abs(*std::ranges::max_element(values, by_size));
  if (largest == 0)
    return 0;
  for (double& value : values)
    value /= largest;
  return largest * gsl_stats_sd(values.data(), 1, values.size());
}

bool agree(double a, double b, double scale) {
  return std::abs(a - b) <= close_enough * scale;
}

} // namespace

void EnergyCheck::add(std::int64_t step, FoundBlobs const& found, std::optional<double> said) {
  rows_.push_back({.step = step,
                   .kinetic = found.kinetic,
                   .potential = found.potential,
                   .bonds = found.bonds,
                   .said = said});
}

std::string EnergyCheck::guess(Row const& row) const {
  if (laws_ == Laws::of_lammps)
    return "are data file and settings those of the run, with its cut-offs and special_bonds?";
  double const said = *row.said, scale = std::abs(said) + row.kinetic;
  if (agree(row.potential + row.bonds, said, scale))
    return "with bonds twice as stiff they agree: the k of the bonds is LAMMPS's K, for which the mapping "
           "has "
           "the key K";
  if (agree(row.potential - row.bonds / 2, said, scale))
    return "with bonds half as stiff they agree: K in the mapping is LAMMPS's, K (r - l)^2; the key k is "
           "that "
           "of k (r - l)^2 / 2";
  return "are all its bonds, pairs and cut-offs in the mapping, in the run's units?";
}

std::optional<std::string> EnergyCheck::potential_warning() const {
  auto const wrong = std::ranges::find_if(rows_, [](Row const& row) {
    return row.said && !agree(row.potential, *row.said, std::abs(*row.said) + row.kinetic);
  });
  if (wrong == rows_.end())
    return std::nullopt;
  return fmt::format("the potential energy at step {} is {:.6g} by the mapping, {:.6g} by the trajectory: {}",
                     wrong->step, wrong->potential, *wrong->said, guess(*wrong));
}

std::optional<std::string> EnergyCheck::drift_warning() const {
  constexpr std::size_t fewest = 3;
  if (rows_.size() < fewest)
    return std::nullopt;
  std::vector<double> energies, kinetic;
  for (auto const& row : rows_)
    energies.push_back(row.energy()), kinetic.push_back(row.kinetic);
  if (!(sd(energies) > most_wander * sd(kinetic)))
    return std::nullopt;
  return fmt::format(
      "the total energy wanders: its standard deviation is {:.3g}, that of the kinetic energy {:.3g} "
      "(from {:.6g} to {:.6g}). A thermostat does that; at constant energy {} are not those of the run",
      sd(energies), sd(kinetic), energies.front(), energies.back(),
      laws_ == Laws::of_lammps ? "masses, force field or units of the data file and the settings"
                               : "the mapping's masses, bonds (k or K), pairs or units");
}

std::vector<std::string> EnergyCheck::warnings() const {
  std::vector<std::string> all;
  for (auto const& warning : {potential_warning(), drift_warning()})
    if (warning)
      all.push_back(*warning);
  return all;
}

void EnergyCheck::put(Json& json) const {
  json["energy_first"] = rows_.front().energy();
  json["energy_last"] = rows_.back().energy();
  json["potential_energy_first"] = rows_.front().potential;
  if (rows_.front().said)
    json["potential_energy_first_of_trajectory"] = *rows_.front().said;
}

} // namespace mesobridge::workflows
