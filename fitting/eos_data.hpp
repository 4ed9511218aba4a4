#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mesobridge::fitting {

/// What can be measured of a state, all in SI units and per unit mass.
enum class Quantity { rho, T, e, P, c_v, sound_speed, v_P, v_S };

/// "rho", "T" ... as in the headers of data files.
std::string_view symbol(Quantity quantity);

/// A number with its standard error (0: exact), to which a systematic one, not correlated with others', adds
/// in quadrature.
struct Datum {
  Quantity quantity;
  double value, se = 0;
  double systematic = 0;
};

/// The state from which a shock or an isentrope starts. Exactly one of T, e, P completes rho to a state of
/// the model itself; e and P together are a state of something else: with a reactant's P and its energy on
/// the model's scale, heat of reaction included, the Hugoniot is a Crussard curve.
struct StartState {
  double rho;
  std::optional<double> T, e, P;
};

/// How an observation's state is reached.
enum class DataPath {
  state,     ///< by rho and T, or rho and e
  hugoniot,  ///< by a shock from `start`, of known rho, P, v_P or v_S
  isentrope, ///< at constant entropy from `start`, to a known rho
  cj         ///< the Chapman-Jouguet point of `start`
};

/// One observation: what is given, and what was measured there.
struct Observation {
  /// The pressure of matter at rest, before the shock.
  struct AtRest {
    double P = 0;
    bool P_is_given = false; ///< otherwise it is 0 by assumption
    std::optional<double> P_se, rho_se;
  };

  DataPath path = DataPath::state;
  std::optional<StartState> start; ///< of shocks, isentropes and detonations
  std::vector<Datum> given;        ///< rho and T (or e); or one quantity; or none for cj
  std::vector<Datum> measured;     ///< standard errors > 0
  double P_e_correlation = 0;      ///< of the errors of P and e
  std::string origin;              ///< "tin.csv:12", for messages
  /// Of shocks whose start is a state of the model itself, by T or e: P0 is a datum, too.
  std::optional<AtRest> at_rest = std::nullopt;
};

/// Gives all measured quantities systematic errors: `fraction` of each value, of a pressure at least of the
/// spread of all pressures, of an energy, whose zero is arbitrary, of the spread of all energies. Throws
/// InputError unless 0 <= fraction < 1.
void add_systematic_errors(std::vector<Observation>& data, double fraction);

/// Throws InputError that names the origin unless the observation is complete and its numbers are possible.
void check(Observation const& observation);

} // namespace mesobridge::fitting
