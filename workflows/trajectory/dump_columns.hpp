#pragma once
#include "workflows/trajectory/dump_lines.hpp"
#include <array>
#include <map>
#include <optional>

namespace mesobridge::workflows {

/// Which column of a LAMMPS dump holds what.
class DumpColumns {
 public:
  /// Throws InputError when a column that is needed is not there, or one is there twice.
  DumpColumns(std::string_view names, DumpLines const& lines);

  std::size_t count() const { return count_; }
  std::size_t id = 0;
  std::optional<std::size_t> molecule, type, mass, potential;
  std::array<std::size_t, 3> q{}, v{};
  std::optional<std::array<std::size_t, 3>> f; ///< forces, if all three are there
  bool scaled = false;                         ///< positions in parts of the box's edges

 private:
  std::optional<std::size_t> find(std::string const& name) const;
  std::size_t need(std::string const& name, DumpLines const& lines) const;

  std::map<std::string, std::size_t> places_;
  std::size_t count_ = 0;
};

} // namespace mesobridge::workflows
