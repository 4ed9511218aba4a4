#pragma once
#include "workflows/report/plot.hpp"
#include "workflows/star/chapter.hpp"

namespace mesobridge::workflows {

/// Melts of one molecule unless said otherwise.
using Melts = std::vector<ChapterMelt const*>;

/// The figures of chapter 3, by their numbers in the thesis.
Plot figure_3_2(ChapterMelt const& melt);
Plot figure_3_3(ChapterMelt const& melt);
Plot figure_3_4(ChapterMelt const& melt);
std::string figure_3_5(ChapterMelt const& melt); ///< drawn
Plot figure_3_7(Melts const& melts);
Plot figure_3_8(Melts const& melts);
Plot figure_3_10(ChapterMelt const& melt);
Plot figure_3_11(ChapterMelt const& melt);
Plot figure_3_12(ChapterMelt const& melt);

Plot entropy_figure(std::string const& name, Melts const& melts); ///< 3.6, 3.14
Plot radial_figure(std::string const& name, Melts const& melts);  ///< 3.9, 3.13
/// Of melts of any molecules.
Plot heat_capacity_differences(Melts const& melts);

} // namespace mesobridge::workflows
