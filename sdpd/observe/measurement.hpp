#pragma once
#include "md/dimension.hpp"
#include "sdpd/observe/observation.hpp"
#include <optional>
#include <span>
#include <string_view>
#include <variant>

namespace mesobridge::sdpd {

/// What the components of a measurement are called: the ends of their names.
using Components = std::span<std::string_view const>;
inline constexpr std::array<std::string_view, 1> one_number{""};
inline constexpr std::array<std::string_view, 3> vector_components{"_x", "_y", "_z"};
inline constexpr std::array<std::string_view, 6> symmetric_tensor_components{"_xx", "_yy", "_zz",
                                                                             "_xy", "_xz", "_yz"};

/// The set state of a fluid, reduced: what a measurement at equilibrium may be compared with.
struct SetState {
  std::optional<double> P; ///< by the equation of state
};

inline bool in_every_method(Features const&) {
  return true;
}
inline bool with_energies(Features const& has) {
  return has.energies;
}
inline bool with_densities(Features const& has) {
  return has.densities;
}
/// What sums over pairs of particles alone, not over the images behind walls.
inline bool without_walls(Features const& has) {
  return !has.walls;
}
inline bool with_walls(Features const& has) {
  return has.walls;
}
inline bool with_reaction(Features const& has) {
  return has.reacts;
}
inline bool without_densities(Features const& has) {
  return !has.densities;
}

/// Something that is measured of the whole fluid, declared once: the keys of scenes with their help, run.h5,
/// the log, summary and report of a run, and the estimate of its disk go through measurements() (list.hpp).
struct Measurement {
  /// Of the sums that each sample finds anyway: measured in every run, a column of `thermodynamics`.
  using FromSums = std::vector<double> (*)(Observation const&);
  /// Measured only where a scene asks for it, under `series`.
  using FromSystem = std::vector<double> (*)(System const&);

  std::string_view name;    ///< in scenes and, with a component's end and the unit's key, in files
  std::string_view meaning; ///< for the help of scenes: a few words
  Components components = one_number;
  Dimension dimension = Dimension::number;
  bool (*exists)(Features const&) = in_every_method;
  std::variant<FromSums, FromSystem> values; ///< one for each component, reduced
  int pair_passes = 0;                       ///< how often it looks at all pairs
  bool by_name_only = false;                 ///< its cost grows faster than the fluid: not among "all"
  bool fills_box = false;                    ///< takes the mean distance from the box: not with open faces
  bool logged = false;                       ///< has a column in log.txt
  /// What equilibrium makes of each component, reduced; nothing where theory does not say.
  std::vector<std::optional<double>> (*expected)(SetState const&) = nullptr;

  bool in_every_run() const { return std::holds_alternative<FromSums>(values); }
};

} // namespace mesobridge::sdpd
