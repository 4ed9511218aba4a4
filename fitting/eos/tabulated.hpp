#pragma once
#include "fitting/eos/array.hpp"
#include "fitting/eos/from_isochore.hpp"
#include "fitting/eos/monotone_root.hpp"
#include "fitting/eos/quintic_spline.hpp"
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace mesobridge::fitting {

/// The states that a table covers, in the units of its model.
struct TableRegion {
  double rho_min, rho_max, T_min, T_max;
};

/// The largest errors of a table over random states of its region: of T and c_v relative, of P in units of
/// |P| + rho k_B T/m0.
struct TableAccuracy {
  double T, P, C;
  int states;
};

/// What a table takes from the model that it replaces.
struct TableSource {
  std::function<double(double T, double rho)> energy, pressure, heat_capacity;
  std::function<double(double e, double rho)> entropy;
  double m0, boltzmann;
};

/// Entropy and its derivatives at one state; rho in the index: with respect to density.
struct EntropyJet {
  double s, e, ee, eee, rho, e_rho, rho_rho;
};

/// One potential, s(e, rho), as a tensor product of quintic B-splines:
///   s = -(k_B/m0) ln rho + S(rho, y),   y = ln[(e - e_0(rho))/e_1],
/// where e_0 is a spline of the energy at T_min less e_1 = 3/2 (k_B/m0) T_min. T = 1/s_e, P = -T rho^2 s_rho
/// and c_v = -s_e^2/s_ee are derivatives of that one spline, which has four continuous ones: they satisfy
/// every identity to round-off whatever the error of the table, and the energy of a run is conserved.
struct EntropyTable {
  quintic::Axis density, y;
  double e_1, R, m0, boltzmann, T_min, T_max;
  std::vector<double> e_0; ///< coefficients over the density, padded
  std::vector<double> S;   ///< [density][y], rows of `stride`, padded
  std::size_t stride;
  TableAccuracy accuracy;

  /// Throws PhysicsError outside the table.
  EntropyJet at(double e, double rho) const;

  /// s for any number type, whose real part is in the table.
  template <class X>
  X entropy(X e, X rho) const {
    using std::log;
    auto const i = density.place(real_part(rho));
    auto const w = quintic::weights_of((rho - density.low) / density.width() - double(i.cell));
    X base = 0.0;
    for (int k = 0; k < quintic::order; ++k)
      base += w[k] * e_0[i.cell + k];
    X const at = log((e - base) / e_1);
    auto const j = y.place(real_part(at));
    auto const v = quintic::weights_of((at - y.low) / y.width() - double(j.cell));
    X sum = -R * log(rho);
    for (int k = 0; k < quintic::order; ++k)
      for (int l = 0; l < quintic::order; ++l)
        sum += w[k] * v[l] * S[(i.cell + k) * stride + j.cell + l];
    return sum;
  }
};

/// A table at one density.
class TabulatedIsochore {
 public:
  /// Throws PhysicsError outside the densities of the table.
  TabulatedIsochore(EntropyTable const& table, double rho);

  double density() const { return rho_; }
  double energy(double T) const;
  double entropy(double T) const { return jet(T).s; }
  double pressure(double T) const;
  double heat_capacity(double T) const;
  double heat_capacity_slope(double T) const;
  double pressure_slope(double T) const;
  double pressure_density_slope(double T) const;
  double temperature_from_energy(double e, double /*T_guess*/) const { return 1 / table_->at(e, rho_).e; }
  double temperature_from_entropy(double s, double T_guess) const;

 private:
  EntropyJet jet(double T) const { return table_->at(energy(T), rho_); }
  [[noreturn]] void refuse(std::string_view quantity, double value) const;

  EntropyTable const* table_; // its owner outlives the isochore
  double rho_, e_0_, z_min_, z_max_;
};

/// A table in place of a slower model, over a region of states; states outside are refused.
class Tabulated : public FromIsochore<Tabulated> {
 public:
  using Isochore = TabulatedIsochore;
  static constexpr std::string_view name = "table";

  /// Refines until the errors of T and P over the region are below `relative_error` (1e-12 to 1e-2). Throws
  /// InputError for a bad region or error, PhysicsError when the model refuses a state that the table needs
  /// (it reaches somewhat beyond T_max at some densities) or when the model is not smooth enough.
  Tabulated(TableSource const& source, TableRegion const& region, double relative_error);

  template <EquationOfState E>
  static Tabulated of(E const& eos, TableRegion const& region, double relative_error) {
    return Tabulated(source_of(eos), region, relative_error);
  }

  // Straight from the spline, without the temperature in between.
  double entropy(double e, double rho) const { return table_->at(e, rho).s; }
  double pressure(double e, double rho) const {
    auto const s = table_->at(e, rho);
    return -rho * rho * s.rho / s.e;
  }
  double heat_capacity(double e, double rho) const {
    auto const s = table_->at(e, rho);
    return -s.e * s.e / s.ee;
  }
  TabulatedIsochore isochore(double rho) const { return {*table_, rho}; }
  double temperature_guess() const { return table_->T_min; }
  void require_temperature(double T, double rho) const;
  /// s(e, rho) with complex arguments, whose imaginary parts then carry derivatives.
  template <class X>
  X entropy_of(X e, X rho) const {
    return table_->entropy(e, rho);
  }

  TableAccuracy const& accuracy() const { return table_->accuracy; }
  EntropyTable const& table() const { return *table_; }
  Domain domain() const;
  double molecular_mass() const { return table_->m0; }
  double boltzmann() const { return table_->boltzmann; }

 private:
  template <EquationOfState E>
  static TableSource source_of(E const& eos) {
    return {.energy = [&eos](double T, double rho) { return eos.energy_from_temperature(T, rho); },
            .pressure = [&eos](double T, double rho) { return eos.isochore(rho).pressure(T); },
            .heat_capacity = [&eos](double T, double rho) { return eos.isochore(rho).heat_capacity(T); },
            .entropy = [&eos](double e, double rho) { return eos.entropy(e, rho); },
            .m0 = eos.molecular_mass(),
            .boltzmann = eos.boltzmann()};
  }

  std::shared_ptr<EntropyTable const> table_;
};

static_assert(EquationOfState<Tabulated>);

/// T, P and c_v of many states, as of other models.
void evaluate(Tabulated const& eos, EnergyStates const& in, ThermalResponse const& out);

} // namespace mesobridge::fitting
