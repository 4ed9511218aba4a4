#pragma once
#include "workflows/report/report.hpp"
#include "workflows/study/trade_off.hpp"

namespace mesobridge::workflows {

/// All numbers of a study, with those of the recommendations for the target.
Json trade_off_json(TradeOff const& found, Target const& target);

/// Its report without provenance: Pareto front, drift, bias, stability, recommendation.
Report trade_off_report(TradeOff const& found, Target const& target);

/// "drift 1e-06 per reduced time": what was wished.
std::string target_text(Target const& target);

/// The recommendation for each size in words, one a line.
std::string recommendation_text(TradeOff const& found, Target const& target);

} // namespace mesobridge::workflows
