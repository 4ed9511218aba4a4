#pragma once
#include <functional>
#include <string>

namespace mesobridge::workflows {

/// A text element at a place in pixels; `anchor` is start, middle or end, `more` are further attributes.
std::string text_at(double x, double y, std::string const& anchor, std::string const& text,
                    std::string const& more = "");

/// A bar of so many shades whose lower end has the colour of the share 0, the upper that of 1; in pixels.
std::string colour_bar(double x, double y, int width, double height, int shades,
                       std::function<std::string(double)> const& colour_of);

} // namespace mesobridge::workflows
