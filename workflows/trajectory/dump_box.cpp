#include "workflows/trajectory/dump_box.hpp"
#include <algorithm>
#include <span>

namespace mesobridge::workflows {

namespace {

std::vector<double> numbers_of(DumpLines& lines) {
  std::vector<double> numbers;
  for (auto const word : words_of(lines.next()))
    numbers.push_back(lines.as<double>(word, "a number of the box"));
  return numbers;
}

/// Bounds and, in boxes that may tilt, xy, xz and yz. The bounds hold the whole box, whose upper edges reach
/// beyond the lower ones by the tilts.
void take_bounds(DumpLines& lines, DumpBox& into) {
  std::size_t const words = into.may_tilt ? 3 : 2;
  std::array<double, 3> low{}, edge{}, tilt{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    auto const row = numbers_of(lines);
    if (row.size() != words)
      lines.refuse(into.may_tilt
                       ? "must be the two bounds of the box and a tilt, as ITEM: BOX BOUNDS xy xz yz says"
                       : "must be the two bounds of the box (tilts stand below ITEM: BOX BOUNDS xy xz yz)");
    low[axis] = row[0], edge[axis] = row[1] - row[0], tilt[axis] = into.may_tilt ? row[2] : 0;
    if (!(edge[axis] > 0) || !std::isfinite(edge[axis]))
      lines.refuse("the upper bound of the box must be greater than the lower one");
  }
  auto const [xy, xz, yz] = tilt;
  auto const along_x = std::minmax({0.0, xy, xz, xy + xz}), along_y = std::minmax({0.0, yz});
  into.low = {low[0] - along_x.first, low[1] - along_y.first, low[2]};
  Vec3 const upright{edge[0] - (along_x.second - along_x.first), edge[1] - (along_y.second - along_y.first),
                     edge[2]};
  if (!(std::min(upright.x, upright.y) > 0))
    lines.refuse("the tilts leave nothing of the box between its bounds");
  into.turned.box = {.edge = upright, .xy = xy, .xz = xz, .yz = yz};
}

void take_vectors(DumpLines& lines, DumpBox& into) {
  std::array<Vec3, 3> edges;
  std::array<double, 3> origin{};
  for (std::size_t k = 0; k < 3; ++k) {
    auto const row = numbers_of(lines);
    if (row.size() != 4)
      lines.refuse("must be an edge vector of the box and a component of its origin");
    edges[k] = {row[0], row[1], row[2]}, origin[k] = row[3];
  }
  auto const found = box_of_edges(edges[0], edges[1], edges[2]);
  if (!found)
    lines.refuse("the three edge vectors make no box: they must be right-handed and not lie in one plane");
  into.turned = *found;
  into.low = {origin[0], origin[1], origin[2]};
}

} // namespace

DumpBox read_dump_box(std::string_view text, DumpLines& lines) {
  DumpBox box{.turned = {}, .low = {}, .line = lines.number()};
  auto const words = words_of(text);
  auto const letters = std::span(words).last(std::min<std::size_t>(words.size(), 3));
  box.lettered = letters.size() == 3 && std::ranges::all_of(letters, [](std::string_view word) {
                   return word.size() == 2 && word.find_first_not_of("pfsm") == word.npos;
                 });
  for (std::size_t axis = 0; axis < 3; ++axis)
    box.periodic[axis] = !box.lettered || letters[axis] == "pp";
  bool const vectors = std::ranges::find(words, "abc") != words.end();
  box.may_tilt = vectors || std::ranges::find(words, "xy") != words.end();
  (vectors ? take_vectors : take_bounds)(lines, box);
  return box;
}

} // namespace mesobridge::workflows
