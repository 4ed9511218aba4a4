#pragma once
#include "cg/hugoniot.hpp"
#include "workflows/provenance.hpp"
#include <span>

namespace mesobridge::workflows {

/// A table of states as CSV, `rho_kg_m3,T_K,P_Pa,P_se_Pa,e_J_kg,e_se_J_kg`: what `fit` reads.
std::string metal_grid_csv(std::span<cg::MetalPoint const> points);
Json metal_grid_json(std::span<cg::MetalPoint const> points);
std::string metal_grid_text(std::span<cg::MetalPoint const> points);

/// A Hugoniot curve as CSV: initial state, v_P, v_S and the state behind the shock, with standard errors.
std::string hugoniot_csv(std::span<cg::HugoniotPoint const> points);
Json hugoniot_json(std::span<cg::HugoniotPoint const> points);
std::string hugoniot_text(std::span<cg::HugoniotPoint const> points);

/// Writes the columns of the CSV and what else is known of each point as HDF5, one dataset a column.
void write_metal_grid(std::filesystem::path const& file, std::span<cg::MetalPoint const> points,
                      std::string const& description, Provenance const& provenance);
void write_hugoniot(std::filesystem::path const& file, std::span<cg::HugoniotPoint const> points,
                    std::string const& description, Provenance const& provenance);

/// Sentences on what limits the meaning of these states: phases other than the start, the end of the
/// potential's table. Empty when there is nothing to say.
std::vector<std::string> warnings_on(std::span<cg::MetalPoint const> points,
                                     md::MetalSettings const& settings);

} // namespace mesobridge::workflows
