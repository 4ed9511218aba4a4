#include "fitting/toml_reader.hpp"
#include "scratch_directory.hpp"
#include "workflows/command.hpp"
#include "workflows/process.hpp"
#include "workflows/text_file.hpp"
#include <gtest/gtest.h>
#include <regex>

// Every entry of tests/cases/*/cases.toml: inputs of real users' kind, and what the program must do with
// them. The README there explains the entries.

namespace mesobridge::workflows {
namespace {

using tests::ScratchDirectory;
namespace fs = std::filesystem;

fs::path const folder_of_cases = MESOBRIDGE_SOURCE_DIR "/tests/cases";

struct Case {
  std::string kind, name, run, needs;
  int exit = 0;
  double seconds = 60;
  std::vector<std::string> says, never, files, no_files;
  struct Number {
    std::string pointer;
    double value, tolerance;
  };
  std::vector<Number> numbers;

  friend void PrintTo(Case const& shown, std::ostream* out) { *out << shown.run; }
};

std::vector<std::string> texts(toml::table const& entry, char const* key) {
  std::vector<std::string> result;
  if (auto const* array = entry[key].as_array())
    for (auto const& text : *array)
      result.push_back(text.value<std::string>().value());
  return result;
}

void refuse_unknown_keys(toml::table const& entry, std::string const& where) {
  for (auto const& [key, value] : entry)
    if (std::string_view const name = key.str();
        std::string(" name run needs exit seconds says never files no_files json ")
            .find(fmt::format(" {} ", name)) == std::string::npos)
      throw InputError(fmt::format("{}: unknown key '{}'", where, name));
}

Case case_of(toml::table const& entry, std::string const& kind) {
  Case result{.kind = kind,
              .name = entry["name"].value<std::string>().value(),
              .run = entry["run"].value<std::string>().value(),
              .needs = entry["needs"].value_or(std::string()),
              .exit = entry["exit"].value<int>().value(),
              .seconds = entry["seconds"].value_or(60.0),
              .says = texts(entry, "says"),
              .never = texts(entry, "never"),
              .files = texts(entry, "files"),
              .no_files = texts(entry, "no_files"),
              .numbers = {}};
  refuse_unknown_keys(entry, kind + "/" + result.name);
  if (auto const* numbers = entry["json"].as_table())
    for (auto const& [pointer, pair] : *numbers)
      result.numbers.push_back({std::string(pointer.str()), pair.as_array()->at(0).value<double>().value(),
                                pair.as_array()->at(1).value<double>().value()});
  return result;
}

std::vector<Case> all_cases() {
  std::vector<Case> cases;
  for (auto const& folder : fs::directory_iterator(folder_of_cases)) {
    auto const table = folder.path() / "cases.toml";
    if (!fs::exists(table))
      continue;
    auto const read = fitting::parse_toml(read_text_file(table), table.string());
    for (auto const& entry : *read["case"].as_array())
      cases.push_back(case_of(*entry.as_table(), folder.path().filename().string()));
  }
  return cases;
}

std::string test_name(testing::TestParamInfo<Case> const& info) {
  std::string name = info.param.kind + "_" + info.param.name;
  std::ranges::replace(name, '-', '_');
  return name;
}

ProcessResult in_folder(fs::path const& place, double seconds, std::string const& command) {
  return run_process({"env", "-C", place.string(), "MESOBRIDGE=" MESOBRIDGE_PROGRAM,
                      "SOURCE=" MESOBRIDGE_SOURCE_DIR, "timeout", "-k", "5", fmt::format("{}", seconds), "sh",
                      "-c", command});
}

class Cases : public testing::TestWithParam<Case> {};

TEST_P(Cases, EndAsTheyMust) {
  auto const& expected = GetParam();
  ScratchDirectory const scratch;
  auto const place = scratch / "case";
  fs::copy(folder_of_cases / expected.kind, place, fs::copy_options::recursive);
  if (!expected.needs.empty() && in_folder(place, expected.seconds, expected.needs).status != 0)
    GTEST_SKIP() << "not there: " << expected.needs;
  auto const ended = in_folder(place, expected.seconds, expected.run);
  auto const printed = ended.output + ended.errors;
  EXPECT_EQ(ended.status, expected.exit) << expected.run << "\n" << printed;
  for (auto const& pattern : expected.says)
    EXPECT_TRUE(std::regex_search(printed, std::regex(pattern))) << pattern << "\n" << printed;
  for (auto const& pattern : expected.never)
    EXPECT_FALSE(std::regex_search(printed, std::regex(pattern))) << pattern << "\n" << printed;
  for (auto const& file : expected.files)
    EXPECT_TRUE(fs::exists(place / file)) << file << "\n" << printed;
  for (auto const& file : expected.no_files)
    EXPECT_FALSE(fs::exists(place / file)) << file << "\n" << printed;
  if (expected.numbers.empty())
    return;
  auto const json = Json::parse(ended.output);
  for (auto const& [pointer, value, tolerance] : expected.numbers)
    EXPECT_NEAR(json.at(Json::json_pointer(pointer)).get<double>(), value, tolerance) << pointer;
}

INSTANTIATE_TEST_SUITE_P(Table, Cases, testing::ValuesIn(all_cases()), test_name);

} // namespace
} // namespace mesobridge::workflows
