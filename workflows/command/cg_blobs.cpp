#include "cg/blobs.hpp"
#include "md/error.hpp"
#include "workflows/command/options.hpp"
#include "workflows/interrupt.hpp"
#include "workflows/star/blob_file.hpp"
#include "workflows/summary.hpp"
#include "workflows/trajectory/energy_check.hpp"
#include "workflows/trajectory/force_check.hpp"
#include "workflows/trajectory/frame_blobs.hpp"
#include "workflows/trajectory/mapping_file.hpp"
#include "workflows/trajectory/trajectory_file.hpp"
#include <CLI/CLI.hpp>
#include <cmath>
#include <numeric>
#include <spdlog/logger.h>

namespace mesobridge::workflows {

namespace {

struct CgBlobsOptions {
  std::filesystem::path trajectory, mapping;
  std::optional<double> time_step;
  std::string group;
};

/// Along walls nothing is folded: the centre of mass lies where the atoms do.
void unfold(cg::Blob& blob, cg::MoleculeModel const& model, std::span<Vec3 const> q,
            std::array<bool, 3> const& periodic) {
  Vec3 moment;
  for (std::size_t i = 0; i < q.size(); ++i)
    moment += model.masses[i] * q[i];
  Vec3 const R = moment / model.mass();
  if (!periodic[0])
    blob.R.x = R.x;
  if (!periodic[1])
    blob.R.y = R.y;
  if (!periodic[2])
    blob.R.z = R.z;
}

/// Forces inside a molecule are none on the whole.
Vec3 sum_of(std::span<Vec3 const> forces) {
  return std::accumulate(forces.begin(), forces.end(), Vec3{});
}

void require_values(cg::BlobFrame const& frame) {
  for (std::size_t m = 0; m < frame.blobs.size(); ++m)
    if (auto const& blob = frame.blobs[m];
        !std::isfinite(blob.U_pot + blob.Phi + norm(blob.F) + blob.U_kin + norm2(blob.P)))
      throw InputError(
          fmt::format("molecule {} has an energy or a force without a value at step {}: are its atoms "
                      "on top of others, or the mapping another molecule's?",
                      m + 1, frame.step));
}

cg::BlobFrame blobs_of(FoundBlobs found, cg::MoleculeModel const& model, TrajectoryFrame const& frame,
                       Box const& box, ForceCheck& check) {
  cg::BlobFrame result{.step = frame.step, .box = box, .blobs = std::move(found.blobs)};
  auto const n = std::size_t(model.atoms());
  for (std::size_t m = 0; m < result.blobs.size(); ++m) {
    auto& blob = result.blobs[m];
    unfold(blob, model, std::span(frame.q).subspan(m * n, n), frame.periodic);
    if (!frame.f.empty()) {
      auto const of_atoms = std::span(frame.f).subspan(m * n, n);
      Vec3 const said = sum_of(of_atoms);
      check.add(said, blob.F, of_atoms);
      blob.F = said;
    }
  }
  require_values(result);
  cg::refuse_large_molecules(result);
  result.energy = found.kinetic + found.potential;
  result.box = frame.box;
  return result;
}

std::string walls_of(TrajectoryFrame const& frame) {
  std::string walls;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (!frame.periodic[axis])
      walls += "xyz"[axis];
  return walls;
}

/// Times as the file says them; otherwise from the time step of the command line; otherwise steps.
class Clock {
 public:
  explicit Clock(std::optional<double> time_step) : time_step_(time_step) {}

  double time(TrajectoryFrame const& frame) {
    if (time_step_ && frame.time)
      compare(frame);
    if (frame.time)
      return *frame.time;
    counts_steps_ = !time_step_;
    return double(frame.step) * time_step_.value_or(1);
  }
  bool counts_steps() const { return counts_steps_; }

 private:
  void compare(TrajectoryFrame const& frame) {
    if (!first_)
      first_ = {frame.step, *frame.time};
    constexpr double rounded = 1e-3;
    double const by_steps = double(frame.step - first_->first) * *time_step_,
                 by_file = *frame.time - first_->second;
    if (!(std::abs(by_steps - by_file) <= rounded * std::abs(by_file)))
      throw InputError(fmt::format(
          "--dt {}: by the trajectory itself {} time units pass from step {} to step {}, "
          "which are {} a step",
          *time_step_, by_file, first_->first, frame.step, by_file / double(frame.step - first_->first)));
  }

  std::optional<double> time_step_;
  std::optional<std::pair<std::int64_t, double>> first_;
  bool counts_steps_ = false;
};

/// Takes the frames one by one into the file, which is gone again if one of them is refused.
class Conversion {
 public:
  Conversion(CgBlobsOptions const& options, Context const& context)
      : options_(options), context_(context), mapping_(read_mapping(options.mapping)),
        path_(context.output_directory("out/blobs") / "blobs.h5"), clock_(options.time_step),
        blobs_(blobs_by(mapping_, path_.parent_path())), forces_(blobs_->has_pairs()) {
    std::error_code none;
    if (std::filesystem::equivalent(options.trajectory, path_, none))
      throw InputError(fmt::format("'{}' would be replaced by its own blobs: choose another folder with -o",
                                   path_.string()));
  }

  Result run() {
    try {
      read_trajectory(options_.trajectory, reading(), [&](TrajectoryFrame const& frame) { take(frame); });
    } catch (...) {
      if (file_)
        remove_unfinished();
      throw;
    }
    if (!file_)
      throw InputError(fmt::format("'{}' holds no frame", options_.trajectory.string()));
    file_->close();
    return result();
  }

 private:
  void warn(std::string const& warning) {
    context_.log->warn("{}", warning);
    warnings_.push_back(warning);
  }

