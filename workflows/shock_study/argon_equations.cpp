#include "workflows/shock_study/argon_equations.hpp"
#include "fitting/eos/list.hpp"
#include "fitting/valid_range.hpp"
#include "md/units.hpp"
#include "workflows/eos/named_fluid.hpp"
#include "workflows/shock_study/shock_quantities.hpp"
#include <numbers>

namespace mesobridge::workflows {
namespace {

/// What is ahead of the front, SI.
struct AheadOfArgon {
  double rho, T, v_P;
};

/// A shock of the reduced fluid in the units of argon.
fitting::Shock in_argon_units(fitting::Shock shock) {
  for (auto* state : {&shock.ahead, &shock.behind})
    state->rho *= argon_units.density(), state->P *= argon_units.pressure(),
        state->T *= argon_units.temperature(), state->e *= argon_units.specific_energy();
  shock.v_S *= argon_units.velocity(), shock.v_P *= argon_units.velocity();
  return shock;
}

/// Argon by an equation of state; the BWR form, which knows units, in SI.
class Argon {
 public:
  explicit Argon(fitting::AnyEos const& eos) : fluid_(eos), reduced_(true) {
    if (auto const* bwr = std::get_if<fitting::LjBwr>(&eos))
      fluid_ = fitting::Fluid(bwr->in_units(argon_units)), reduced_ = false;
  }

  /// With the mean field of what lies beyond the cut-off [sigma] taken away, (F27).
  Argon cut_at(double cutoff) const {
    double const inverse = 1 / (cutoff * cutoff * cutoff);
    double const a = 16 * std::numbers::pi / 3 * (inverse - 2.0 / 3 * inverse * inverse * inverse);
    auto cut = *this;
    cut.fluid_ =
        fluid_.with_mean_field(reduced_ ? a : a * argon_units.specific_energy() / argon_units.density());
    return cut;
  }

  /// In SI.
  fitting::Shock shock(AheadOfArgon const& at) const {
    if (!reduced_)
      return by(at);
    return in_argon_units(by(
        {at.rho / argon_units.density(), at.T / argon_units.temperature(), at.v_P / argon_units.velocity()}));
  }

 private:
  fitting::Shock by(AheadOfArgon const& at) const {
    return fitting::Hugoniot(fluid_, fluid_.at_temperature(at.rho, at.T)).from_piston(at.v_P);
  }

  fitting::Fluid fluid_;
  bool reduced_; // in Lennard-Jones units
};

NamedShock named_shock(std::string key, std::string name, Argon const& argon, AheadOfArgon const& at,
                       double cutoff) {
  return {.key = std::move(key),
          .name = std::move(name),
          .shock = argon.shock(at),
          .cut = argon.cut_at(cutoff).shock(at)};
}

/// The parameters moved by a column of their covariance's factor, forward and backward.
ShockErrors errors_by(fitting::LjBwr const& eos, Eigen::MatrixXd const& factor, AheadOfArgon const& at) {
  std::array<double, 4> squares{};
  auto const moved = [&](Eigen::Index column, double sign) {
    auto set = eos.set();
    for (std::size_t j = 0; j < set.x.size(); ++j)
      set.x[j] += sign * factor(static_cast<Eigen::Index>(j), column);
    return Argon(fitting::LjBwr(set)).shock(at);
  };
  for (Eigen::Index column = 0; column < factor.cols(); ++column) {
    auto const up = moved(column, 1), down = moved(column, -1);
    for (std::size_t q = 0; q < squares.size(); ++q) {
      auto const of = shock_quantities()[q].of_shock;
      squares[q] += std::pow(0.5 * (of(up) - of(down)), 2);
    }
  }
  return {std::sqrt(squares[0]), std::sqrt(squares[1]), std::sqrt(squares[2]), std::sqrt(squares[3])};
}

/// Whether both states lie where the fit has data.
bool within_data(fitting::EosModel const& model, fitting::Shock const& shock) {
  auto const& scale = std::get<fitting::LjBwr>(model.eos).scale();
  auto const inside = [&](fitting::EosState const& state) {
    return !fitting::extrapolation(model, state.rho / argon_units.density() * scale.density,
                                   state.T / argon_units.temperature() * scale.temperature);
  };
  return inside(shock.ahead) && inside(shock.behind);
}

} // namespace

fitting::Shock argon_shock(std::string const& material, double rho, double T, double v_P) {
  return Argon(fitting::material(material).eos).shock({rho, T, v_P});
}

std::vector<NamedShock> argon_shocks(double rho, double T, double v_P, double cutoff) {
  std::vector<NamedShock> list;
  for (auto const& [key, name] :
       {std::pair("argon", "BWR of 1993"), {"lj-kn", "Kolafa and Nezbeda"}, {"lj-thol", "Thol et al."}})
    list.push_back(named_shock(key, name, Argon(fitting::material(key).eos), {rho, T, v_P}, cutoff));
  return list;
}

NamedShock fitted_argon_shock(std::string const& file, double rho, double T, double v_P, double cutoff) {
  auto const model = load_fluid(file).model;
  auto const* eos = std::get_if<fitting::LjBwr>(&model.eos);
  if (!eos)
    throw InputError(fmt::format("--fit = {}: must be a Lennard-Jones equation of kind lj-bwr, such as "
                                 "`workflow lj-to-sdpd` writes",
                                 file));
  try {
    AheadOfArgon const at{rho, T, v_P};
    auto found = named_shock(file, "our own fit", Argon(model.eos), at, cutoff);
    if (model.covariance_factor)
      found.se = errors_by(*eos, *model.covariance_factor, at);
    if (!within_data(model, found.shock))
      found.name += ", outside its data";
    return found;
  } catch (PhysicsError const& error) {
    throw InputError(fmt::format("--fit = {}: {}", file, error.what()));
  }
}

} // namespace mesobridge::workflows
