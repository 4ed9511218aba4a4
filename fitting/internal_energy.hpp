#pragma once
#include <memory>
#include <variant>
#include <vector>

/// Internal states of particles that have no density of their own (DPDE): entropy and temperature as
/// functions of the internal energy alone. Energies are counted in k_B times the unit of temperature,
/// entropies and heat capacities in k_B: one model serves all units (fitting/README.md, Eq. (F21)).
namespace mesobridge::fitting {

/// C everywhere: eps = C T, S = C ln eps.
class ConstantHeatCapacity {
 public:
  /// C > 0; throws InputError.
  explicit ConstantHeatCapacity(double C);

  double energy(double T) const { return C_ * T; }
  double entropy(double T) const;
  /// Throws PhysicsError for eps <= 0. The guess is not needed.
  double temperature(double eps, double T_guess) const;
  double heat_capacity(double) const { return C_; }
  double heat_capacity_slope(double) const { return 0; }
  static constexpr bool has_constant_heat_capacity = true;

 private:
  double C_;
};

/// C(T) from a table, monotone (Steffen) between its points, so positive; energy and entropy are its exact
/// integrals. Nothing outside the table.
class TabulatedHeatCapacity {
 public:
  /// T rising from above 0, C > 0, the energy at the first T. Throws InputError.
  TabulatedHeatCapacity(std::vector<double> T, std::vector<double> C, double eps_min);

  double T_min() const { return T_.front(); }
  double T_max() const { return T_.back(); }
  std::vector<double> const& temperatures() const { return T_; }
  std::vector<double> const& heat_capacities() const { return C_; }
  double eps_min() const { return eps_.front(); }

  /// These throw PhysicsError outside the table.
  double energy(double T) const;
  double entropy(double T) const; ///< zero at the first T
  double temperature(double eps, double T_guess) const;
  double heat_capacity(double T) const;
  double heat_capacity_slope(double T) const;
  static constexpr bool has_constant_heat_capacity = false;

 private:
  /// C(T) = c_0 + c_1 x + c_2 x^2 + c_3 x^3, x = T - T_k, between T_k and T_{k+1}.
  struct Cubic {
    double c_0, c_1, c_2, c_3;
  };
  std::size_t interval(double T) const;
  double capacity_in(std::size_t k, double x) const;
  double energy_in(std::size_t k, double x) const;
  double entropy_in(std::size_t k, double x) const;

  std::vector<double> T_, C_, eps_, S_; ///< eps and S at the points
  std::vector<Cubic> cubic_;
};

/// S(eps) from a table: one natural cubic spline, T = 1/S' and C = -S'^2/S'' from that same spline, which
/// must be concave and rising. Valid between the second point and the last but one, because the ends of a
/// natural spline have no curvature.
class TabulatedEntropy {
 public:
  /// eps rising. Throws InputError where the spline has no positive temperature and heat capacity.
  TabulatedEntropy(std::vector<double> eps, std::vector<double> S);

  double T_min() const { return 1 / slope_.front(); }
  double T_max() const { return 1 / slope_.back(); }
  /// All points of the table, with the two at its ends.
  std::vector<double> const& energies() const { return table_eps_; }
  std::vector<double> const& entropies() const { return table_S_; }

  /// These throw PhysicsError outside the table.
  double energy(double T) const;
  double entropy(double T) const;
  double temperature(double eps, double T_guess) const;
  double heat_capacity(double T) const;
  double heat_capacity_slope(double T) const;
  static constexpr bool has_constant_heat_capacity = false;

 private:
  /// The place in the table with this temperature: an interval and the distance from its beginning.
  struct Place {
    std::size_t k;
    double x;
  };
  Place place(double T) const;
  double first(Place p) const;  ///< S'
  double second(Place p) const; ///< S''
  double third(Place p) const;

  std::vector<double> table_eps_, table_S_;
  std::vector<double> eps_, S_, slope_, curvature_; ///< S, S' and S'' at the points inside
};

/// Every model; the engine chooses once, outside its loops.
using AnyInternalEnergy = std::variant<ConstantHeatCapacity, TabulatedHeatCapacity, TabulatedEntropy>;

} // namespace mesobridge::fitting
