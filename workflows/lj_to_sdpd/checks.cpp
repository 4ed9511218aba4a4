#include "workflows/lj_to_sdpd/checks.hpp"
#include "fitting/eos/evaluate.hpp"
#include "workflows/lj_to_sdpd/plan.hpp"
#include <algorithm>
#include <cmath>
#include <gsl/gsl_cdf.h>

namespace mesobridge::workflows {
namespace {

/// What time step and equilibration may do to a temperature, relative: of the scheme's order at the time
/// steps of the plan, which `trade-off` measures.
constexpr double temperature_accuracy = 1e-3;

/// What a calibration may leave of pressure and mean density beyond its statistical errors, relative: the
/// structure of large particles settles on while it runs.
constexpr double calibration_accuracy = 1e-3;

struct UP {
  double U, P;
};

UP state_by(std::string const& equation, double rho, double T) {
  return std::visit(
      [&](auto const& model) {
        auto const isochore = model.isochore(rho);
        return UP{isochore.energy(T), isochore.pressure(T)};
      },
      fitting::material(equation).eos);
}

double T_max_of(std::string const& equation) {
  return std::visit([](auto const& model) { return model.domain().T_max; }, fitting::material(equation).eos);
}

/// What relative errors are relative to: U passes through zero, P may.
UP scale_of(UP const& value, double rho, double T) {
  return {std::max(std::abs(value.U), T), std::max(std::abs(value.P), rho * T)};
}

std::string state_name(double rho, double T) {
  return fmt::format("at rho* = {:.3g}, T* = {:.3g}", rho, T);
}

std::vector<Comparison> against(UP const& value, UP const& se, double rho, double T,
                                std::string const& equation, PublishedAccuracy accuracy) {
  auto const known = state_by(equation, rho, T);
  auto const scale = scale_of(known, rho, T);
  return {{"U* " + state_name(rho, T), {value.U, se.U, 0}, {known.U, accuracy.U * scale.U, 0}},
          {"P* " + state_name(rho, T), {value.P, se.P, 0}, {known.P, accuracy.P * scale.P, 0}}};
}

std::vector<Comparison> held_out(fitting::LjBwrFit const& fit) {
  std::vector<Comparison> all;
  for (auto const& p : fit.points) {
    // The error of the difference, of data and prediction together, is all in the prediction's.
    all.push_back({"U* " + state_name(p.rho, p.T), {p.U, 0, 0}, {p.U_held_out, p.U_held_out_se, 0}});
    all.push_back({"P* " + state_name(p.rho, p.T), {p.P, 0, 0}, {p.P_held_out, p.P_held_out_se, 0}});
  }
  return all;
}

VerdictLine gamma_line(RunResult const& run) {
  constexpr double least = 1e-3;
  auto const test = gamma_test(run);
  return {.what = fmt::format("Ideal gas, K = {:g}: internal energies follow the exact Gamma law",
                              run.settings.K()),
          .found = fmt::format("Kolmogorov-Smirnov p = {:.3f}, {} samples", test.p_value, test.samples),
          .expected = fmt::format("p > {:g}", least),
          .verdict = test.p_value > least ? Verdict::passed : Verdict::failed,
          .deviation = fmt::format("{:.1f} se; allowed {:.1f}", gsl_cdf_ugaussian_Qinv(test.p_value / 2),
                                   allowed_deviation(1))};
}

void add_run(std::vector<VerdictLine>& lines, std::string const& name, RunResult const& run) {
  auto const who = fmt::format("{}, K = {:g}: ", name, run.settings.K());
  lines.push_back(check_line(who + "kinetic and internal temperature [K]", temperatures_of(run)));
  lines.push_back(
      check_line(who + "pressure [GPa] and mean density [kg/m³] of the equation of state", state_of(run)));
}

} // namespace

PublishedAccuracy published_accuracy(std::vector<fitting::LjBwrFitPoint> const& points) {
  double P = 0, U = 0, count = 0;
  for (auto const& point : points) {
    if (point.T > T_max_of("lj-thol"))
      continue;
    auto const a = state_by("lj-kn", point.rho, point.T), b = state_by("lj-thol", point.rho, point.T);
    auto const scale = scale_of(a, point.rho, point.T);
    P += std::pow((a.P - b.P) / scale.P, 2), U += std::pow((a.U - b.U) / scale.U, 2), count += 1;
  }
  if (count == 0)
    throw std::logic_error("no state at which both published equations are valid");
  return {std::sqrt(P / count), std::sqrt(U / count)};
}

std::vector<Comparison> data_against(std::vector<fitting::LjBwrFitPoint> const& points,
                                     std::string const& equation, PublishedAccuracy accuracy) {
  std::vector<Comparison> all;
  for (auto const& p : points)
    if (p.T <= T_max_of(equation))
      for (auto& comparison : against({p.U, p.P}, {p.U_se, p.P_se}, p.rho, p.T, equation, accuracy))
        all.push_back(std::move(comparison));
  return all;
}

std::vector<Comparison> fit_against(fitting::LjBwrFit const& fit, double rho, double T,
                                    std::string const& equation, PublishedAccuracy accuracy) {
  auto const ours = fit.predict(rho, T);
  return against({ours.U, ours.P}, {ours.U_se, ours.P_se}, rho, T, equation, accuracy);
}

std::vector<Comparison> temperatures_of(RunResult const& run) {
  auto const& e = run.equilibrium;
  double const T = run.settings.T;
  cg::Estimate const set{T, temperature_accuracy * T, 0};
  return {{"T_kin", {e.T_kin.mean * T, e.T_kin.se * T, e.T_kin.n_eff}, set},
          {"T_int", {e.T_int.mean * T, e.T_int.se * T, e.T_int.n_eff}, set}};
}

std::vector<Comparison> state_of(RunResult const& run) {
  auto const& e = run.equilibrium;
  double const rho = run.settings.rho, GPa = run.settings.units().pressure() / 1e9;
  double const P = std::visit(
      [&](auto const& eos) { return fitting::state_from_temperature(eos, rho, run.settings.T).P / 1e9; },
      run.settings.as<sdpd::Sdpd>().eos);
  double P_se = calibration_accuracy * P, rho_se = calibration_accuracy * rho;
  if (run.summary.contains("density_calibration")) {
    auto const& calibration = run.summary["density_calibration"];
    P_se = std::hypot(P_se, calibration["last_stage_P_Pa_se"].get<double>() / 1e9);
    rho_se = std::hypot(rho_se, calibration["last_stage_rho_kg_m3_se"].get<double>());
  }
  return {{"P", {e.P.mean * GPa, e.P.se * GPa, e.P.n_eff}, {P, P_se, 0}},
          {"density", {e.rho.mean.mean * rho, e.rho.mean.se * rho, e.rho.mean.n_eff}, {rho, rho_se, 0}}};
}

std::vector<VerdictLine> chain_checks(ChainResults const& results) {
  auto const& points = results.fit.points;
  auto const accuracy = published_accuracy(points);
  double const rho = fluid_rho / argon_units.mass * std::pow(argon_units.sigma, 3),
               T = fluid_T * k_B / argon_units.epsilon;
  std::vector<VerdictLine> lines;
  lines.push_back(check_line("Each state predicted by a fit without it", held_out(results.fit)));
  lines.push_back(check_line("MD at all states and the equation of Kolafa and Nezbeda (1994)",
                             data_against(points, "lj-kn", accuracy)));
  lines.push_back(check_line("MD up to T* = 9 and the equation of Thol et al. (2016)",
                             data_against(points, "lj-thol", accuracy)));
  lines.push_back(check_line("Fit at the state of the SDPD fluid and Kolafa and Nezbeda",
                             fit_against(results.fit, rho, T, "lj-kn", accuracy)));
  std::vector<fitting::LjBwrFitPoint> cold;
  std::ranges::copy_if(points, std::back_inserter(cold),
                       [](auto const& point) { return point.T <= fitting::LjBwrFit::published_T_max; });
  lines.push_back(noted_line("MD up to T* = 6 and the BWR set of Johnson et al. (1993): shown, not asked for",
                             data_against(cold, "lj", accuracy)));
  for (auto const& run : results.ideal) {
    lines.push_back(gamma_line(run));
    add_run(lines, "Ideal gas", run);
  }
  for (auto const& run : results.fluid)
    add_run(lines, "Lennard-Jones fluid", run);
  return lines;
}

} // namespace mesobridge::workflows
