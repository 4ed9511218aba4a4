#include "workflows/report/gnuplot.hpp"
#include "md/error.hpp"
#include "workflows/process.hpp"
#include "workflows/report/report.hpp"
#include <algorithm>

namespace mesobridge::workflows {
namespace {

/// A text without braces and backslashes, as HTML wants it.
std::string spoken(std::string text) {
  std::erase_if(text, [](char c) { return std::string_view("{}\\").find(c) != std::string_view::npos; });
  return html_escaped(text);
}

} // namespace

std::string gnuplot_svg(std::string const& script, std::string const& name, std::string const& described) {
  auto const result = run_process({"gnuplot", "-d"}, script);
  auto const start = result.output.find("<svg");
  if (result.status != 0 || start == std::string::npos || !result.output.ends_with("</svg>\n\n"))
    throw EnvironmentError(
        fmt::format("gnuplot could not draw '{}': {}", name,
                    result.errors.empty() ? "it wrote no complete picture" : result.errors));
  auto svg = result.output.substr(start);
  auto const title = fmt::format("<title>{}</title>", name);
  if (auto const at = svg.find(title); at != std::string::npos)
    svg.replace(at, title.size(), fmt::format("<title>{}</title>", spoken(described)));
  return svg.insert(svg.find("<svg") + 4, " role=\"img\"");
}

} // namespace mesobridge::workflows
