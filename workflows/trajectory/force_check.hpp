#pragma once
#include "md/vec3.hpp"
#include "workflows/command.hpp"
#include <span>

namespace mesobridge::workflows {

/// Compares the net forces on molecules that a trajectory says with those by the laws of the mapping.
class ForceCheck {
 public:
  explicit ForceCheck(bool has_pairs) : has_pairs_(has_pairs) {}

  /// The force on one molecule, and those on its atoms, of whose digits the former is made.
  void add(Vec3 const& said, Vec3 const& by_laws, std::span<Vec3 const> of_atoms);

  /// What is suspicious, for people; empty if nothing is.
  std::vector<std::string> warnings() const;
  /// `forces`: where they are from.
  void put(Json& json) const;

 private:
  bool differ() const;
  double apart() const; ///< root mean square of the difference over that of what is said

  bool has_pairs_;
  double said_ = 0, difference_ = 0, of_atoms_ = 0, count_ = 0; ///< sums of squares
};

} // namespace mesobridge::workflows
