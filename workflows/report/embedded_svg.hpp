#pragma once
#include <cstddef>
#include <string>

namespace mesobridge::workflows {

/// A drawing of draw_svg as it stands in a page with others: its names (ids) carry the number, which is
/// unique in the page, its background is the page's and its colours follow the page's, light or dark
/// (variables of style_sheet.hpp).
std::string embedded_svg(std::string svg, std::size_t number);

} // namespace mesobridge::workflows
