#include "workflows/report/embedded_svg.hpp"
#include "workflows/report/plot.hpp"
#include <array>
#include <fmt/format.h>
#include <regex>

namespace mesobridge::workflows {
namespace {

void replace_all(std::string& text, std::string const& what, std::string const& by) {
  for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
}

/// Both spellings that gnuplot has for a colour, "#0072B2" and "rgb(  0, 114, 178)".
void replace_colour(std::string& svg, std::string const& hex, std::string const& variable) {
  int const rgb = std::stoi(hex.substr(1), nullptr, 16);
  replace_all(svg, fmt::format("rgb({:3}, {:3}, {:3})", rgb >> 16, rgb >> 8 & 255, rgb & 255), variable);
  for (char const* const name : {"color", "stroke", "fill"})
    for (char const quote : {'\'', '"'})
      replace_all(svg, fmt::format("{}={}{}{}", name, quote, hex, quote),
                  fmt::format("{}={}{}{}", name, quote, variable, quote));
}

} // namespace

std::string embedded_svg(std::string svg, std::size_t number) {
  static std::regex const id(R"re(\bid=(['"]))re"), link(R"re(href=(['"])#)re"), url(R"re(url\(#)re");
  auto const prefix = fmt::format("d{}-", number);
  svg = std::regex_replace(svg, id, "id=$1" + prefix);
  svg = std::regex_replace(svg, link, "href=$1#" + prefix);
  svg = std::regex_replace(svg, url, "url(#" + prefix);
  // The first full rectangle is the paper.
  auto const paper = fmt::format("<rect x=\"0\" y=\"0\" width=\"{}\" height=\"{}\" fill=\"#ffffff\"/>",
                                 plot_width, plot_height);
  if (auto const at = svg.find(paper); at != std::string::npos)
    svg.erase(at, paper.size());
  for (std::size_t k = 0; k < palette().size(); ++k)
    replace_colour(svg, palette()[k], fmt::format("var(--c{})", k));
  for (auto const& [hex, variable] : {std::pair{"#444444", "var(--axis)"},
                                      {"#e4e4e4", "var(--grid)"},
                                      {"#888888", "var(--level)"},
                                      {"#1f2328", "var(--axis)"}})
    replace_colour(svg, hex, variable);
  return svg;
}

} // namespace mesobridge::workflows
