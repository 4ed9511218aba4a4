#pragma once
#include "workflows/trajectory/h5md_element.hpp"
#include "workflows/trajectory/trajectory_file.hpp"
#include <span>

namespace mesobridge::workflows {

/// What an H5MD file says about the kinds of its atoms, elements `species` and `mass`, compared with what the
/// mapping expects. Numbers of species are the file's own: two types of the mapping may be one species, one
/// type is never two; but where the file has the types' numbers, they mean these. Masses in a unit of the
/// file's must be those of the mapping but for a common factor.
class H5mdKinds {
 public:
  /// `group` is that of the particles, so many atoms. What is there and cannot be read is not compared, with
  /// a warning.
  H5mdKinds(Store const& store, std::string const& group, std::size_t atoms, TrajectoryReading const& how);

  /// Refuses the atoms of a step that are not those that are expected; `order` are their places in the file.
  void check(std::int64_t step, std::span<std::size_t const> order) const;

 private:
  void check_species(std::int64_t step, std::span<std::size_t const> order) const;
  void check_masses(std::int64_t step, std::span<std::size_t const> order) const;
  double expected_mass(std::size_t atom) const;

  TrajectoryReading const& how_;
  std::optional<H5mdElement> species_, mass_;
};

} // namespace mesobridge::workflows
