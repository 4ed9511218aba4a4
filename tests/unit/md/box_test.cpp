#include "md/box.hpp"
#include <gtest/gtest.h>
#include <random>

// Tilted boxes against what defines their lattice: every image within reach is looked at.

namespace mesobridge {
namespace {

class Boxes : public ::testing::Test {
 protected:
  double uniform(double low, double high) { return std::uniform_real_distribution(low, high)(engine_); }
  Vec3 vector(double most) { return {uniform(-most, most), uniform(-most, most), uniform(-most, most)}; }
  Box any() {
    Box box{{uniform(4, 9), uniform(4, 9), uniform(4, 9)}};
    box.xy = uniform(-1, 1) * box.edge.x, box.xz = uniform(-1, 1) * box.edge.x,
    box.yz = uniform(-1, 1) * box.edge.y;
    return box;
  }
  static Vec3 lattice(Box const& box, int a, int b, int c) {
    return double(a) * Vec3{box.edge.x, 0, 0} + double(b) * Vec3{box.xy, box.edge.y, 0} +
           double(c) * Vec3{box.xz, box.yz, box.edge.z};
  }

 private:
  std::mt19937_64 engine_{5};
};

TEST_F(Boxes, FindTheNearestImageWithinHalfOfTheNarrowestWidth) {
  int found = 0;
  for (int k = 0; k < 2000; ++k) {
    auto const box = any();
    Vec3 const r = box.position(vector(1));
    double nearest = 1e300;
    for (int a = -4; a <= 4; ++a)
      for (int b = -4; b <= 4; ++b)
        for (int c = -2; c <= 2; ++c)
          nearest = std::min(nearest, norm(r + lattice(box, a, b, c)));
    if (nearest < box.narrowest() / 2) {
      EXPECT_NEAR(norm(box.minimum_image(r)), nearest, 1e-12);
      ++found;
    }
  }
  EXPECT_GT(found, 200);
}

TEST_F(Boxes, WrapByWholeEdges) {
  for (int k = 0; k < 2000; ++k) {
    auto const box = any();
    Vec3 const q = 5 * box.position(vector(1)), inside = box.wrap(q), part = box.parts(inside);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_GE(component(part, axis), -1e-12);
      EXPECT_LT(component(part, axis), 1 + 1e-12);
      double const turns = component(box.parts(q - inside), axis);
      EXPECT_NEAR(turns, std::round(turns), 1e-12);
    }
  }
  EXPECT_EQ((Box{{4, 5, 6}}.wrap({0, 0, -1e-18})), Vec3{});
}

TEST_F(Boxes, AreAsWideAsTheirVolumeOverTheirFaces) {
  auto const cross = [](Vec3 const& a, Vec3 const& b) {
    return norm(Vec3{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x});
  };
  for (int k = 0; k < 100; ++k) {
    auto const box = any();
    Vec3 const a = lattice(box, 1, 0, 0), b = lattice(box, 0, 1, 0), c = lattice(box, 0, 0, 1),
               w = box.widths();
    EXPECT_NEAR(w.x, box.volume() / cross(b, c), 1e-12);
    EXPECT_NEAR(w.y, box.volume() / cross(c, a), 1e-12);
    EXPECT_NEAR(w.z, box.volume() / cross(a, b), 1e-12);
    EXPECT_LT(norm(box.across(a) - Vec3{w.x, 0, 0}), 1e-12);
    Vec3 const r = vector(3);
    EXPECT_LT(norm(box.position(box.parts(r)) - r), 1e-12);
  }
}

} // namespace
} // namespace mesobridge
