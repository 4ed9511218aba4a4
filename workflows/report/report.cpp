#include "workflows/report/report.hpp"
#include "md/error.hpp"
#include "workflows/report/check.hpp"
#include "workflows/report/embedded_svg.hpp"
#include "workflows/report/number_text.hpp"
#include "workflows/report/sources.hpp"
#include "workflows/report/style_sheet.hpp"
#include "workflows/version.hpp"
#include <algorithm>

namespace mesobridge::workflows {

namespace {

std::string prose(std::string const& text) {
  std::string result;
  bool code = false;
  for (char const c : html_escaped(text)) {
    if (c != '`') {
      result += c;
      continue;
    }
    code = !code;
    result += code ? "<code>" : "</code>";
  }
  return result + (code ? "</code>" : "");
}

std::string row(std::vector<std::string> const& cells, std::string const& open, std::string const& close,
                std::string const& end = "</tr>\n") {
  std::string text = "<tr>";
  for (auto const& cell : cells)
    text += open + prose(cell) + close;
  return text + end;
}

/// Wide tables scroll inside this, with the keyboard too.
std::string scrolling(std::string const& table, std::string const& label) {
  return fmt::format("<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"{}\">{}</div>\n",
                     html_escaped(label), table);
}

/// Writes the parts of the sections; counts the drawings, so that each has names of its own.
struct ContentWriter {
  std::size_t drawings = 0, tables = 0;

  std::string operator()(Paragraph const& paragraph) {
    return fmt::format("<p>{}</p>\n", prose(paragraph.text));
  }

  std::string operator()(Figure const& figure) {
    if (figure.svgs.empty())
      return "";
    std::string text = "<figure>\n<div class=\"drawings\">\n";
    for (auto const& svg : figure.svgs)
      text += fmt::format("<div>{}</div>\n", embedded_svg(svg, ++drawings));
    return text + "</div>\n<figcaption>" + prose(figure.caption) + "</figcaption>\n</figure>\n";
  }

  std::string operator()(Table const& table) {
    std::string text = "<table>\n<caption>" + prose(table.caption) + "</caption>\n<thead>" +
                       row(table.header, "<th scope=\"col\">", "</th>") + "</thead>\n<tbody>\n";
    for (auto const& cells : table.rows) {
      if (cells.size() != table.header.size())
        throw std::logic_error("a table's row has not as many cells as its header: " + table.caption);
      text += row(cells, "<td>", "</td>");
    }
    return scrolling(text + "</tbody>\n</table>", fmt::format("Table {}", ++tables));
  }

