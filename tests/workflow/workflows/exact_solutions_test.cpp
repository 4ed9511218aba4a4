#include "fitting/riemann.hpp"
#include "sdpd/kernel/list.hpp"
#include "sdpd/simulation.hpp"
#include "workflows/reproduce/exact_cases.hpp"
#include "workflows/reproduce/sound_wave.hpp"
#include "workflows/sdpd/riemann_problem.hpp"
#include "workflows/sdpd/settings.hpp"
#include <gtest/gtest.h>
#include <numbers>

namespace mesobridge::workflows {
namespace {

/// The velocity of a wave of length `n` on the cubic lattice, in that of the continuum, by the force between
/// planes: c^2/c_0^2 = (2 s_2 + (gamma - 2) s_1^2)/gamma with sums over the lattice of the kernel's slopes.
double on_lattice(sdpd::AnyKernel const& any, double n, double gamma) {
  double const k = 2 * std::numbers::pi / n, e = 1e-4;
  double s_1 = 0, s_2 = 0;
  auto const W = [&](int x, int y, double z) {
    double const r = std::sqrt(x * x + y * y + z * z);
    return std::visit([&](auto const& kernel) { return r < 4 ? kernel.W(r) : 0.0; }, any);
  };
  for (int x = -4; x <= 4; ++x)
    for (int y = -4; y <= 4; ++y)
      for (int z = -4; z <= 4; ++z)
        if (x != 0 || y != 0 || z != 0) {
          double const up = W(x, y, z + e), here = W(x, y, z), down = W(x, y, z - e);
          s_1 -= (up - down) / (2 * e) * std::sin(k * z) / k;
          s_2 += (up - 2 * here + down) / (e * e) * (1 - std::cos(k * z)) / (k * k);
        }
  return std::sqrt((2 * s_2 + (gamma - 2) * s_1 * s_1) / gamma);
}

// Velocity and damping of sound are those of the equation of state and of the viscosity, but for what the
// lattice and a short wave take away, which a sum over the lattice tells.
TEST(ExactSolutions, SoundHasItsVelocityAndDamping) {
  constexpr std::int64_t n = 32;
  auto const of = measure_sound(sound_scene("air", 1, 300, n), n, 2, [](double) { return true; });
  auto const kernel = sdpd::make_kernel("wendland-c4", 4);
  EXPECT_NEAR(of.c / of.c_exact, on_lattice(kernel, n, 1.4), 5e-4);
  EXPECT_LT(std::abs(of.c_error()), 0.006);
  EXPECT_LT(std::abs(of.damping_error()), 0.03);
  EXPECT_NEAR(on_lattice(kernel, 1e4, 1.4), 1, 1e-3);
}

// Known of Sod's tube with the exponent 1.4: P* = 0.30313, u* = 0.92745 in the units of the left half.
TEST(ExactSolutions, TheTubesArePosedAsPublished) {
  auto const& sod = tube_cases().front();
  auto const scene = tube_scene(sod, 40);
  auto const problem = riemann_problem(scene, settings_of(scene, 1));
  ASSERT_TRUE(problem);
  double const P = problem->at(0, 0).state.P, u = std::sqrt(P / sod.left.rho);
  EXPECT_NEAR(problem->exact.P() / P, 0.30313, 1e-5);
  EXPECT_NEAR(problem->exact.u() / u, 0.92745, 1e-5);
  EXPECT_NEAR(problem->exact.right_wave().head / u, 1.752156, 1e-5);
  EXPECT_NEAR(problem->exact.left_wave().head / u, -1.183216, 1e-5);
  for (auto const& tube : tube_cases()) { // each is one that the engine takes
    auto const of = tube_scene(tube, 24);
    EXPECT_TRUE(riemann_problem(of, settings_of(of, 1))) << tube.name;
  }
}

// Ends disturb the flow from where they are inwards, walls at rest not at all.
TEST(ExactSolutions, KnowWhatTheEndsHaveNotReached) {
  auto const of = [](std::size_t k) {
    auto const scene = tube_scene(tube_cases()[k], 40);
    return riemann_problem(scene, settings_of(scene, 1)).value();
  };
  auto const sod = of(0), noh = of(3);
  EXPECT_EQ(sod.undisturbed(1e-7), std::pair(0.0, sod.length));
  auto const [from, to] = noh.undisturbed(1e-7);
  EXPECT_GT(from, noh.at(0, 0).u * 1e-7);
  EXPECT_NEAR(from + to, noh.length, 1e-9 * noh.length);
}

// As GANDALF does: a mean over particles, in units of its own, of those as near as 1 at a time of 0.75.
TEST(ExactSolutions, TakeAnErrorAsAnotherProgramDoes) {
  StatedError const stated{.program = "other", .where = "its test", .reach = 2, .unit = 10, .below = 1};
  RiemannComparison found{.time = 3}; // what is nearer than 6 counts
  found.place = {1, 5, 9, 13}, found.rho = {9, 1, 3, 5}, found.u = {70, 20, 10, 0};
  found.exact.resize(4);
  for (std::size_t k = 0; k < 4; ++k)
    found.exact[k].u = 14;
  EXPECT_NEAR(error_as_stated(stated, found, 8), (1 * 6 + 3 * 4 + 5 * 14) / 9.0 / 10, 1e-12);
  // The tube of its test: P* = 0.44297, u* = 0.64966 by bisection in another language.
  auto const& mild = tube_cases().back();
  auto const scene = tube_scene(mild, 40);
  auto const problem = riemann_problem(scene, settings_of(scene, 1)).value();
  double const P = problem.at(0, 0).state.P, u = std::sqrt(P / mild.left.rho);
  EXPECT_NEAR(problem.exact.P() / P, 0.44297, 1e-4);
  EXPECT_NEAR(problem.exact.u() / u, 0.64966, 1e-4);
  EXPECT_NEAR(mild.stated->unit / u, 1, 1e-6);
}

} // namespace
} // namespace mesobridge::workflows
