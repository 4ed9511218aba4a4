#include "workflows/extended_xyz.hpp"
#include "md/error.hpp"
#include "workflows/store/seal.hpp"
#include <charconv>
#include <fcntl.h>
#include <fmt/format.h>
#include <fstream>
#include <iterator>

namespace mesobridge::workflows {
namespace {

constexpr std::string_view step_key = "step=";

/// ASE wants a column of species, in which X stands for what is no element.
std::string columns_of(ParticleFrame const& frame) {
  std::string columns = "species:S:1:id:I:1:pos:R:3:velo:R:3";
  for (auto const& [name, values] : frame.scalars)
    columns += ":" + name + ":R:1";
  return columns;
}

std::string text_of(ParticleFrame const& frame) {
  std::string text;
  auto out = std::back_inserter(text);
  auto const& edge = frame.box.edge;
  auto const letter = [&](std::size_t axis) { return frame.box.periodic[axis] ? 'T' : 'F'; };
  double const A = frame.to_angstrom;
  fmt::format_to(out,
                 "{}\nLattice=\"{} 0 0 0 {} 0 0 0 {}\" Properties={} {}{} time={} pbc=\"{:c} {:c} {:c}\"\n",
                 frame.positions.size(), A * edge.x, A * edge.y, A * edge.z, columns_of(frame), step_key,
                 frame.step, frame.time, letter(0), letter(1), letter(2));
  for (std::size_t i = 0; i < frame.positions.size(); ++i) {
    auto const &q = frame.positions[i], &v = frame.velocities[i];
    fmt::format_to(out, "X {} {} {} {} {} {} {}", i, A * q.x, A * q.y, A * q.z, A * v.x, A * v.y, A * v.z);
    for (auto const& [name, values] : frame.scalars)
      fmt::format_to(out, " {}", values[i]);
    text += '\n';
  }
  return text;
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
  std::string head; ///< second line of the last one
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
    auto head = line;
    std::size_t read = 0;
    while (read < particles && next_line())
      ++read;
    if (read < particles)
      break;
    whole = {static_cast<std::uintmax_t>(in.tellg()), step, std::move(head)};
  }
  return whole;
}

/// Empties the file, or makes it.
std::filesystem::path emptied(std::filesystem::path file) {
  UndoJournal::discard(file); // of a file of that name that is no more
  remove_seal_beside(file);
  Descriptor const made(file, O_WRONLY | O_CREAT | O_TRUNC);
  return file;
}

} // namespace

ExtendedXyzWriter::ExtendedXyzWriter(std::filesystem::path file)
    : ExtendedXyzWriter(emptied(std::move(file)), -1) {}

ExtendedXyzWriter ExtendedXyzWriter::continue_file(std::filesystem::path file) {
  if (UndoJournal::exists(file))
    UndoJournal::roll_back(file);
  else
    check_seal_beside(file);
  auto const whole = whole_frames(file);
  cut(Descriptor(file, O_WRONLY), whole.bytes, file);
  ExtendedXyzWriter writer(file, whole.last_step);
  writer.head_there_ = whole.head;
  remove_seal_beside(file); // from here on the journal knows what the file is
  return writer;
}

void ExtendedXyzWriter::append(ParticleFrame const& frame) {
  frame.check();
  if (!head_there_.empty() && head_there_.find("=" + columns_of(frame) + " ") == std::string::npos)
    throw InputError(
        fmt::format("'{}' holds frames with other columns than {}, perhaps of an earlier version, "
                    "whose lengths are in nm: go on without such frames by run.xyz_every=0",
                    file_.string(), columns_of(frame)));
  head_there_.clear();
  write_all(Descriptor(file_, O_WRONLY | O_APPEND), text_of(frame), file_);
  last_step_ = frame.step;
}

void ExtendedXyzWriter::mark() {
  journal_->renew();
}

void ExtendedXyzWriter::close() {
  journal_->renew(); // so that nobody who dies from here on leads the sealed file back
  seal_beside(file_);
  journal_.reset();
  UndoJournal::discard(file_);
}

} // namespace mesobridge::workflows
