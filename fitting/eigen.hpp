#pragma once

// GCC 12 takes the undefined operands inside its own AVX-512 intrinsics, which Eigen calls, for mistakes (GCC
// bug 105593). The warning is off for those headers only.
#pragma GCC diagnostic push
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wuninitialized"
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <Eigen/Dense>
#pragma GCC diagnostic pop
