#include "include_rule.hpp"
#include <gtest/gtest.h>
#include <map>
#include <set>

namespace mesobridge::tests {

namespace {

std::filesystem::path const source{MESOBRIDGE_SOURCE_DIR};

/// The stage of the README whose equations begin with that letter.
std::map<char, std::string> const stage_of{
    {'M', "md"}, {'C', "cg"}, {'F', "fitting"}, {'S', "sdpd"}, {'W', "workflows"}};

/// A text on one line, without the marks of comments and the seams of string literals that were wrapped.
std::string unwrapped(std::string const& text) {
  static std::regex const seam(R"re("\s*\n\s*"|\s*\n\s*(?:///?<? )?)re");
  std::string joined;
  std::size_t end = 0;
  for (std::sregex_iterator match(text.begin(), text.end(), seam), last; match != last; ++match) {
    joined += text.substr(end, std::size_t(match->position()) - end);
    joined += match->str().front() == '"' ? "" : " ";
    end = std::size_t(match->position() + match->length());
  }
  return joined + text.substr(end);
}

/// An equation of a stage's README that a source cites; `stage` is empty where the letter alone names it.
struct Citation {
  std::string stage, equation;
  bool operator==(Citation const&) const = default;
};

/// "sdpd/README.md, Eq. (S1), (S2)", "Eq. (S3)", "Eq. (C1)-(C4)": the ends of a range are cited.
std::vector<Citation> citations(std::string const& text) {
  static std::regex const cited(
      R"re((?:(\w+)/README\.md, )?Eq\. (\([A-Z][0-9]+\)(?:(?:, |-| and )\([A-Z][0-9]+\))*))re");
  static std::regex const number(R"re([A-Z][0-9]+)re");
  std::string const line = unwrapped(text);
  std::vector<Citation> found;
  for (std::sregex_iterator match(line.begin(), line.end(), cited), end; match != end; ++match) {
    std::string const numbers = (*match)[2];
    for (std::sregex_iterator each(numbers.begin(), numbers.end(), number); each != end; ++each)
      found.push_back({(*match)[1], each->str()});
  }
  return found;
}

/// Citations of what no file of the repository holds: a sheet of theory, or a numbered equation of no work.
std::vector<std::string> citations_of_nothing(std::string const& text) {
  static std::regex const sheet(R"re([Tt]heory sheet|[Tt]heory, (?:Eq|section))re");
  static std::regex const numbered(R"re(Eqs?\. \(?[0-9]+\.[0-9]+)re");
  std::string const line = unwrapped(text);
  std::vector<std::string> found;
  for (std::sregex_iterator match(line.begin(), line.end(), sheet), end; match != end; ++match)
    found.push_back(match->str());
  for (std::sregex_iterator match(line.begin(), line.end(), numbered), end; match != end; ++match)
    if (!match->prefix().str().ends_with("thesis, "))
      found.push_back(match->str());
  return found;
}

/// The equations that a README defines: each at the beginning of a line, indented.
std::set<std::string> equations(std::string const& readme) {
  static std::regex const defined(R"re(\n    \(([A-Z][0-9]+)\) )re");
  std::set<std::string> found;
  for (std::sregex_iterator match(readme.begin(), readme.end(), defined), end; match != end; ++match)
    EXPECT_TRUE(found.insert((*match)[1]).second) << (*match)[1] << " is defined twice";
  return found;
}

/// Calls f(file, text) for every source of the stages and the tests.
template <class F>
void for_each_source(F const& f) {
  for (auto const& folder : pipeline)
    for (auto const& entry : std::filesystem::recursive_directory_iterator(source / folder))
      if (auto const extension = entry.path().extension();
          (extension == ".hpp" || extension == ".cpp") && entry.path().filename() != "readme_rule_test.cpp")
        f(entry.path(), read(entry.path()));
}

TEST(ReadmeRule, EveryEquationThatASourceCitesStandsInAReadme) {
  std::map<std::string, std::set<std::string>> defined;
  for (auto const& [letter, stage] : stage_of) {
    defined[stage] = equations(read(source / stage / "README.md"));
    EXPECT_GE(defined[stage].size(), 3) << stage;
    for (auto const& equation : defined[stage])
      EXPECT_EQ(equation.front(), letter) << stage << "/README.md defines " << equation;
  }
  int seen = 0;
  std::set<std::string> cited_stages;
  for_each_source([&](std::filesystem::path const& file, std::string const& text) {
    for (auto const& [stage, equation] : citations(text)) {
      ++seen;
      auto const of = stage_of.find(equation.front());
      ASSERT_NE(of, stage_of.end()) << file << " cites " << equation;
      EXPECT_TRUE(stage.empty() || stage == of->second) << file << " cites " << stage << ", " << equation;
      EXPECT_TRUE(defined[of->second].contains(equation)) << file << " cites " << equation;
      cited_stages.insert(of->second);
    }
  });
  EXPECT_GT(seen, 60);
  EXPECT_GE(cited_stages.size(), 4);
}

TEST(ReadmeRule, NoSourceCitesWhatTheRepositoryDoesNotHold) {
  int files = 0;
  for_each_source([&](std::filesystem::path const& file, std::string const& text) {
    ++files;
    for (auto const& offence : citations_of_nothing(text))
      ADD_FAILURE() << file << " cites " << offence;
  });
  EXPECT_GT(files, 400);
}

TEST(ReadmeRule, CitationsAreFoundWhereverTheyAreWrapped) {
  EXPECT_EQ(citations("/// by its law (sdpd/README.md,\n  /// Eq. (S20), (S21)), pair\n"),
            (std::vector<Citation>{{"sdpd", "S20"}, {"sdpd", "S21"}}));
  EXPECT_EQ(citations("x(\"it is (fitting/README.md, \"\n      \"Eq. (F1)-(F3))\");"),
            (std::vector<Citation>{{"fitting", "F1"}, {"fitting", "F3"}}));
  EXPECT_EQ(citations("double x; ///< Eq. (C9)"), (std::vector<Citation>{{"", "C9"}}));
  EXPECT_TRUE(citations("// thesis, Eq. (2.20); (S1) alone is a number in brackets").empty());
  EXPECT_EQ(citations_of_nothing("/// (theory\n/// sheet, section 3)").size(), 1);
  EXPECT_EQ(citations_of_nothing("// friction (Eq. 1.33)").size(), 1);
  EXPECT_TRUE(citations_of_nothing("// noise (thesis,\n// Eq. (2.2))").empty());
  EXPECT_EQ(equations("\n    (S1)  a = b\n    (S12) c; see (S3) d\n  (S4) no\n"),
            (std::set<std::string>{"S1", "S12"}));
}

/// The sources and folders that a README names in `code`; folders have a slash at the end.
std::vector<std::string> paths(std::string const& readme) {
  static std::regex const path(R"re(`((?:[\w-]+/)*[\w-]+\.(?:hpp|cpp|sh)|(?:[\w-]+/)+)`)re");
  std::vector<std::string> found;
  for (std::sregex_iterator match(readme.begin(), readme.end(), path), end; match != end; ++match)
    found.push_back((*match)[1]);
  return found;
}

TEST(ReadmeRule, EveryFileThatAReadmeNamesIsThere) {
  EXPECT_EQ(paths("`a/b.hpp`, `c.cpp` and `d/`, `e.f()`, `run.h5`"),
            (std::vector<std::string>{"a/b.hpp", "c.cpp", "d/"}));
  std::vector<std::string> known;
  for (auto const& folder : pipeline)
    for (auto const& entry : std::filesystem::recursive_directory_iterator(source / folder))
      known.push_back("/" + std::filesystem::relative(entry.path(), source).string() +
                      (entry.is_directory() ? "/" : ""));
  int named = 0;
  for (auto const& stage : stages)
    for (auto const& name : paths(read(source / stage / "README.md"))) {
      EXPECT_TRUE(std::ranges::any_of(known, [&](auto const& path) { return path.ends_with("/" + name); }))
          << stage << "/README.md names " << name;
      ++named;
    }
  EXPECT_GT(named, 200);
}

TEST(ReadmeRule, EveryFolderOfAStageIsNamedInItsReadme) {
  int folders = 0;
  for (auto const& stage : stages)
    for (auto const& entry : std::filesystem::directory_iterator(source / stage))
      if (entry.is_directory()) {
        auto const name = entry.path().filename().string() + "/";
        EXPECT_TRUE(read(source / stage / "README.md").find("`" + name) != std::string::npos)
            << stage << "/README.md does not name " << name;
        ++folders;
      }
  EXPECT_GT(folders, 25);
}

} // namespace

} // namespace mesobridge::tests
