#include "workflows/trajectory/h5md_kinds.hpp"
#include "md/error.hpp"
#include <cmath>
#include <set>

namespace mesobridge::workflows {

namespace {

constexpr double rounded = 1e-3; // masses are written with few digits

/// An element with a number for each atom; none if it is not wanted, or the file has none that `read` can
/// read.
std::optional<H5mdElement> numbers_of_atoms(Store const& store, std::string const& path, std::size_t atoms,
                                            bool wanted, TrajectoryReading const& how, auto const& read) {
  if (!wanted || !store.contains(path))
    return std::nullopt;
  try {
    H5mdElement element(store, path);
    if (element.frame_shape() != Store::Shape{atoms})
      element.refuse(fmt::format("has frames of {}: must be {}, one for each atom",
                                 extents_text(element.frame_shape()), atoms));
    if (element.fixed() || !element.steps().empty())
      read(element, element.fixed() ? 0 : element.steps().front());
    return element;
  } catch (InputError const& error) {
    how.warn(fmt::format("{}; it is not compared with the mapping", error.what()));
    return std::nullopt;
  }
}

} // namespace

H5mdKinds::H5mdKinds(Store const& store, std::string const& group, std::size_t atoms,
                     TrajectoryReading const& how)
    : how_(how),
      species_(numbers_of_atoms(store, group + "/species", atoms, !how.atoms.empty(), how,
                                [](H5mdElement const& of, std::int64_t step) { of.integers(step, {}); })),
      mass_(numbers_of_atoms(
          store, group + "/mass", atoms, !how.atoms.empty() || !how.masses.empty(), how,
          [](H5mdElement const& of, std::int64_t step) { of.numbers(step, {.above = 0}); })) {}

void H5mdKinds::check(std::int64_t step, std::span<std::size_t const> order) const {
  if (species_ && species_->has(step))
    check_species(step, order);
  if (mass_ && mass_->has(step))
    check_masses(step, order);
}

void H5mdKinds::check_species(std::int64_t step, std::span<std::size_t const> order) const {
  auto const species = species_->integers(step, {});
  std::map<int, std::size_t> first; // atom of each type
  std::set<std::int64_t> types, numbers(species.begin(), species.end());
  for (auto const& atom : how_.atoms)
    types.insert(atom.type);
  bool const same_numbers = types == numbers;
  for (std::size_t k = 0; k < order.size(); ++k) {
    auto const& atom = how_.atoms[k];
    auto const has = species[order[k]];
    if (same_numbers && has != atom.type)
      species_->refuse(fmt::format("says {} of atom {} at step {}, which has the type {} in the mapping's "
                                   "data file",
                                   has, atom.id, step, atom.type));
    auto const earlier = first.emplace(atom.type, k).first->second;
    if (species[order[earlier]] != has)
      species_->refuse(fmt::format("says {} of atom {} and {} of atom {} at step {}, which both have the "
                                   "type {} in the mapping's data file: the atoms are in another order, or "
                                   "others",
                                   species[order[earlier]], how_.atoms[earlier].id, has, atom.id, step,
                                   atom.type));
  }
}

double H5mdKinds::expected_mass(std::size_t atom) const {
  return how_.atoms.empty() ? how_.masses[atom % how_.masses.size()] : how_.atoms[atom].mass;
}

void H5mdKinds::check_masses(std::int64_t step, std::span<std::size_t const> order) const {
  auto const masses = mass_->numbers(step, {.above = 0});
  if (order.empty())
    return;
  auto const unit = mass_->unit();
  double const scale = unit && !unit->empty() && *unit != "1" ? masses[order[0]] / expected_mass(0) : 1;
  for (std::size_t k = 0; k < order.size(); ++k)
    if (double const mass = masses[order[k]], expected = scale * expected_mass(k);
        !(std::abs(mass - expected) <= rounded * expected))
      mass_->refuse(fmt::format("says {} of the atom in place {} at step {}: by the mapping it is {}{}", mass,
                                order[k] + 1, step, expected,
                                scale == 1 ? "" : fmt::format(" in the unit of the first, '{}'", *unit)));
}

} // namespace mesobridge::workflows
