#include "workflows/command/list.hpp"
#include "workflows/command/options.hpp"
#include "workflows/eos_fit/fit_command.hpp"
#include <algorithm>

namespace mesobridge::workflows {

// Each command is a file of this folder, which adds the command's own options to the parser and returns what
// to do once they are parsed; it is declared here and nowhere else.
extern Declaration const md_lj_grid_command;
extern Declaration const md_metal_grid_command;
extern Declaration const md_hugoniot_command;
extern Declaration const md_piston_shock_command;
extern Declaration const md_star_melt_command;
extern Declaration const md_star_vacuum_command;
extern Declaration const md_held_blobs_command;
extern Declaration const md_molecules_command;
extern Declaration const cg_state_grid_command;
extern Declaration const cg_mapping_command;
extern Declaration const cg_blobs_command;
extern Declaration const cg_correlations_command;
extern Declaration const cg_exchange_command;
extern Declaration const cg_transport_command;
extern Declaration const cg_potential_command;
extern Declaration const cg_friction_command;
extern Declaration const cg_entropy_command;
extern Declaration const fit_lj_bwr_command;
extern Declaration const fit_dpde_command;
extern Declaration const eos_eval_command;
Command::Action eos_list_command(CLI::App&);
extern Declaration const eos_hugoniot_command;
extern Declaration const eos_crussard_command;
extern Declaration const eos_cj_command;
extern Declaration const eos_znd_command;
extern Declaration const eos_explosion_command;
extern Declaration const eos_induction_command;
extern Declaration const eos_isentrope_command;
extern Declaration const eos_jwl_command;
extern Declaration const eos_profile_command;
extern Declaration const eos_riemann_command;
extern Declaration const eos_plot_command;
extern Declaration const eos_table_command;
extern Declaration const new_command;
extern Declaration const run_command;
extern Declaration const report_command;
extern Declaration const lammps_plugin_command;
extern Declaration const workflow_lj_to_sdpd_command;
extern Declaration const trade_off_command;
extern Declaration const workflow_star_polymers_command;
extern Declaration const workflow_star_to_dpde_command;
extern Declaration const reproduce_command;
extern Declaration const check_command;
extern Declaration const bench_engine_command;
extern Declaration const bench_eos_command;
extern Declaration const bench_blobs_command;
extern Declaration const schema_command;
extern Declaration const completion_command;
Command::Action man_command(CLI::App&);
Command::Action doctor_command(CLI::App&);

std::vector<Command> commands() {
  std::vector<Command> list{
      {.name = "md lj-grid",
       .summary = "Sample a Lennard-Jones fluid over a grid of states with LAMMPS",
       .example = "mesobridge md lj-grid --preset quick -o out/lj",
       .declare = md_lj_grid_command},
      {.name = "md metal-grid",
       .summary = "Pressure and energy of a metal over densities and temperatures, with LAMMPS",
       .example =
           "mesobridge md metal-grid --potential Cu_mishin1.eam.alloy --rho 8700,9000,9500 --T 300,1200",
       .declare = md_metal_grid_command},
      {.name = "md hugoniot",
       .summary = "Shocked states of a metal (v_S, v_P, P, T, e) from equilibrium MD, with errors",
       .example = "mesobridge md hugoniot --potential Cu_mishin1.eam.alloy --T0 300 --compression 1.1,1.2",
       .declare = md_hugoniot_command},
      {.name = "md piston-shock",
       .summary =
           "A piston that drives a shock into Lennard-Jones argon, a metal or a melt of stars, with LAMMPS",
       .example = "mesobridge md piston-shock --rho0 1150 --T0 500 --vp 500 -o out/md-shock",
       .declare = md_piston_shock_command},
      {.name = "md star-melt",
       .summary = "Melt of star polymers with LAMMPS; blobs are measured while it runs",
       .example = "mesobridge md star-melt --preset quick -o out/melt",
       .declare = md_star_melt_command},
      {.name = "md star-vacuum",
       .summary = "Isolated star polymers with LAMMPS, at set temperatures or energies",
       .example = "mesobridge md star-vacuum --star 6-3 --T 0.85 1 1.18 -o out/vacuum",
       .declare = md_star_vacuum_command},
      {.name = "md held-blobs",
       .summary = "Forces on the molecules of a melt whose centres are held, for their pair friction",
       .example = "mesobridge md held-blobs -o out/held",
       .declare = md_held_blobs_command},
      {.name = "md molecules",
       .summary = "Melt of any molecule with LAMMPS: a data file and its force field; blobs are measured",
       .example = "mesobridge md molecules workflows/scenes/molecules/butane.data --settings "
                  "workflows/scenes/molecules/butane.settings --replicate 6 -o out/butane",
       .declare = md_molecules_command},
      {.name = "cg state-grid",
       .summary = "Pressure, energy and heat capacity of each sampled state, with errors",
       .example = "mesobridge cg state-grid out/lj/lj-grid.h5",
       .declare = cg_state_grid_command},
      {.name = "cg mapping",
       .summary = "The mapping that `cg blobs` takes, of a LAMMPS data file and its force field",
       .example = "mesobridge cg mapping workflows/scenes/molecules/star.data --settings "
                  "workflows/scenes/molecules/star.settings -o star.toml",
       .declare = cg_mapping_command},
      {.name = "cg blobs",
       .summary = "Blobs (R, P, U, Phi) of a trajectory's molecules",
       .example = "mesobridge cg blobs melt.lammpstrj --mapping star.toml -o out/blobs",
       .declare = cg_blobs_command},
      {.name = "cg correlations",
       .summary = "Test the key approximation: are R, P and U of the blobs independent?",
       .example = "mesobridge cg correlations out/melt/blobs.h5",
       .declare = cg_correlations_command},
      {.name = "cg exchange",
       .summary = "how internal energies of molecules decay and pass to neighbours: heat conduction of DPDE",
       .example = "mesobridge cg exchange out/melt/blobs.h5 --friction out/held/friction.csv",
       .declare = cg_exchange_command},
      {.name = "cg transport",
       .summary = "How molecules, or the particles of a run, diffuse and flow: D, viscosity, beside others",
       .example = "mesobridge cg transport out/melt/blobs.h5",
       .declare = cg_transport_command},
      {.name = "cg potential",
       .summary = "A pair potential from the structure of molecules' centres of mass, or the forces on them",
       .example = "mesobridge cg potential out/melt/blobs.h5",
       .declare = cg_potential_command},
      {.name = "cg friction",
       .summary = "Friction of pairs over their distance, from molecules that were held at their centres",
       .example = "mesobridge cg friction out/held/held.h5",
       .declare = cg_friction_command},
      {.name = "cg entropy",
       .summary = "Entropy, temperature and heat capacity of a blob: melt and vacuum, every route",
       .example = "mesobridge cg entropy --melt out/melt/blobs.h5 --vacuum out/vacuum/vacuum.h5",
       .declare = cg_entropy_command},
      {.name = "fit lj-bwr",
       .summary = "Fit the BWR equation of state of the Lennard-Jones fluid to a table of states",
       .example = "mesobridge fit lj-bwr out/lj/state-grid.h5 -o out/lj/model.toml --units argon",
       .declare = fit_lj_bwr_command},
      {.name = "fit dpde",
       .summary = "Internal energy of a DPDE particle from the blobs of a melt or of isolated molecules",
       .example = "mesobridge fit dpde out/vacuum/vacuum.h5 -o out/dpde",
       .declare = fit_dpde_command},
      {.name = "eos eval",
       .summary = "Every thermodynamic quantity of a model at one state",
       .example = "mesobridge eos eval --model argon --rho 1150 --T 1000",
       .declare = eos_eval_command},
      {.name = "eos list",
       .summary = "The equations of state that need no file",
       .example = "mesobridge eos list",
       .declare = eos_list_command},
      {.name = "eos hugoniot",
       .summary = "The state behind a shock, and the Hugoniot curve (-o FILE.csv, .svg or .html)",
       .example = "mesobridge eos hugoniot --model argon --rho0 1150 --T0 500 --vp 500",
       .declare = eos_hugoniot_command},
      {.name = "eos crussard",
       .summary = "Detonation states of an explosive's products (-o FILE.csv, .svg or .html)",
       .example =
           "mesobridge eos crussard --reactant nitromethane --product nitromethane-products --rho0 1104 "
           "--T0 300 --q 4.716e6 --P-max 3e10 -o crussard.svg",
       .declare = eos_crussard_command},
      {.name = "eos cj",
       .summary = "The Chapman-Jouguet detonation: velocity and state of the products",
       .example =
           "mesobridge eos cj --reactant nitromethane --product nitromethane-products --rho0 1104 --T0 300 "
           "--q 4.716e6",
       .declare = eos_cj_command},
      {.name = "eos znd",
       .summary = "The reaction zone of a detonation: spike, profile, length (-o FILE.csv, .svg or .html)",
       .example =
           "mesobridge eos znd --reactant nitromethane --product nitromethane-products --rho0 1104 --T0 300 "
           "--q 4.716e6 --Z 1e15 --Ea 3e-19 -o zone.svg",
       .declare = eos_znd_command},
      {.name = "eos explosion",
       .summary = "The state after an explosion at constant volume, complete or not",
       .example =
           "mesobridge eos explosion --reactant nitromethane --product nitromethane-products --rho0 1104 "
           "--T0 300 --q 4.716e6",
       .declare = eos_explosion_command},
      {.name = "eos induction",
       .summary = "Time to explosion of a hot or shocked explosive; where a detonation overtakes the shock",
       .example =
           "mesobridge eos induction --reactant nitromethane --product nitromethane-products --rho0 1104 "
           "--T0 300 --q 4.716e6 --Z 1e15 --Ea 3e-19 --vp 1764",
       .declare = eos_induction_command},
      {.name = "eos jwl",
       .summary = "A model of detonation products from published JWL numbers, and whether they agree",
       .example =
           "mesobridge eos jwl --rho0 \"1717 kg/m^3\" --A \"524.23 GPa\" --B \"7.678 GPa\" --R1 4.2 --R2 1.1 "
           "--omega 0.34 --E0 \"8.5 GPa\" --D \"7980 m/s\" --P-CJ \"29.5 GPa\" --m0 \"227 u\" -o comp-b.toml",
       .declare = eos_jwl_command},
      {.name = "eos isentrope",
       .summary = "A smooth compression or release at constant entropy (-o FILE.csv, .svg or .html)",
       .example = "mesobridge eos isentrope --model tin --rho0 9000 --T0 1500 --P 0",
       .declare = eos_isentrope_command},
      {.name = "eos profile",
       .summary = "The front of a shock by the Navier-Stokes equations (-o FILE.csv, .svg or .html)",
       .example =
           "mesobridge eos profile --model argon --rho0 1150 --T0 500 --vp 500 --eta 1e-4 -o front.svg",
       .declare = eos_profile_command},
      {.name = "eos riemann",
       .summary = "Two half spaces in contact: their waves, exactly (-o FILE.csv, .svg or .html)",
       .example =
           "mesobridge eos riemann --left nitromethane-products --rho-left 1600 --T-left 4000 --right water "
           "--rho-right 997 --T-right 300 -o waves.svg",
       .declare = eos_riemann_command},
      {.name = "eos plot",
       .summary = "Isotherms, Hugoniot curve and isentrope of one or several models in one drawing",
       .example =
           "mesobridge eos plot --model argon --T 300 1000 --rho0 1150 --T0 500 --rho-min 800 --rho-max 1700 "
           "-o argon.svg",
       .declare = eos_plot_command},
      {.name = "eos table",
       .summary = "A table of P, e, s, c_v and c over densities and temperatures (-o FILE.csv or .h5)",
       .example = "mesobridge eos table --model argon --rho-min 800 --rho-max 1600 --T-min 200 --T-max 1000 "
                  "-o argon.csv",
       .declare = eos_table_command},
      {.name = "new",
       .summary = "Write a commented example scene",
       .example = "mesobridge new argon-1000K -o my.toml",
       .declare = new_command},
      {.name = "run",
       .summary = "Run an SDPD scene",
       .example = "mesobridge run workflows/scenes/argon-1000K.toml -o out/argon --set particles.K=50",
       .declare = run_command},
      {.name = "report",
       .summary = "The report of a run once more, or the numbers of several runs side by side",
       .example = "mesobridge report out/argon out/argon-K100 -o out/beside",
       .declare = report_command},
      {.name = "lammps-plugin",
       .summary = "A run's last state for a LAMMPS of your own, with a plugin: input, data, how to build",
       .example = "mesobridge lammps-plugin out/argon --steps 100000 -o out/argon-lammps",
       .declare = lammps_plugin_command},
      {.name = "workflow lj-to-sdpd",
       .summary = "Lennard-Jones MD, equation of state and SDPD in one chain, with a report",
       .example = "mesobridge workflow lj-to-sdpd --preset quick -o out/lj-to-sdpd",
       .declare = workflow_lj_to_sdpd_command},
      {.name = "trade-off",
       .summary = "Cost against accuracy of schemes and time steps for a scene; recommends one",
       .example = "mesobridge trade-off workflows/scenes/argon-1000K.toml --drift 1e-6/ps -o out/trade-off",
       .declare = trade_off_command},
      {.name = "workflow star-to-dpde",
       .summary = "From a melt of star polymers to a DPDE fluid in turn, and what it keeps of the molecules",
       .example = "mesobridge workflow star-to-dpde --star 6-3 --rho 0.3 -o out/star-to-dpde",
       .declare = workflow_star_to_dpde_command},
      {.name = "workflow star-polymers",
       .summary = "Chapter 3 of the thesis: melts and isolated stars, key approximation, entropy, report",
       .example = "mesobridge workflow star-polymers --star 4-5 --rho 0.2 0.4 -o out/star-polymers",
       .declare = workflow_star_polymers_command},
      {.name = "reproduce",
       .summary = "A figure or table of the thesis, ours beside the printed one",
       .example = "mesobridge reproduce table-4.1 --preset quick -o out/table-4.1",
       .declare = reproduce_command},
      {.name = "check",
       .summary = "Validate a scene, print it as resolved and estimate its cost; runs nothing",
       .example = "mesobridge check workflows/scenes/argon-1000K.toml --set particles.K=1000",
       .declare = check_command},
      {.name = "bench engine",
       .summary = "Time the SDPD engine: microseconds per particle and step",
       .example = "mesobridge bench engine --eos ideal-gas --threads 2 --json",
       .declare = bench_engine_command},
      {.name = "bench eos",
       .summary = "Time the equations of state: nanoseconds per call, medians of repeats",
       .example = "mesobridge bench eos --model tin --json",
       .declare = bench_eos_command},
      {.name = "bench blobs",
       .summary = "What measuring blobs costs beside the MD, in processor time on one core",
       .example = "mesobridge bench blobs --molecules 500",
       .declare = bench_blobs_command},
      {.name = "schema",
       .summary = "JSON schema of scenes or of models, by which editors complete and check them",
       .example = "mesobridge schema scene -o scene.schema.json",
       .declare = schema_command},
      {.name = "completion",
       .summary = "What lets a shell complete commands and options",
       .example = "eval \"$(mesobridge completion bash)\"",
       .declare = completion_command},
      {.name = "man",
       .summary = "Manual pages of all commands, in a folder",
       .example = "mesobridge man -o out/man/man1 && man -M out/man mesobridge-run",
       .declare = man_command},
      {.name = "doctor",
       .summary = "What is installed, what is missing and how to get it",
       .example = "mesobridge doctor",
       .declare = doctor_command},
  };
  // One more for every equation of state that can be fitted.
  auto place = std::ranges::find(list, "fit lj-bwr", &Command::name);
  for (auto const& kind : fitting::fittable_kinds())
    place = list.insert(place + 1, fit_kind_command(kind));
  return list;
}

} // namespace mesobridge::workflows
