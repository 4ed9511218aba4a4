#include "md/star_polymer.hpp"
#include <charconv>
#include <cmath>
#include <numbers>

namespace mesobridge::md {
namespace {

constexpr double start_arm_length = 1.147, start_centre_length = 1.615;

/// Directions spread over the sphere along a golden spiral: 12 of them are at least 0.95 rad apart, so the
/// first beads of two arms are at least 1.5 sigma apart.
Vec3 direction(int k, int count) {
  double const z = 1 - (2 * k + 1.0) / count;
  double const angle = std::numbers::pi * (3 - std::sqrt(5.0)) * k;
  double const r = std::sqrt(1 - z * z);
  return {r * std::cos(angle), r * std::sin(angle), z};
}

/// A whole number at the head of a text; -1 when there is none. Takes it off the text.
int leading_number(std::string_view& text) {
  int number = -1;
  auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{})
    return -1;
  text.remove_prefix(std::size_t(end - text.data()));
  return number;
}

} // namespace

std::vector<HarmonicBond> StarPolymer::bonds() const {
  std::vector<HarmonicBond> result;
  for (int arm = 0; arm < arms; ++arm)
    for (int bead = 0; bead < beads; ++bead) {
      int const atom = 1 + arm * beads + bead;
      bool const at_centre = bead == 0;
      result.push_back({at_centre ? 0 : atom - 1, atom, k, at_centre ? centre_length : arm_length});
    }
  return result;
}

double wca_cutoff() {
  return std::pow(2.0, 1.0 / 6);
}

StarPolymer star_of_name(std::string const& name) {
  std::string_view rest = name;
  StarPolymer star;
  star.arms = leading_number(rest);
  bool const dash = !rest.empty() && rest.front() == '-';
  if (dash)
    rest.remove_prefix(1);
  star.beads = leading_number(rest);
  require(dash && rest.empty(), "star", name, "must be ARMS-BEADS, for example 6-3");
  check(star);
  return star;
}

void check(StarPolymer const& star) {
  require(star.arms >= 1 && star.arms <= 12, "arms of a star", star.arms, "must be 1 ... 12");
  require(star.beads >= 1 && star.beads <= 24, "beads of an arm", star.beads, "must be 1 ... 24");
  require(star.k > 0 && std::isfinite(star.k), "bond stiffness", star.k, "must be > 0");
  require(star.arm_length >= 0 && star.arm_length < 3, "rest length inside the arms", star.arm_length,
          "must be 0 ... 3 sigma");
  require(star.centre_length >= 0 && star.centre_length < 3, "rest length at the centre", star.centre_length,
          "must be 0 ... 3 sigma");
}

double straight_radius(StarPolymer const& star) {
  return start_centre_length + (star.beads - 1) * start_arm_length;
}

std::vector<Vec3> straight_star(StarPolymer const& star) {
  std::vector<Vec3> atoms(std::size_t(star.atoms()));
  for (int arm = 0; arm < star.arms; ++arm)
    for (int bead = 0; bead < star.beads; ++bead)
      atoms[std::size_t(1 + arm * star.beads + bead)] =
          (start_centre_length + bead * start_arm_length) * direction(arm, star.arms);
  return atoms;
}

std::vector<Vec3> turned(std::vector<Vec3> atoms, double u, double v, double w) {
  // A uniform unit quaternion from three uniform numbers (Shoemake, Graphics Gems III, 124 (1992)).
  constexpr double two_pi = 2 * std::numbers::pi;
  Vec3 const axis{std::sqrt(1 - u) * std::sin(two_pi * v), std::sqrt(1 - u) * std::cos(two_pi * v),
                  std::sqrt(u) * std::sin(two_pi * w)};
  double const real = std::sqrt(u) * std::cos(two_pi * w);
  auto const cross = [](Vec3 const& a, Vec3 const& b) {
    return Vec3{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  };
  for (Vec3& q : atoms) {
    Vec3 const turn = 2 * cross(axis, q);
    q += real * turn + cross(axis, turn);
  }
  return atoms;
}

} // namespace mesobridge::md
