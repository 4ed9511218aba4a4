#include "workflows/metal/metal_sampler.hpp"
#include "md/error.hpp"
#include "md/metal_grid.hpp"
#include "workflows/interrupt.hpp"
#include <algorithm>

namespace mesobridge::workflows {

namespace {

std::vector<double> pack(std::span<md::MetalState const> states) {
  std::vector<double> numbers;
  for (auto const& state : states)
    numbers.insert(numbers.end(), {state.rho, state.T});
  return numbers;
}

std::vector<md::MetalState> unpack(std::span<double const> numbers) {
  std::vector<md::MetalState> states;
  for (std::size_t k = 0; k + 1 < numbers.size(); k += 2)
    states.push_back({.rho = numbers[k], .T = numbers[k + 1]});
  return states;
}

/// The complete series of the file to be resumed.
std::vector<MetalSeries> kept_series(MetalJob const& job) {
  if (!job.resume || !std::filesystem::exists(job.runs))
    return {};
  auto data = read_metal_file(job.runs);
  if (data.fingerprint != fingerprint(job.settings))
    throw InputError(fmt::format(
        "--resume: '{}' was made with other settings ({}); without --resume it is moved into a backup",
        job.runs.string(), data.fingerprint));
  std::erase_if(data.series, [](MetalSeries const& series) { return !series.end; });
  return std::move(data.series);
}

auto series_at(std::vector<MetalSeries>& series, md::MetalState state) {
  return std::find_if(series.begin(), series.end(), [&](auto const& s) { return s.state == state; });
}

} // namespace

MetalSampler::MetalSampler(md::MpiWorld const& world, MetalJob job, Context const& context)
    : world_(world), job_(std::move(job)), context_(context), series_(kept_series(job_)) {
  file_.emplace(job_.runs, job_.settings,
                Provenance{.command = context.command_line(),
                           .seed = job_.settings.seed,
                           .scene = "",
                           .inputs = {job_.settings.potential.file}},
                series_);
}

void MetalSampler::sample(std::span<md::MetalState const> states, std::string const& what) {
  std::vector<md::MetalState> missing;
  for (auto const& state : states)
    if (series_at(series_, state) == series_.end())
      missing.push_back(state);
  if (!missing.empty())
    run(missing, what);
  for (auto const& state : states) {
    auto const& series = *series_at(series_, state);
    points_.push_back(cg::analyse_metal(state, job_.settings, series.samples, *series.end));
  }
}

void MetalSampler::run(std::span<md::MetalState const> states, std::string const& what) {
  world_.root_gives(pack(states));
  auto const first_series = series_.size();
  std::vector<std::size_t> indices;
  for (auto const& state : states) {
    series_.push_back({.state = state, .samples = {}, .end = {}});
    indices.push_back(file_->add(state));
  }
  auto progress = context_.progress(fmt::format("MD of {} {}", states.size(), what), 1);
  bool const complete =
      md::sample_metal_grid(world_, states, job_.settings,
                            {.samples =
                                 [&](std::size_t k, std::span<md::MetalSample const> samples) {
                                   file_->append(indices[k], samples);
                                   auto& kept = series_[first_series + k].samples;
                                   kept.insert(kept.end(), samples.begin(), samples.end());
                                   return !interrupt_requested();
                                 },
                             .end =
                                 [&](std::size_t k, md::MetalEnd const& end) {
                                   file_->finish(indices[k], end);
                                   series_[first_series + k].end = end;
                                   return !interrupt_requested();
                                 },
                             .progress =
                                 [&](double fraction) {
                                   progress.update(fraction);
                                   return !interrupt_requested();
                                 }});
  if (!complete) {
    close();
    throw Interrupted(
        fmt::format("interrupted; what was sampled is in '{}': go on with --resume", job_.runs.string()));
  }
  progress.finish();
}

void MetalSampler::close() {
  world_.root_gives({});
  file_->close();
}

void MetalSampler::serve(md::MpiWorld const& world, MetalJob const& job) {
  for (;;) {
    auto const states = unpack(world.root_gives({}));
    if (states.empty() || !md::sample_metal_grid(world, states, job.settings, {}))
      return;
  }
}

MetalPoints read_metal_points(std::filesystem::path const& runs, md::MetalSettings const& settings) {
  MetalPoints result;
  for (auto const& series : read_metal_file(runs).series) {
    if (series.end)
      result.points.push_back(cg::analyse_metal(series.state, settings, series.samples, *series.end));
    else
      ++result.incomplete;
  }
  return result;
}

} // namespace mesobridge::workflows