  std::string operator()(Files const& files) {
    std::string text = "<ul>\n";
    for (auto const& [name, what] : files.entries)
      text += fmt::format("<li><a href=\"{0}\">{0}</a>: {1}</li>\n", html_escaped(name), prose(what));
    return text + "</ul>\n";
  }
};

std::string verdicts_html(std::vector<VerdictLine> const& verdicts) {
  if (verdicts.empty())
    return "";
  bool const deviations =
      std::ranges::any_of(verdicts, [](auto const& line) { return !line.deviation.empty(); });
  std::string text =
      fmt::format("<table class=\"verdicts\">\n<caption>{}</caption>\n<thead><tr>"
                  "<th scope=\"col\">Shown</th><th scope=\"col\">Found</th>"
                  "<th scope=\"col\">Expected</th>{}<th scope=\"col\">Verdict</th></tr></thead>\n"
                  "<tbody>\n",
                  deviations ? html_escaped(how_checks_are_made()) : "Checks",
                  deviations ? "<th scope=\"col\">Deviation</th>" : "");
  for (auto const& line : verdicts) {
    bool const passed = line.verdict == Verdict::passed, failed = line.verdict == Verdict::failed;
    text += row({line.what, line.found, line.expected}, "<td>", "</td>", "");
    if (deviations)
      text += fmt::format("<td>{}</td>", prose(line.deviation));
    text += fmt::format("<td><span class=\"pill {}\">{}</span></td></tr>\n",
                        passed   ? "passed"
                        : failed ? "failed"
                                 : "noted",
                        passed   ? "agrees"
                        : failed ? "differs"
                                 : "noted");
  }
  return scrolling(text + "</tbody>\n</table>", "Checks");
}

std::string warnings_html(std::vector<std::string> const& warnings) {
  if (warnings.empty())
    return "";
  std::string text = "<div class=\"warnings\" role=\"note\" aria-label=\"Warnings\">\n<ul>\n";
  for (auto const& warning : warnings)
    text += fmt::format("<li>{}</li>\n", prose(warning));
  return text + "</ul>\n</div>\n";
}

std::string sources_html(std::vector<std::string> const& keys) {
  if (keys.empty())
    return "";
  std::string text = "<h2 id=\"sources\">Sources</h2>\n<ul class=\"sources\">\n";
  for (auto const& key : keys) {
    auto const& [name, authors, title, where, year, link] = source(key);
    text += fmt::format("<li>{}. <cite>{}</cite>. {} ({}). <a href=\"{}\">{}</a></li>\n",
                        html_escaped(std::string(authors)), html_escaped(std::string(title)),
                        html_escaped(std::string(where)), year, link, link);
  }
  return text + "</ul>\n";
}

/// Where a report has enough sections to be lost in.
std::string contents_html(Report const& report) {
  constexpr std::size_t few = 3;
  if (report.sections.size() < few)
    return "";
  std::string text = "<nav aria-label=\"Contents\"><ul>";
  for (std::size_t i = 0; i < report.sections.size(); ++i)
    text += fmt::format("<li><a href=\"#s{}\">{}</a></li>", i, html_escaped(report.sections[i].title));
  if (!report.sources.empty())
    text += "<li><a href=\"#sources\">Sources</a></li>";
  return text + "<li><a href=\"#made\">How it was made</a></li></ul></nav>\n";
}

std::string provenance_html(Provenance const& provenance) {
  std::string text = "<h2 id=\"made\">How it was made</h2>\n<dl>\n";
  auto const entry = [&](std::string const& name, std::string const& value) {
    text += fmt::format("<dt>{}</dt><dd>{}</dd>\n", html_escaped(name), prose(value));
  };
  entry("Command", fmt::format("`{}`", provenance.command));
  entry("Program", fmt::format("mesobridge {} ({})", version(), git_commit()));
  entry("Seed", std::to_string(provenance.seed));
  for (auto const& input : provenance.inputs)
    entry("SHA-256 of " + input.path.filename().string(), fmt::format("`{}`", input.sha256));
  text += "</dl>\n";
  if (!provenance.scene.empty())
    text += "<p>The scene as resolved:</p>\n<pre>" + html_escaped(provenance.scene) + "</pre>\n";
  return text;
}

} // namespace

std::string html_escaped(std::string const& text) {
  std::string result;
  for (char const c : text)
    switch (c) {
    case '&':
      result += "&amp;";
      break;
    case '<':
      result += "&lt;";
      break;
    case '>':
      result += "&gt;";
      break;
    case '"':
      result += "&quot;";
      break;
    default:
      result += c;
    }
  return result;
}

std::string Report::html() const {
  auto body = fmt::format("<h1>{}</h1>\n<p class=\"lead\">{}</p>\n", html_escaped(title), prose(lead));
  body += warnings_html(warnings) + verdicts_html(verdicts) + contents_html(*this);
  ContentWriter writer;
  for (std::size_t i = 0; i < sections.size(); ++i) {
    body += fmt::format("<h2 id=\"s{}\">{}</h2>\n", i, html_escaped(sections[i].title));
    for (auto const& item : sections[i].content)
      body += std::visit(writer, item);
  }
  body += sources_html(sources) + provenance_html(provenance);
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
      "content=\"width=device-width, initial-scale=1\">\n<meta name=\"color-scheme\" content=\"light "
      "dark\">\n<title>{}</title>\n<style>{}</style>\n</head>\n<body>\n<main>\n{}</main>\n</body>\n</html>\n",
      html_escaped(title), style_sheet, body);
}

std::vector<std::string> comparison_header() {
  return {"Quantity", "Ours", "Reference", "Difference", "Deviation"};
}

std::vector<std::string> comparison_row(std::string const& quantity, cg::Estimate const& ours,
                                        double reference) {
  auto const difference =
      reference != 0 ? fmt::format("{:+.2f} %", 100 * (ours.mean / reference - 1)) : std::string("");
  auto const deviation =
      ours.se > 0 ? fmt::format("{:+.1f} se", cg::deviation(ours, reference)) : std::string("");
  return {quantity, with_error_text(ours), number_text(reference), difference, deviation};
}

} // namespace mesobridge::workflows
