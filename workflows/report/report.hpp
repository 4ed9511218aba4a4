#pragma once
#include "cg/estimate.hpp"
#include "workflows/provenance.hpp"
#include <string>
#include <variant>
#include <vector>

namespace mesobridge::workflows {

/// Whether what was measured is what was to be shown.
enum class Verdict { passed, failed, noted };

/// One line of the summary at the head of a report.
struct VerdictLine {
  std::string what;
  std::string found;
  std::string expected;
  Verdict verdict = Verdict::noted;
  std::string deviation = {}; ///< how far apart, in standard errors, and what is allowed; see check.hpp
};

/// Plain text; `words in backquotes` are set as code.
struct Paragraph {
  std::string text;
};

/// One or several drawings of draw_svg side by side with one caption.
struct Figure {
  std::vector<std::string> svgs;
  std::string caption;
};

/// Cells are plain text. All but the first column are set as numbers.
struct Table {
  std::vector<std::string> header = {};
  std::vector<std::vector<std::string>> rows = {};
  std::string caption = {};
};

/// Files beside the report, by their names there, and what is in them.
struct Files {
  struct Entry {
    std::string name, what;
  };
  std::vector<Entry> entries;
};

struct Section {
  std::string title;
  std::vector<std::variant<Paragraph, Figure, Table, Files>> content;
};

/// A report for people: one HTML file that needs nothing else, not even the network. It reads on screens from
/// 320 px on, light and dark, and prints.
struct Report {
  std::string title;
  std::string lead; ///< what this is and what came out, in two or three sentences
  std::vector<VerdictLine> verdicts;
  std::vector<Section> sections;
  Provenance provenance;
  std::vector<std::string> warnings = {}; ///< what a reader must know first
  std::vector<std::string> sources = {};  ///< keys of sources.hpp, of what the report compares with or uses

  std::string html() const;
};

/// "quantity | ours ± se | reference | difference in % | deviation in se": one row of a table whose header is
/// comparison_header().
std::vector<std::string> comparison_row(std::string const& quantity, cg::Estimate const& ours,
                                        double reference);
std::vector<std::string> comparison_header();

/// The text with &, <, > and " as HTML wants them.
std::string html_escaped(std::string const& text);

} // namespace mesobridge::workflows
