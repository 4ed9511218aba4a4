#pragma once
#include "cg/state_grid.hpp"
#include <string>

namespace mesobridge::workflows {

/// States of the Lennard-Jones fluid from a CSV file, a row each, in reduced units per atom: `rho`, `T`, the
/// energy as `U` or, without its kinetic part 3/2 T, as `U_res`, the pressure `P`, their standard errors
/// `U_se` (`U_res_se`) and `P_se`, and the covariance of both, `cov_UP`, where it is known. Throws InputError
/// with file, line and column for a column that is missing or not known, an empty cell, rho or T not > 0.
cg::StateGrid parse_state_csv(std::string const& text, std::string const& file);

} // namespace mesobridge::workflows
