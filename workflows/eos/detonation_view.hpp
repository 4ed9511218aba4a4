#pragma once
#include "fitting/reactive_fluid.hpp"
#include "workflows/report/plot.hpp"
#include <filesystem>

namespace mesobridge::workflows {

/// An explosive for the plane of pressure and volume.
struct DetonationView {
  std::string reactant_name, product_name;
  fitting::Fluid reactant, product;
  fitting::EosState at_rest; ///< with the pressure of the reactant's model: its Hugoniot curve starts here
  fitting::Hugoniot
      crussard;         ///< of the products, from the state at rest with the pressure that is assumed there
  bool reduced = false; ///< in Lennard-Jones units
};

/// Of a fluid that reacts, from its state at rest.
DetonationView view_of(fitting::ReactiveFluid const& fluid, std::string reactant_name,
                       std::string product_name, bool reduced = false);

/// States of a simulation, one a slice, to be laid over the curves; the model's units.
struct SliceStates {
  std::string label;
  std::vector<double> rho, P;
  std::vector<double> P_error = {}; ///< empty, or one standard error a slice
};

/// Reads slices from a CSV file with columns of density and pressure in any unit (`rho_kg_m3`, `P_GPa`),
/// maybe with standard errors (`P_se_GPa`); other quantities may stand beside. Throws InputError.
SliceStates read_slices(std::filesystem::path const& file);

/// P over rho_0/rho, in which Rayleigh lines are straight: the Crussard curve and the reactant's Hugoniot
/// curve with the line of the Chapman-Jouguet detonation up to its von Neumann state (where the reactant's
/// model has one), that point, and the isentrope by which the products expand (thesis, figures 6.2 and 6.12),
/// down to the initial density or that of the thinnest slice. `curve`: states of the Crussard curve of rising
/// pressure.
Plot detonation_plot(DetonationView const& view, std::vector<fitting::Shock> const& curve,
                     std::vector<SliceStates> const& slices = {});
/// The same up to a pressure, with so many points a curve.
Plot detonation_plot(DetonationView const& view, double P_last, int points,
                     std::vector<SliceStates> const& slices = {});

} // namespace mesobridge::workflows
