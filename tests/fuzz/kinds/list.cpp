#include "fuzz/kinds/kinds.hpp"

namespace mesobridge::fuzz {

std::vector<Kind> const& kinds() {
  static std::vector<Kind> const all{h5md_kind(),   dump_kind(),     blobs_kind(), lj_grid_kind(),
                                     resume_kind(), journal_kind(),  csv_kind(),   scene_kind(),
                                     driven_kind(), reacting_kind(), model_kind(), command_line_kind()};
  return all;
}

} // namespace mesobridge::fuzz
