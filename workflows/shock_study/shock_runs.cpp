#include "workflows/shock_study/shock_runs.hpp"
#include "workflows/interrupt.hpp"
#include "workflows/job_pool.hpp"
#include "workflows/sdpd/piston_shock.hpp"
#include "workflows/sdpd/run_folder.hpp"
#include "workflows/sdpd/shock.hpp"
#include "workflows/study/stored_part.hpp"
#include "workflows/version.hpp"
#include <algorithm>
#include <mutex>

namespace mesobridge::workflows {

template <class Result, class F>
requires std::is_same_v<std::remove_const_t<Result>, ShockRow>
void for_each_member(Result& r, F const& f) {
  f("model", r.model), f("K", r.K), f("eta", r.eta), f("dt", r.dt_reduced), f("spacing", r.spacing);
  f("particles", r.particles), f("v_S", r.v_S), f("rho", r.rho), f("mass_per_volume", r.mass_per_volume);
  f("P", r.P), f("T", r.T), f("T_kin", r.T_kin), f("depth", r.depth), f("profile", r.profile),
      f("profile_se", r.profile_se);
  f("failure", r.failure);
}

namespace {

constexpr double end_zone = 8;       ///< spacings before the far end at which the run may end
constexpr std::int64_t frames = 100; // about so many of a run

/// Steps until the front, whose piston was ramped over 8 l/v_S, has come near the far end.
std::int64_t steps_of(PistonScene const& wanted, Scene const& scene) {
  auto const settings = settings_of(scene, 1);
  auto const shock = piston_shock(settings, wanted.v_P);
  auto const units = settings.units();
  double const v_S = shock->v_S / units.velocity(), ramp = 8 / v_S;
  double const way = static_cast<double>(wanted.lattice[2]) - end_zone;
  return static_cast<std::int64_t>((way / v_S + ramp / 2) / wanted.dt);
}

void make_folder(std::filesystem::path const& folder) {
  std::error_code ignored;
  std::filesystem::create_directories(folder, ignored); // writing there says what is wrong
}

/// From where the run that is in the folder goes on; nothing where there is none of this scene.
std::optional<PastRun> past_in(RunFolder const& folder, Scene const& scene) {
  if (!folder.has_checkpoint())
    return std::nullopt;
  try {
    auto stored = read_checkpoint(folder.checkpoint());
    resumed_scene(scene, stored.scene, stored.inputs, folder.checkpoint());
    return past_run(std::move(stored));
  } catch (InputError const&) {
    return std::nullopt; // of another scene, or damaged: it begins again
  }
}

Scene as_far_as(Scene scene, std::optional<PastRun> const& past, RunFolder const& folder) {
  return past ? resumed_scene(std::move(scene), past->stored.scene, past->stored.inputs, folder.checkpoint())
              : scene;
}

ShockRow row_of(ShockCase const& one, RunResult const& run, Store const& store) {
  auto const& settings = run.settings;
  ShockRow row{.model = one.model,
               .K = settings.K(),
               .eta = one.scene.transport.eta,
               .dt_reduced = settings.dt,
               .spacing = settings.spacing() * settings.units().length(),
               .particles = one.scene.particles.N};
  auto const shock = shock_of(store, run.scene, settings);
  if (!shock) {
    row.failure = fmt::format("no steady shock in the box within {} steps", run.scene.run.steps);
    return row;
  }
  row.v_S = shock->measured.v_S, row.rho = shock->measured.rho, row.P = shock->measured.P;
  row.T = shock->measured.T, row.T_kin = shock->T_kin, row.mass_per_volume = shock->mass_per_volume;
  row.depth = shock->depth;
  for (auto const& rho : shock->rho)
    row.profile.push_back(rho.mean), row.profile_se.push_back(rho.se);
  return row;
}

ShockRow run_one(ShockCase const& one, std::filesystem::path const& directory, Context const& context,
                 std::function<bool(std::uint64_t)> const& keep_going) {
  make_folder(directory);
  RunFolder const folder(directory);
  auto past = past_in(folder, one.scene);
  auto const scene = as_far_as(one.scene, past, folder);
  try {
    auto const run = run_scene(scene, {.directory = directory,
                                       .threads = 1,
                                       .past = std::move(past),
                                       .command = context.command_line(),
                                       .keep_going = keep_going});
    return row_of(one, run, Store(folder.run_file(), Store::Mode::read));
  } catch (PhysicsError const& error) {
    return {.model = one.model,
            .K = one.scene.particles.K,
            .eta = one.scene.transport.eta,
            .dt_reduced = one.scene.scheme.dt.value,
            .particles = one.scene.particles.N,
            .failure = error.what()};
  }
}

/// The part of all steps that is done.
class Share {
 public:
  Share(std::vector<ShockCase> const& cases, Progress& progress) : progress_(progress) {
    for (auto const& one : cases)
      total_ += work_of(one.scene, one.scene.run.equilibrate + one.scene.run.steps);
  }
  void tell(Scene const& scene, std::uint64_t steps, double& told) {
    std::lock_guard const lock(mutex_);
    double const now = work_of(scene, static_cast<std::int64_t>(steps));
    done_ += now - told, told = now;
    progress_.update(std::min(1.0, done_ / total_), scene.title);
  }

