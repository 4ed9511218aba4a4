#include "workflows/lj/fit_summary.hpp"
#include <cmath>

namespace mesobridge::workflows {

Json fit_json(fitting::LjBwrFit const& fit) {
  Json json{{"chi_2", fit.chi_2},
            {"degrees_of_freedom", fit.degrees_of_freedom},
            {"effective_parameters", fit.effective_parameters},
            {"prior_width", fit.prior_width},
            {"log_evidence", fit.log_evidence},
            {"condition_regularised", fit.condition_regularised},
            {"gamma", fit.eos.set().gamma},
            {"held_out_fraction", fit.held_out_fraction},
            {"rms_held_out_deviation", fit.rms_held_out_deviation},
            {"sampled",
             {{"rho_min", fit.sampled.rho_min},
              {"rho_max", fit.sampled.rho_max},
              {"T_min", fit.sampled.T_min},
              {"T_max", fit.sampled.T_max}}}};
  if (std::isfinite(fit.condition)) // it is infinite when the data alone leave some parameters free
    json["condition"] = fit.condition;
  json["points"] = Json::array();
  for (auto const& p : fit.points)
    json["points"].push_back({{"rho", p.rho},
                              {"T", p.T},
                              {"U", p.U},
                              {"U_se", p.U_se},
                              {"U_fit", p.U_fit},
                              {"U_fit_se", p.U_fit_se},
                              {"U_published", p.U_published},
                              {"U_held_out", p.U_held_out},
                              {"U_held_out_deviation", p.U_held_out_deviation},
                              {"P", p.P},
                              {"P_se", p.P_se},
                              {"P_fit", p.P_fit},
                              {"P_fit_se", p.P_fit_se},
                              {"P_published", p.P_published},
                              {"P_held_out", p.P_held_out},
                              {"P_held_out_deviation", p.P_held_out_deviation}});
  return json;
}

std::string fit_text(fitting::LjBwrFit const& fit) {
  auto const condition = std::isfinite(fit.condition)
                             ? fmt::format("{:.2g}", fit.condition)
                             : std::string("infinite (the data leave parameters free)");
  return fmt::format(
      "chi^2                 {:.1f} for {:.1f} degrees of freedom\n"
      "effective parameters  {:.1f} of 32 (the prior determines the others)\n"
      "condition number      {} of the data alone, {:.2g} with the prior\n"
      "held-out states       {:.0f} % within 3 standard errors in U and P; rms deviation {:.2f}\n"
      "data                  {} states, rho* {:.3g} ... {:.3g}, T* {:.3g} ... {:.3g}\n",
      fit.chi_2, fit.degrees_of_freedom, fit.effective_parameters, condition, fit.condition_regularised,
      100 * fit.held_out_fraction, fit.rms_held_out_deviation, fit.points.size(), fit.sampled.rho_min,
      fit.sampled.rho_max, fit.sampled.T_min, fit.sampled.T_max);
}

} // namespace mesobridge::workflows
