#pragma once
#include "workflows/trajectory/dump_lines.hpp"
#include "workflows/trajectory/edge_vectors.hpp"

namespace mesobridge::workflows {

/// The box of one frame of a dump.
struct DumpBox {
  TurnedBox turned;
  Vec3 low; ///< the corner where its edges begin
  std::array<bool, 3> periodic{true, true, true};
  bool lettered = false; ///< the file says what is periodic
  bool may_tilt = false; ///< the file says tilts or edge vectors, whatever they are
  std::int64_t line = 0; ///< of ITEM: BOX BOUNDS
};

/// Reads the three lines below ITEM: BOX BOUNDS, which goes on with `text`: bounds of a rectangular box,
/// those of a tilted one with its tilts ("xy xz yz"; the bounds are those of the whole tilted box, as LAMMPS
/// writes them), or three edge vectors and a corner ("abc origin"). Throws InputError with file and line.
DumpBox read_dump_box(std::string_view text, DumpLines& lines);

} // namespace mesobridge::workflows