 private:
  static double work_of(Scene const& scene, std::int64_t steps) {
    return static_cast<double>(scene.particles.N) * static_cast<double>(steps);
  }
  Progress& progress_;
  std::mutex mutex_;
  double total_ = 0, done_ = 0;
};

} // namespace

Scene piston_scene(PistonScene const& wanted) {
  Scene scene;
  scene.title =
      fmt::format("{}, K = {:g}, eta = {:g} Pa s, {}", wanted.eos, wanted.K, wanted.eta, wanted.scheme);
  scene.fluid.eos = wanted.eos, scene.fluid.rho = wanted.rho, scene.fluid.T = wanted.T;
  scene.particles.K = wanted.K;
  scene.particles.N = wanted.lattice[0] * wanted.lattice[1] * wanted.lattice[2];
  if (wanted.eos == "ideal-gas")
    scene.fluid.m0 = 1e-25;
  scene.particles.density = wanted.density;
  if (wanted.as_in_the_thesis) {
    scene.particles.kernel = "cubic", scene.particles.density = "plain", scene.box.ramp = 0;
    if (wanted.eos != "ideal-gas") // whose particles the thesis gives 3/2 (K-1) k_B: free of their own motion
      scene.fluid.centre_of_mass = "bulk";
  }
  scene.box.lattice = {wanted.lattice.begin(), wanted.lattice.end()};
  scene.box.z = "walls", scene.box.piston = wanted.v_P;
  scene.transport.eta = wanted.eta;
  scene.scheme.name = wanted.scheme, scene.scheme.dt.value = wanted.dt;
  scene.run.equilibrate = wanted.equilibrate;
  scene.run.seed = static_cast<std::int64_t>(wanted.seed);
  scene.run.steps = steps_of(wanted, scene);
  scene.run.sample_every = std::max<std::int64_t>(1, scene.run.steps / frames);
  scene.profile = {.axis = "z", .bins = wanted.lattice[2], .every = scene.run.sample_every, .quantities = {}};
  return scene;
}

std::vector<ShockRow> run_shocks(std::string const& title, std::vector<ShockCase> const& cases,
                                 ReproduceOptions const& options, Context const& context) {
  auto const directory = options.directory / "runs";
  auto progress = context.progress(title, 1);
  Share share(cases, progress);
  std::vector<ShockRow> rows(cases.size());
  std::vector<std::function<void()>> jobs;
  for (std::size_t k = 0; k < cases.size(); ++k)
    jobs.push_back([&, k] {
      auto const& one = cases[k];
      make_folder(directory / one.name);
      auto const identity = fmt::format("{}\n{}", resolved_toml(one.scene), git_commit());
      double told = 0;
      rows[k] = stored_or_made(directory / one.name / "row.json", identity, [&] {
        return run_one(one, directory / one.name, context, [&](std::uint64_t steps) {
          share.tell(one.scene, steps, told);
          return !interrupt_requested();
        });
      });
      if (!rows[k].failed()) {
        auto const settings = settings_of(one.scene, 1);
        rows[k].Re_l = front_reynolds_number(settings, *shock_before_piston(settings));
      }
    });
  run_jobs(jobs, options.threads);
  progress.finish();
  return rows;
}

} // namespace mesobridge::workflows
