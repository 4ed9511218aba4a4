#include "workflows/report/report.hpp"
#include "md/error.hpp"
#include "workflows/report/number_text.hpp"
#include "workflows/report/style_sheet.hpp"
#include "workflows/version.hpp"

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

std::string row(std::vector<std::string> const& cells, std::string const& tag) {
  std::string text = "<tr>";
  for (auto const& cell : cells)
    text += fmt::format("<{0}>{1}</{0}>", tag, prose(cell));
  return text + "</tr>\n";
}

struct ContentWriter {
  std::string operator()(Paragraph const& paragraph) const {
    return fmt::format("<p>{}</p>\n", prose(paragraph.text));
  }

  std::string operator()(Figure const& figure) const {
    std::string text = "<figure>\n<div class=\"drawings\">\n";
    for (auto const& svg : figure.svgs)
      text += fmt::format("<div>{}</div>\n", svg);
    return text + "</div>\n<figcaption>" + prose(figure.caption) + "</figcaption>\n</figure>\n";
  }

  std::string operator()(Table const& table) const {
    std::string text = "<div class=\"scroll\"><table>\n<caption>" + prose(table.caption) + "</caption>\n";
    text += "<thead>" + row(table.header, "th") + "</thead>\n<tbody>\n";
    for (auto const& cells : table.rows) {
      if (cells.size() != table.header.size())
        throw std::logic_error("a table's row has not as many cells as its header: " + table.caption);
      text += row(cells, "td");
    }
    return text + "</tbody>\n</table></div>\n";
  }
};

std::string verdicts_html(std::vector<VerdictLine> const& verdicts) {
  if (verdicts.empty())
    return "";
  std::string text =
      "<div class=\"scroll\"><table class=\"verdicts\">\n<thead><tr><th>Shown</th><th>Found</th>"
      "<th>Expected</th><th></th></tr></thead>\n<tbody>\n";
  for (auto const& line : verdicts) {
    bool const passed = line.verdict == Verdict::passed, failed = line.verdict == Verdict::failed;
    text +=
        fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td><td><span class=\"pill {}\">{}</span></td></tr>\n",
                    prose(line.what), prose(line.found), prose(line.expected),
                    passed   ? "passed"
                    : failed ? "failed"
                             : "noted",
                    passed   ? "agrees"
                    : failed ? "differs"
                             : "noted");
  }
  return text + "</tbody>\n</table></div>\n";
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
    entry("SHA-256 of " + input.filename().string(), fmt::format("`{}`", sha256_of_file(input)));
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
  body += verdicts_html(verdicts) + "<nav>";
  for (std::size_t i = 0; i < sections.size(); ++i)
    body += fmt::format("<a href=\"#s{}\">{}</a>", i, html_escaped(sections[i].title));
  body += "<a href=\"#made\">How it was made</a></nav>\n";
  for (std::size_t i = 0; i < sections.size(); ++i) {
    body += fmt::format("<h2 id=\"s{}\">{}</h2>\n", i, html_escaped(sections[i].title));
    for (auto const& item : sections[i].content)
      body += std::visit(ContentWriter{}, item);
  }
  body += provenance_html(provenance);
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
      "content=\"width=device-width, initial-scale=1\">\n<title>{}</title>\n<style>{}</style>\n</head>\n"
      "<body>\n<main>\n{}</main>\n</body>\n</html>\n",
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
