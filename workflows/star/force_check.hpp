#pragma once
#include "md/vec3.hpp"
#include "workflows/command.hpp"

namespace mesobridge::workflows {

/// Compares the net forces on molecules that a trajectory says with those by the laws of the mapping.
class ForceCheck {
 public:
  explicit ForceCheck(bool has_pairs) : has_pairs_(has_pairs) {}

  /// The force on one molecule.
  void add(Vec3 const& said, Vec3 const& by_laws);

  /// What is suspicious, for people; empty if nothing is.
  std::vector<std::string> warnings() const;
  /// `forces`: where they are from.
  void put(Json& json) const;

 private:
  double apart() const; ///< root mean square of the difference over that of what is said

  bool has_pairs_;
  double said_ = 0, difference_ = 0, count_ = 0;
};

} // namespace mesobridge::workflows
