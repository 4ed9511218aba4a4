#pragma once
#include "workflows/report/report.hpp"
#include "workflows/study/trade_off.hpp"

namespace mesobridge::workflows {

/// All numbers of a study, with those of the recommendations for the target.
Json trade_off_json(TradeOff const& found, Target const& target);

/// Its report without provenance: Pareto front, drift, bias, stability, recommendation.
Report trade_off_report(TradeOff const& found, Target const& target);

/// "drift 1e-06 per reduced time": what was asked for.
std::string target_text(Target const& target);

/// What applies a recommendation to the scene: "--set scheme.name=ssa ... --set scheme.dt=0.25".
std::string settings_text(TradeOff const& found, double K, Recommendation const& choice);

/// The recommendation for each size in words and, on a line of its own, what applies it.
std::string recommendation_text(TradeOff const& found, Target const& target);

} // namespace mesobridge::workflows
