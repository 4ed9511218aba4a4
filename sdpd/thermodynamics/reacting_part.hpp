#pragma once
#include "fitting/eos/linear_isochore.hpp"
#include "fitting/eos/list.hpp"

namespace mesobridge::sdpd {

/// A model with a constant heat capacity, whichever it is, as a part of a reacting particle. Where the
/// particle's centre of mass moves by itself, with R = k_B/(K m0), the part lacks the heat capacity 3/2 R and
/// the entropy 3/2 R ln T that go with it; what else the centre of mass has depends on the density of the
/// whole, not on that of the part, and so it is no matter of a part.
class ReactingPart : public fitting::LinearEos<ReactingPart> {
 public:
  static constexpr std::string_view name = "part of a mixture";

  /// Throws InputError for models whose heat capacity varies, or is not above 3/2 R.
  ReactingPart(fitting::AnyEos any, double R) : any_(std::move(any)) {
    std::visit(
        [&]<class Model>(Model const& of) {
          domain_ = of.domain();
          molecular_mass_ = of.molecular_mass(), boltzmann_ = of.boltzmann();
          if constexpr (fitting::LinearModel<Model>) {
            bulk_c_v_ = of.c_v(), rho_max_ = of.rho_max();
          } else {
            throw InputError(fmt::format("{}: cannot be a part of a reacting fluid; models with a constant "
                                         "heat capacity can",
                                         Model::name));
          }
        },
        any_);
    c_v_ = bulk_c_v_ - 1.5 * R;
    require(c_v_ > 0, "heat capacity of a reacting particle's part", c_v_,
            "must exceed that of the centre of mass: take larger particles");
  }

  template <class X>
  fitting::LinearLaw<X> law(X rho) const {
    auto law = std::visit(
        [&]<class Model>(Model const& of) -> fitting::LinearLaw<X> {
          if constexpr (fitting::LinearModel<Model>)
            return of.law(rho);
          else
            throw std::logic_error("a part whose heat capacity varies");
        },
        any_);
    double const ratio = bulk_c_v_ / c_v_;
    law.Gamma = ratio * law.Gamma;
    law.rho_Gamma_slope = ratio * law.rho_Gamma_slope;
    law.phi = ratio * law.phi;
    return law;
  }
  double c_v() const { return c_v_; }
  double rho_max() const { return rho_max_; }
  fitting::Domain domain() const { return domain_; }
  double molecular_mass() const { return molecular_mass_; }
  double boltzmann() const { return boltzmann_; }

 private:
  fitting::AnyEos any_;
  fitting::Domain domain_;
  double bulk_c_v_ = 0, c_v_ = 0, rho_max_ = 0, molecular_mass_ = 0, boltzmann_ = 0;
};

} // namespace mesobridge::sdpd
