#include "workflows/command/list.hpp"
#include "workflows/eos_fit/fit_command.hpp"
#include <algorithm>

namespace mesobridge::workflows {

// Each command is a file of this folder; it is declared here and nowhere else.
Command md_lj_grid_command();
Command md_metal_grid_command();
Command md_hugoniot_command();
Command md_star_melt_command();
Command md_star_vacuum_command();
Command cg_state_grid_command();
Command cg_blobs_command();
Command cg_correlations_command();
Command cg_entropy_command();
Command fit_lj_bwr_command();
Command fit_dpde_command();
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
Command new_command();
Command run_command();
Command workflow_lj_to_sdpd_command();
Command trade_off_command();
Command workflow_star_polymers_command();
Command reproduce_command();
Command check_command();
Command bench_engine_command();
Command bench_eos_command();
Command bench_blobs_command();
Command doctor_command();

std::vector<Command> commands() {
  std::vector<Command> list{
      md_lj_grid_command(),
      md_metal_grid_command(),
      md_hugoniot_command(),
      md_star_melt_command(),
      md_star_vacuum_command(),
      cg_state_grid_command(),
      cg_blobs_command(),
      cg_correlations_command(),
      cg_entropy_command(),
      fit_lj_bwr_command(),
      fit_dpde_command(),
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
      new_command(),
      run_command(),
      workflow_lj_to_sdpd_command(),
      trade_off_command(),
      workflow_star_polymers_command(),
      reproduce_command(),
      check_command(),
      bench_engine_command(),
      bench_eos_command(),
      bench_blobs_command(),
      doctor_command(),
  };
  // One more for every equation of state that can be fitted.
  auto place = std::ranges::find(list, "fit lj-bwr", &Command::name);
  for (auto const& kind : fitting::fittable_kinds())
    place = list.insert(place + 1, fit_kind_command(kind));
  return list;
}

} // namespace mesobridge::workflows
