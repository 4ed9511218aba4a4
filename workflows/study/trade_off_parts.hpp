#pragma once
#include "workflows/sdpd/settings.hpp"
#include "workflows/study/trade_off_summary.hpp"
#include <set>

/// What the numbers, the words and the report of a study share.
namespace mesobridge::workflows {

/// Units of a size's results.
struct SizeUnits {
  OutputUnits units;
  bool si;
  double ps; ///< of a reduced unit of time; in Lennard-Jones scenes Lennard-Jones units of time
};

SizeUnits units_of(TradeOff const& found, double K);

std::string time_name(SizeUnits const& units);

/// A drift per unit of time, so many reduced units long.
cg::Estimate estimate(sdpd::Drift const& drift, double unit);

/// "ems, strang": what is not usual.
std::string short_name(Configuration const& of);

std::set<double> sizes(TradeOff const& found);

/// "K = 10: ", nothing for particles without sizes.
std::string size_text(double K);

} // namespace mesobridge::workflows
