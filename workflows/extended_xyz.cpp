#include "workflows/extended_xyz.hpp"
#include "md/error.hpp"
#include <charconv>
#include <fmt/format.h>
#include <fstream>
#include <iterator>

namespace mesobridge::workflows {
namespace {

constexpr std::string_view step_key = "step=";

std::string text_of(ParticleFrame const& frame) {
  std::string text;
  auto out = std::back_inserter(text);
  auto const& edge = frame.box.edge;
  std::string columns = "id:I:1:pos:R:3:velo:R:3";
  for (auto const& [name, values] : frame.scalars)
    columns += ":" + name + ":R:1";
  fmt::format_to(out, "{}\nLattice=\"{} 0 0 0 {} 0 0 0 {}\" Properties={} {}{} time={} pbc=\"T T T\"\n",
                 frame.positions.size(), edge.x, edge.y, edge.z, columns, step_key, frame.step, frame.time);
  for (std::size_t i = 0; i < frame.positions.size(); ++i) {
    auto const &q = frame.positions[i], &v = frame.velocities[i];
    fmt::format_to(out, "{} {} {} {} {} {} {}", i, q.x, q.y, q.z, v.x, v.y, v.z);
    for (auto const& [name, values] : frame.scalars)
      fmt::format_to(out, " {}", values[i]);
    text += '\n';
  }
  return text;
}

[[noreturn]] void fail(char const* what, std::filesystem::path const& file) {
  throw EnvironmentError(fmt::format("cannot {} '{}': {}", what, file.string(), std::strerror(errno)));
}

/// The step in a frame's second line.
std::int64_t step_in(std::string const& line, std::filesystem::path const& file) {
  auto const at = line.find(step_key);
  std::int64_t step = -1;
  if (at != line.npos)
    std::from_chars(line.data() + at + step_key.size(), line.data() + line.size(), step);
  if (step < 0)
    throw InputError(fmt::format("'{}' was not written by this program: a frame has no step", file.string()));
  return step;
}

struct WholeFrames {
  std::uintmax_t bytes = 0;
  std::int64_t last_step = -1;
};

/// How far the file's frames are complete.
WholeFrames whole_frames(std::filesystem::path const& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in)
    throw InputError(fmt::format("cannot read '{}': {}", file.string(), std::strerror(errno)));
  WholeFrames whole;
  std::string line;
  auto next_line = [&] { return std::getline(in, line) && !in.eof(); }; // its end must be there, too
  while (next_line()) {
    std::size_t const particles = std::strtoull(line.c_str(), nullptr, 10);
    if (!next_line())
      break;
    std::int64_t const step = step_in(line, file);
    std::size_t read = 0;
    while (read < particles && next_line())
      ++read;
    if (read < particles)
      break;
    whole = {static_cast<std::uintmax_t>(in.tellg()), step};
  }
  return whole;
}

} // namespace

ExtendedXyzWriter::ExtendedXyzWriter(std::filesystem::path file) : file_(std::move(file)) {
  if (!std::ofstream(file_, std::ios::trunc))
    fail("create", file_);
}

ExtendedXyzWriter ExtendedXyzWriter::continue_file(std::filesystem::path file) {
  auto const whole = whole_frames(file);
  std::error_code error;
  std::filesystem::resize_file(file, whole.bytes, error);
  if (error)
    throw EnvironmentError(fmt::format("cannot shorten '{}': {}", file.string(), error.message()));
  return ExtendedXyzWriter(std::move(file), whole.last_step);
}

void ExtendedXyzWriter::append(ParticleFrame const& frame) {
  frame.check();
  std::ofstream out(file_, std::ios::binary | std::ios::app);
  out << text_of(frame) << std::flush;
  if (!out)
    fail("write", file_);
  last_step_ = frame.step;
}

} // namespace mesobridge::workflows
