#include "workflows/trajectory/trajectory_file.hpp"
#include "md/error.hpp"
#include "workflows/trajectory/h5md_trajectory.hpp"
#include "workflows/trajectory/lammps_dump.hpp"
#include <algorithm>
#include <fstream>

namespace mesobridge::workflows {

namespace {

/// The first bytes of a file.
std::string beginning(std::filesystem::path const& file) {
  if (std::filesystem::is_directory(file))
    throw InputError(fmt::format("'{}' cannot be read: it is a folder", file.string()));
  std::ifstream in(file, std::ios::binary);
  if (!in)
    throw InputError(fmt::format("'{}' cannot be read", file.string()));
  std::string bytes(8, '\0');
  in.read(bytes.data(), std::streamsize(bytes.size()));
  bytes.resize(std::size_t(in.gcount()));
  return bytes;
}

/// Passes on the frames whose steps grow. A step that stands there again with the same atoms (the border of
/// two runs, of which the second went on from the first) is left out.
class InOrder {
 public:
  InOrder(std::filesystem::path file, TrajectoryReading const& how) : file_(std::move(file)), how_(how) {}

  bool takes(TrajectoryFrame const& frame) {
    if (last_ && frame.step <= last_->step) {
      if (frame.step < last_->step || !same(frame, *last_))
        throw InputError(
            fmt::format("'{}': step {} stands after step {}{}: steps must grow. Are these several "
                        "runs in one file? Take them one by one",
                        file_.string(), frame.step, last_->step,
                        frame.step == last_->step ? " with other positions" : ""));
      how_.warn(fmt::format("'{}': step {} stands there twice: taken once", file_.string(), frame.step));
      return false;
    }
    if (last_ && frame.ids != last_->ids)
      throw InputError(fmt::format("'{}': the ids of the atoms at step {} are not those at step {}",
                                   file_.string(), frame.step, last_->step));
    if (last_ && frame.time && last_->time && !(*frame.time > *last_->time))
      throw InputError(fmt::format("'{}': the time {} of step {} is not after {}, that of step {}",
                                   file_.string(), *frame.time, frame.step, *last_->time, last_->step));
    last_ = frame;
    return true;
  }

 private:
  static bool same(TrajectoryFrame const& a, TrajectoryFrame const& b) {
    constexpr double of_an_edge = 1e-4; // dumps are rounded
    double const close = of_an_edge * norm(a.box.edge);
    return a.q.size() == b.q.size() && std::equal(a.q.begin(), a.q.end(), b.q.begin(), [&](Vec3 p, Vec3 q) {
             return norm(a.box.minimum_image(p - q)) < close;
           });
  }

  std::filesystem::path file_;
  TrajectoryReading const& how_;
  std::optional<TrajectoryFrame> last_;
};

} // namespace

Box TrajectoryFrame::image_box(double reach) const {
  Box result = box;
  require(periodic[2] || (box.xz == 0 && box.yz == 0), "box",
          fmt::format("tilts xz = {} and yz = {}", box.xz, box.yz),
          "must be 0 where the box is not periodic along z");
  require(periodic[1] || box.xy == 0, "box", fmt::format("tilt xy = {}", box.xy),
          "must be 0 where the box is not periodic along y");
  require(periodic[0] || (box.xy == 0 && box.xz == 0), "box",
          fmt::format("tilts xy = {} and xz = {}", box.xy, box.xz),
          "must be 0 where the box is not periodic along x");
  auto const stretch = [&](double Vec3::*axis) {
    double low = 0, high = box.edge.*axis;
    for (auto const& r : q)
      low = std::min(low, r.*axis), high = std::max(high, r.*axis);
    result.edge.*axis = 2 * (high - low) + 4 * reach;
  };
  constexpr double Vec3::*axes[] = {&Vec3::x, &Vec3::y, &Vec3::z};
  for (std::size_t k = 0; k < 3; ++k)
    if (!periodic[k])
      stretch(axes[k]);
  return result;
}

void read_trajectory(std::filesystem::path const& file, TrajectoryReading const& how,
                     std::function<void(TrajectoryFrame const&)> const& consume) {
  auto const bytes = beginning(file);
  InOrder order(file, how);
  auto const in_order = [&](TrajectoryFrame const& frame) {
    if (order.takes(frame))
      consume(frame);
  };
  auto const extension = file.extension();
  if (bytes == "\x89HDF\r\n\x1a\n" || extension == ".h5" || extension == ".h5md" || extension == ".hdf5")
    return read_h5md_trajectory(file, how, in_order);
  if (!how.group.empty())
    throw InputError(
        fmt::format("--group {}: '{}' is no H5MD file, a dump has no groups", how.group, file.string()));
  read_lammps_dump(file, how, in_order);
}

} // namespace mesobridge::workflows
