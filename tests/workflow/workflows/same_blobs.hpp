#pragma once
#include "workflows/star/blob_file.hpp"
#include <gtest/gtest.h>

namespace mesobridge::tests {

/// Two files of blobs hold the same within round-off that chaos has had no time to enlarge.
inline void expect_same_blobs(workflows::BlobData const& one, workflows::BlobData const& two,
                              std::size_t count, double energy_error) {
  ASSERT_EQ(one.R.size(), count);
  ASSERT_EQ(two.R.size(), count);
  EXPECT_EQ(one.steps, two.steps);
  for (std::size_t k = 0; k < count; ++k) {
    EXPECT_LT(norm(one.boxes[0].minimum_image(one.R[k] - two.R[k])), 1e-9);
    EXPECT_NEAR(one.U(k), two.U(k), energy_error);
    EXPECT_NEAR(one.Phi[k], two.Phi[k], energy_error);
  }
}

} // namespace mesobridge::tests
