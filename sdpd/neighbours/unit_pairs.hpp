#pragma once
#include <array>

namespace mesobridge::sdpd {

/// Pairs of cells of a block of 2 x 2 x 2, their places as bits x, y, z: each two touching cells of a grid,
/// and each cell with itself, are one such pair once as the block moves over the grid.
inline constexpr std::array<std::array<unsigned, 2>, 14> unit_pairs{{{0, 0},
                                                                     {0, 1},
                                                                     {0, 2},
                                                                     {0, 3},
                                                                     {0, 4},
                                                                     {0, 5},
                                                                     {0, 6},
                                                                     {0, 7},
                                                                     {1, 2},
                                                                     {1, 4},
                                                                     {2, 4},
                                                                     {1, 6},
                                                                     {2, 5},
                                                                     {3, 4}}};

} // namespace mesobridge::sdpd
