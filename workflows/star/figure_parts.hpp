#pragma once
#include "workflows/report/plot.hpp"
#include "workflows/star/chapter.hpp"

namespace mesobridge::workflows {

/// One panel, half as wide as a page.
Plot framed_plot(std::string name, std::string title, std::string x, std::string y);
/// The estimates of a profile with their errors.
Series points_of(cg::Profile const& profile, std::string label, int colour);
/// Without its points yet.
Series curve_of(std::string label, SeriesStyle style, int colour);
std::string density_label(ChapterMelt const& melt);

} // namespace mesobridge::workflows
