#include "workflows/star/chapter_runs.hpp"
#include "md/error.hpp"
#include "md/rank_launcher.hpp"
#include "workflows/farm.hpp"
#include "workflows/ranks.hpp"
#include "workflows/star/blob_file.hpp"
#include "workflows/text_file.hpp"

namespace mesobridge::workflows {

namespace {

/// A run that is to be made.
struct Needed {
  std::vector<std::string> words;
  double work; ///< as work_of
  std::function<void()> make_on_ranks;
};

/// The frames that a finished run of these settings has left there; -1 without one.
std::int64_t frames_there(std::filesystem::path const& summary, std::string const& fingerprint) {
  if (!std::filesystem::exists(summary))
    return -1;
  auto const json = Json::parse(read_text_file(summary), nullptr, false);
  bool const same = !json.is_discarded() && json.value("settings", "") == fingerprint;
  return same ? json.value("frames", std::int64_t{-1}) : -1;
}

/// Whether there is a checkpoint to go on from. What other settings have left there is not replaced unasked.
bool to_be_resumed(std::filesystem::path const& blobs, std::filesystem::path const& checkpoint,
                   std::string const& fingerprint) {
  if (!std::filesystem::exists(checkpoint) || !std::filesystem::exists(blobs))
    return false;
  Store::mend(blobs);
  if (auto const was = read_blob_head(blobs).fingerprint; was != fingerprint)
    throw InputError(fmt::format("'{}' is of a run with other settings ({}): remove it or choose another "
                                 "folder with -o",
                                 blobs.string(), was));
  return true;
}

void make_folder(std::filesystem::path const& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    throw EnvironmentError(fmt::format("cannot create directory '{}': {}", folder.string(), error.message()));
}

std::int64_t frames_wanted(MeltJob const& job) {
  return md::frames_of(job.settings);
}

std::int64_t frames_wanted(VacuumJob const&) {
  return 0; // its length is one of the settings that the fingerprint tells
}

/// Seconds of one core, by what was measured: 31 ns a bead and step at rho = 0.1, 54 ns at 0.5.
double work_of(MeltJob const& job) {
  auto const& s = job.settings;
  auto const last = md::plan(s).back();
  double const bead_steps = double(s.molecules) * s.star.atoms() * double(last.first_step + last.steps);
  return bead_steps * (25e-9 + 58e-9 * s.rho);
}

/// The same: 38 ns for isolated 6-3 stars at set temperatures on two ranks.
double work_of(VacuumJob const& job) {
  auto const& s = job.settings;
  return double(s.molecules) * s.star.atoms() * double(s.equilibration_steps + s.sampling_steps) * 38e-9;
}

void sample_on_ranks(MeltJob const& job, Context const& context) {
  sample_melt_on_ranks(job, context);
}

void sample_on_ranks(VacuumJob const& job, Context const& context) {
  sample_vacuum_on_ranks(job, context);
}

template <class Job>
void add_needed(std::vector<Needed>& needed, Job job, Context const& context) {
  auto const fingerprint = job.settings.fingerprint();
  make_folder(job.settings.directory);
  if (auto const there = frames_there(job.summary(), fingerprint); there >= 0 && there >= frames_wanted(job))
    return;
  job.resume = to_be_resumed(job.blobs(), job.settings.restart_file(), fingerprint);
  needed.push_back({words_of(job), work_of(job), [job, &context] { sample_on_ranks(job, context); }});
}

void make_on_one_core_each(std::vector<Needed> const& needed, Context const& context) {
  std::vector<FarmedRun> runs;
  for (auto const& one : needed) {
    FarmedRun run{{"/proc/self/exe"}, one.work}; // whatever has become of its file
    run.argv.insert(run.argv.end(), one.words.begin(), one.words.end());
    run.argv.insert(run.argv.end(), {"--ranks", "1", "--quiet"});
    runs.push_back(std::move(run));
  }
  farm("runs of stars", std::move(runs), ranks_of(context), context);
}

/// Whether all these runs together are better made on one core each. Which of them are there already does not
/// count: a run goes on, bit for bit, on as many ranks as it began on.
template <class... Jobs>
bool one_core_each(Context const& context, Jobs const&... jobs) {
  std::vector<double> work;
  auto const add = [&](auto const& list) {
    for (auto const& job : list)
      work.push_back(work_of(job));
  };
  (add(jobs), ...);
  return !md::already_on_ranks() && farming_pays(work, ranks_of(context));
}

} // namespace

void make_runs(std::vector<MeltJob> const& melts, std::vector<VacuumJob> const& vacuums,
               Context const& context) {
  std::vector<Needed> needed;
  for (auto const& melt : melts)
    add_needed(needed, melt, context);
  for (auto const& vacuum : vacuums)
    add_needed(needed, vacuum, context);
  if (needed.empty())
    return;
  if (one_core_each(context, melts, vacuums))
    return make_on_one_core_each(needed, context);
  for (auto const& one : needed)
    one.make_on_ranks();
}

} // namespace mesobridge::workflows