  TrajectoryReading reading() {
    TrajectoryReading how{.units = mapping_.units,
                          .units_given = mapping_.units_given,
                          .group = options_.group,
                          .warn = [this](std::string const& warning) { warn(warning); }};
    blobs_->expect(how);
    return how;
  }

  void take(TrajectoryFrame const& frame) {
    throw_if_interrupted();
    auto const box = frame.image_box(blobs_->reach());
    auto const found = blobs_->of(frame, box);
    std::vector<cg::BlobFrame> one{blobs_of(found, blobs_->model(), frame, box, forces_)};
    one[0].time = clock_.time(frame);
    if (!file_)
      begin(frame, one[0].blobs.size());
    if (frame.f.empty() == has_forces_)
      throw InputError(fmt::format("'{}' has forces (fx fy fz) in some frames only: step {} {} them",
                                   options_.trajectory.string(), frame.step,
                                   has_forces_ ? "is without" : "has"));
    if (frame.box.tilted() && !may_tilt_)
      throw InputError(fmt::format("'{}': the box is tilted at step {}, but its first frames say no tilts",
                                   options_.trajectory.string(), frame.step));
    if (one[0].blobs.size() != molecules_ || walls_of(frame) != walls_)
      throw InputError(
          fmt::format("'{}' has {} molecules and walls along '{}' at step {}, {} and '{}' before",
                      options_.trajectory.string(), one[0].blobs.size(), walls_of(frame), frame.step,
                      molecules_, walls_));
    file_->append(one);
    energies_.add(frame.step, found, frame.potential_energy);
    ++frames_;
  }

  void begin(TrajectoryFrame const& frame, std::size_t molecules) {
    molecules_ = molecules, may_tilt_ = frame.may_tilt, walls_ = walls_of(frame),
    has_forces_ = !frame.f.empty();
    if (clock_.counts_steps())
      warn("the trajectory says no times and --dt is not given: times are numbers of steps");
    BlobFileHead const head{.kind = "melt",
                            .name = mapping_.name,
                            .fingerprint = "trajectory " + options_.trajectory.string(),
                            .molecules = int(molecules),
                            .atoms = mapping_.model.atoms(),
                            .mass = mapping_.model.mass(),
                            .rho = double(molecules) * mapping_.model.atoms() / frame.box.volume(),
                            .T = 0,
                            .units = mapping_.units.name,
                            .walls = walls_,
                            .may_tilt = frame.may_tilt,
                            .time_unit = clock_.counts_steps() ? "steps" : ""};
    file_.emplace(path_, head,
                  Provenance{.command = context_.command_line(), .seed = 0, .scene = "", .inputs = inputs()});
  }

  std::vector<InputFile> inputs() const {
    std::vector<InputFile> files{options_.trajectory, options_.mapping};
    if (mapping_.system)
      files.emplace_back(mapping_.system->data), files.emplace_back(mapping_.system->forces.file());
    return files;
  }

  void remove_unfinished() {
    file_.reset();
    Store::mend(path_);
    std::error_code none;
    std::filesystem::remove(path_, none);
  }

  Result result() {
    for (auto const& warnings : {energies_.warnings(), forces_.warnings()})
      for (auto const& warning : warnings)
        warn(warning);
    Result result;
    result.json = {
        {"file", path_.string()}, {"molecules", molecules_},
        {"frames", frames_},      {"units", mapping_.units.name},
        {"walls", walls_},        {"time_unit", clock_.counts_steps() ? "steps" : mapping_.units.name}};
    energies_.put(result.json);
    forces_.put(result.json);
    result.json["warnings"] = warnings_;
    write_summary(path_.parent_path() / "blobs.json", result.json);
    result.text = fmt::format("{} molecules in {} frames: {}", molecules_, frames_, path_.string());
    return result;
  }

  CgBlobsOptions const& options_;
  Context const& context_;
  Mapping mapping_;
  std::filesystem::path path_;
  Clock clock_;
  std::unique_ptr<FrameBlobs> blobs_;
  EnergyCheck energies_{mapping_.system ? EnergyCheck::Laws::of_lammps : EnergyCheck::Laws::of_mapping};
  ForceCheck forces_;
  std::optional<BlobFile> file_;
  std::size_t frames_ = 0, molecules_ = 0;
  bool has_forces_ = false, may_tilt_ = false;
  std::string walls_;
  std::vector<std::string> warnings_;
};

Result blobs(CgBlobsOptions const& options, Context const& context) {
  if (options.time_step)
    require(*options.time_step > 0 && std::isfinite(*options.time_step), "--dt", *options.time_step,
            "must be > 0");
  return Conversion(options, context).run();
}

void declare(CLI::App& app, CgBlobsOptions& options) {
  app.add_option("file", options.trajectory,
                 "LAMMPS text dump with velocities (forces fx fy fz are taken too; gzip, zstd, bzip2, xz), "
                 "or H5MD (.h5)")
      ->required()
      ->type_name("FILE");
  app.add_option("--mapping", options.mapping,
                 "Units, atoms, bonds and pair potential of a molecule, or the names of LAMMPS's files; a "
                 "bond's energy is "
                 "k (r - l)^2 / 2, or K (r - l)^2 with LAMMPS's K (`cg mapping` writes one; FENE bonds too)")
      ->required()
      ->type_name("FILE.toml");
  app.add_option("--dt", options.time_step,
                 "Time step of a dump without ITEM: TIME (not given: times are steps)");
  app.add_option("--group", options.group, "Group of particles in an H5MD file (needed if it has several)");
}

} // namespace

extern Declaration const cg_blobs_command = with_options<CgBlobsOptions, declare, blobs>;

} // namespace mesobridge::workflows
