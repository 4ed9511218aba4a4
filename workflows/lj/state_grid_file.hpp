#pragma once
#include "cg/state_grid.hpp"
#include "workflows/lj/grid_file.hpp"

namespace mesobridge::workflows {

/// The equation-of-state table of a grid of runs, and the states that had to be left out.
struct AnalysedGrid {
  cg::StateGrid grid;
  std::vector<std::string> left_out; ///< "rho* = ..., T* = ...: why"
};

/// Estimates every state of the grid. States that an interruption cut short are left out, and named; a state
/// whose run is complete but too short throws PhysicsError, as does a grid of which nothing remains.
AnalysedGrid analyse_lj_grid(LjGridData const& data);

/// Writes the table as HDF5: one column a quantity, standard errors beside. Throws EnvironmentError.
void write_state_grid(std::filesystem::path const& file, cg::StateGrid const& grid,
                      Provenance const& provenance);

/// The same as JSON.
Json state_grid_json(cg::StateGrid const& grid);

/// Reads such a file. Throws InputError.
cg::StateGrid read_state_grid(std::filesystem::path const& file);

} // namespace mesobridge::workflows
