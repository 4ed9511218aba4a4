#include "workflows/metal/metal_options.hpp"
#include "workflows/earlier_results.hpp"
#include "workflows/lj/preset.hpp"
#include "workflows/shared_options.hpp"

namespace mesobridge::workflows {

void add_options(CLI::App& app, MetalOptions& options) {
  app.add_option("--potential", options.potential,
                 "Embedded-atom potential (.eam, .eam.alloy, .eam.fs): a file, or a name in lammps-data")
      ->required()
      ->type_name("FILE");
  app.add_option("--element", options.element, "Element of the potential (default: its only one)")
      ->type_name("NAME");
  app.add_option("--lattice", options.lattice, "fcc, bcc or hcp (default: the potential's)")
      ->type_name("NAME");
  add_preset(app, options.preset, "quick (a minute or two), standard (an hour) or paper");
  app.add_option("--start", options.start,
                 "Begin as crystal or melt it first; a short run stays what it began as "
                 "beyond the melting point")
      ->check(CLI::IsMember({"solid", "liquid"}));
  app.add_option("--atoms", options.atoms, "At least so many atoms of one state")->type_name("INT");
  app.add_option("--melt-steps", options.melt_steps, "Steps that melt the crystal of a liquid start")
      ->type_name("INT");
  app.add_option("--equilibration-steps", options.equilibration_steps, "Steps before the samples")
      ->type_name("INT");
  app.add_option("--sampling-steps", options.sampling_steps, "Sampled steps of one state")->type_name("INT");
  app.add_option("--time-step", options.time_step, "Time step [neighbour distance/sound speed]")
      ->type_name("REAL");
  app.add_flag("--resume", options.resume, "Keep the states that an interrupted run has completed");
  add_started_by_ourselves(app, options.started_by_ourselves);
}

md::MetalSettings settings_of(MetalOptions const& options, Context const& context) {
  auto const potential = md::read_metal_potential(options.potential, options.element);
  auto settings = md::metal_settings(preset_of(options.preset), potential);
  if (!options.lattice.empty())
    settings.lattice = md::lattice_of(options.lattice);
  settings.start = options.start == "liquid" ? md::MetalStart::liquid : md::MetalStart::solid;
  settings.least_atoms = options.atoms.value_or(settings.least_atoms);
  settings.melt_steps = options.melt_steps.value_or(settings.melt_steps);
  settings.equilibration_steps = options.equilibration_steps.value_or(settings.equilibration_steps);
  settings.sampling_steps = options.sampling_steps.value_or(settings.sampling_steps);
  settings.reduced_time_step = options.time_step.value_or(settings.reduced_time_step);
  settings.seed = context.options.seed.value_or(settings.seed);
  return settings;
}

void keep_earlier_results(MetalOptions const& options, MetalJob const& job,
                          std::filesystem::path const& directory, std::string const& name,
                          Context const& context) {
  if (!job.resume)
    keep_earlier_results(context, options.started_by_ourselves, directory,
                         {job.runs, directory / (name + ".h5"), directory / (name + ".csv"),
                          directory / (name + ".json"), job.settings.log_file});
}

} // namespace mesobridge::workflows
