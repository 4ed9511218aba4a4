#pragma once
#include "fitting/eos/list.hpp"
#include "md/number_range.hpp"
#include "sdpd/method/parts.hpp"
#include "sdpd/method/reaction.hpp"
#include "sdpd/method/species.hpp"
#include <optional>
#include <string>

namespace mesobridge::sdpd {

struct SimulationSettings;

/// Smoothed dissipative particle dynamics: particles of K atoms or molecules of a fluid that an equation of
/// state and viscosities describe. Quantities in the units of the equation of state.
struct Sdpd {
  static constexpr std::string_view name = "sdpd", title = "SDPD",
                                    help = "particles of fluid with an equation of state";
  static constexpr std::string_view
      name_without_noise = "sph",
      title_without_noise = "SPH",
      help_without_noise = "the same without noise: viscous smoothed particle hydrodynamics, which "
                           "starts at rest and whose densities are plain unless the scene says "
                           "otherwise";
  static constexpr Features features{.energies = true, .densities = true};
  static constexpr NumberRange sizes{.min = 1}, supports{.min = 1, .max = 10}; ///< of K and h_factor

  fitting::AnyEos eos;
  double K = 0; ///< size of a particle in atoms or molecules, with a heat capacity above k_B/2
  CentreOfMass centre_of_mass = CentreOfMass::free; ///< without noise it makes no difference: bulk
  std::string kernel = "wendland-c4";               ///< one of kernel_names(); see observe/pairing.hpp
  DensityCorrection density_correction = {};
  double h_factor = 2.5; ///< support h = h_factor (m/rho)^(1/3); 2.5 gives about 65 neighbours
  double eta = 0;        ///< shear viscosity, >= 0
  double zeta = 0;       ///< bulk viscosity, < 5 eta/3
  double kappa = 0;      ///< thermal conductivity, >= 0; 0: no heat conduction
  /// Several species, whose sizes and equations of state take the place of those above; they remain the
  /// units.
  std::vector<SdpdSpecies> species = {};
  DensitySum density_sum = DensitySum::mass; ///< of species of unlike masses
  std::optional<SdpdReaction> reaction = {}; ///< of particles of one species

  ReducedUnits units(SimulationSettings const& at) const;
  double unit_spacing(SimulationSettings const&) const { return 1; }
  double range(SimulationSettings const& at) const;
  double usual_skin(SimulationSettings const& at) const;
  bool conducts() const { return kappa > 0; }
  bool reacts() const { return reaction.has_value(); }
  void check(SimulationSettings const& at) const;
  MethodParts parts(SimulationSettings const& at) const;
};

} // namespace mesobridge::sdpd
