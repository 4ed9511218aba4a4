#include "md/star_checkpoint.hpp"
#include "md/error.hpp"
#include "md/star_system.hpp"
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <string_view>
#include <unistd.h>

namespace mesobridge::md {
namespace {

/// LAMMPS does not look at the last write of a file, so a full disk may cut a checkpoint short without a
/// word. Every restart file ends in this text.
void require_whole(std::filesystem::path const& file) {
  constexpr std::string_view end = "LammpS RestartT";
  std::ifstream in(file, std::ios::binary);
  in.seekg(-static_cast<std::streamoff>(end.size() + 1), std::ios::end); // a zero follows
  std::string found(end.size(), ' ');
  if (!in.read(found.data(), static_cast<std::streamsize>(found.size())) || found != end)
    throw EnvironmentError(
        fmt::format("the checkpoint '{}' could not be written whole: the disk is full, or a "
                    "limit of file sizes (ulimit -f) is reached; the last one is kept",
                    file.string()));
}

/// Waits until a file, or the names in a directory, are on the disk, where power loss leaves them.
void wait_for_disk(std::filesystem::path const& file) {
  int const descriptor = open(file.c_str(), O_RDONLY | O_CLOEXEC);
  bool const failed = descriptor < 0 || (fsync(descriptor) != 0 && errno != EINVAL);
  int const cause = errno;
  if (descriptor >= 0)
    close(descriptor);
  if (failed)
    throw EnvironmentError(fmt::format("cannot write '{}': {}", file.string(), std::strerror(cause)));
}

void replace(std::filesystem::path const& fresh, std::filesystem::path const& file) {
  wait_for_disk(fresh);
  std::error_code error;
  std::filesystem::rename(fresh, file, error);
  if (error)
    throw EnvironmentError(fmt::format("cannot write '{}': {}", file.string(), error.message()));
  wait_for_disk(file.has_parent_path() ? file.parent_path() : ".");
}

} // namespace

void write_checkpoint(MpiWorld const& world, LammpsSession& lammps, std::filesystem::path const& file,
                      std::function<void()> const& before_it_counts) {
  auto const fresh = file.string() + ".new";
  lammps.command_with_file("write_restart", fresh);
  if (world.is_root())
    require_whole(fresh);
  if (before_it_counts)
    before_it_counts();
  world.barrier();
  if (world.is_root())
    replace(fresh, file);
  world.barrier();
}

std::int64_t step_to_begin_at(MpiWorld const& world, Checkpoint const& checkpoint, bool resume) {
  auto const& file = checkpoint.restart_file;
  if (world.is_root() && !resume)
    std::filesystem::remove(file);
  if (!world.root_says(resume && std::filesystem::exists(file)))
    return 0;
  LammpsSession lammps(world, Ranks::all, checkpoint.log_file, Log::append);
  checkpoint.prepare(lammps);
  lammps.command_with_file("read_restart", file);
  return lammps.step();
}

std::string fingerprint(StarPolymer const& star) {
  return fmt::format("{} star (k = {}, l = {}, {}{})", star.name(), star.k, star.arm_length,
                     star.centre_length, star.repulsion ? ", WCA" : ", no repulsion");
}

} // namespace mesobridge::md
