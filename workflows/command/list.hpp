#pragma once
#include "workflows/command.hpp"
#include <vector>

namespace mesobridge::workflows {

/// Every command of the program, in the order in which the help shows them. A new command is its own file in
/// this folder, one declaration here and one line in list.cpp.
std::vector<Command> commands();

Command md_lj_grid_command();
Command md_metal_grid_command();
Command md_hugoniot_command();
Command cg_state_grid_command();
Command fit_lj_bwr_command();
Command eos_eval_command();
Command eos_list_command();
Command eos_hugoniot_command();
Command eos_crussard_command();
Command eos_cj_command();
Command eos_isentrope_command();
Command eos_profile_command();
Command eos_riemann_command();
Command eos_plot_command();
Command eos_table_command();
Command check_command();
Command run_command();
Command workflow_lj_to_sdpd_command();
Command bench_engine_command();
Command bench_eos_command();
Command doctor_command();

} // namespace mesobridge::workflows
