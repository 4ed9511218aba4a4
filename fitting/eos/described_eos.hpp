#pragma once
#include "fitting/eos/description.hpp"
#include "fitting/eos/linear_isochore.hpp"

namespace mesobridge::fitting {

/// A model with constant heat capacity that describes itself and is made of parameters, c_v and m0 [SI] among
/// them. It defines
///   law(rho), name   as for LinearEos,
///   description()    of its parameters,
///   edge()           what happens at the edge of its domain, in words,
///   rho_max()        where a density is too high for it.
template <class Model, class P>
class DescribedEos : public LinearEos<Model> {
 public:
  using Parameters = P;

  /// Throws InputError for a parameter out of its range.
  explicit DescribedEos(P const& parameters) : p_(checked<Model>(parameters)) {}

  double c_v() const { return p_.c_v; }
  double rho_max() const { return std::numeric_limits<double>::infinity(); }
  double molecular_mass() const { return p_.m0; }
  double boltzmann() const { return k_B; }
  P const& parameters() const { return p_; }
  Domain domain() const {
    auto const& model = static_cast<Model const&>(*this);
    return {.rho_min = 0,
            .rho_max = model.rho_max(),
            .T_min = 0,
            .T_max = std::numeric_limits<double>::infinity(),
            .edge = model.edge()};
  }

 protected:
  P p_;
};

} // namespace mesobridge::fitting
