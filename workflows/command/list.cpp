#include "workflows/command/list.hpp"
#include "workflows/command/studies.hpp"

namespace mesobridge::workflows {

// clang-format off
std::vector<Command> commands() {
  return {
      md_lj_grid_command(),
      md_metal_grid_command(),
      md_hugoniot_command(),
      cg_state_grid_command(),
      fit_lj_bwr_command(),
      fit_mie_gruneisen_command(),
      fit_hz_command(),
      fit_jwl_command(),
      eos_eval_command(),
      eos_list_command(),
      eos_hugoniot_command(),
      eos_crussard_command(),
      eos_cj_command(),
      eos_isentrope_command(),
      eos_profile_command(),
      eos_riemann_command(),
      eos_plot_command(),
      eos_table_command(),
      run_command(),
      workflow_lj_to_sdpd_command(),
      reproduce_command(),
      check_command(),
      bench_engine_command(),
      bench_eos_command(),
      doctor_command(),
  };
}
// clang-format on

} // namespace mesobridge::workflows
