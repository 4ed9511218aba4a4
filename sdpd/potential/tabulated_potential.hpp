#pragma once
#include "sdpd/potential/pair_force.hpp"
#include "sdpd/potential/uniform_table.hpp"

namespace mesobridge::sdpd {

/// A potential from a table: one spline, whose derivative is the force, so that energy is conserved. Shifted
/// to zero at its last point, the cut-off; not defined below its first.
class TabulatedPotential {
 public:
  /// r rising from 0 or above, with u(r) and, if it is known, the force -u'(r): with it the spline is
  /// Hermite's through both, without it the natural cubic one. Throws InputError, also for a force that is
  /// not -du/dr by the differences of u, as far as the rows' distances can tell, and names the row.
  TabulatedPotential(std::vector<double> const& r, std::vector<double> const& u,
                     std::vector<double> const& force = {});
  TabulatedPotential in_units(double length, double energy) const {
    return TabulatedPotential(table_.scaled(1 / length, 1 / energy));
  }
  double cutoff() const { return table_.end(); }
  double inner() const { return table_.begin(); }

  /// Valid for inner() <= r <= cutoff().
  template <class X>
  PairForce<X> operator()(X const& r, X const& inverse_r) const {
    auto const [c_0, c_1, c_2, c_3, t] = table_.at(r);
    X const slope = c_1 + t * (2.0 * c_2 + t * (3.0 * c_3));
    return {c_0 + t * (c_1 + t * (c_2 + t * c_3)), -table_.per_width() * (slope * inverse_r)};
  }

 private:
  explicit TabulatedPotential(UniformTable table) : table_(std::move(table)) {}
  UniformTable table_;
};

} // namespace mesobridge::sdpd
