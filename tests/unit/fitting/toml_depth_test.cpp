#include "error_text.hpp"
#include "fitting/toml_depth.hpp"
#include "fitting/toml_reader.hpp"
#include <gtest/gtest.h>

namespace mesobridge::fitting {

namespace {

/// `count` copies of a text.
std::string times(std::size_t count, std::string const& text) {
  std::string all;
  for (std::size_t k = 0; k < count; ++k)
    all += text;
  return all;
}

std::string refusal(std::string const& text) {
  return tests::error_text([&] { parse_toml(text, "a.toml"); });
}

TEST(TomlDepth, DeepNestingOfEveryKindIsRefusedBeforeTheParser) {
  constexpr std::size_t deep = 100000;
  std::vector<std::string> const all{times(deep, "a.") + "a = 1",
                                     times(deep, "\"a b\" . ") + "a = 1",
                                     "[" + times(deep, "a.") + "a]\nx = 1",
                                     "[[" + times(deep, "a.") + "a]]\nx = 1",
                                     "x = " + times(deep, "["),
                                     "x = " + times(deep, "[") + times(deep, "]"),
                                     "x = [\n" + times(deep, "[\n") + times(deep, "]\n") + "]",
                                     "x = " + times(deep, "{ a = ") + "1" + times(deep, " }"),
                                     times(2000, "a.b.c = { ") + "x = 1" + times(2000, " }"),
                                     "[" + times(40, "a.") + "a]\n" + times(40, "b.") + "b = 1",
                                     "title = \"\"\"\n[\n\"\"\"\n" + times(deep, "a.") + "a = 1",
                                     "title = 'it''s'\n" + times(deep, "a.") + "a = 1",
                                     "# \"\n" + times(deep, "a.") + "a = 1"};
  std::size_t tried = 0;
  for (auto const& text : all) {
    EXPECT_NE(refusal(text).find("more than 64 deep"), std::string::npos) << text.substr(0, 40);
    ++tried;
  }
  EXPECT_EQ(tried, 13u);
  EXPECT_EQ(refusal("a = 1\nb = 2\n" + times(deep, "c.") + "c = 3").find("a.toml:3:"), 0u);
}

TEST(TomlDepth, WhatIsNotNestedIsNotDeep) {
  std::string numbers = "x = [ ";
  for (int k = 0; k < 1000; ++k)
    numbers += "[ 1.5, -2.5e-3 ],\n";
  std::vector<std::string> const all{"x = \"" + times(1000, "[{.") + "\"",
                                     "x = '" + times(1000, "[{.") + "'",
                                     "x = \"\\\"" + times(1000, "[") + "\"",
                                     "x = \"\"\"\n" + times(1000, "[.\n") + "\"\"\"",
                                     "x = '''" + times(1000, "{'.\n") + "'''",
                                     "# " + times(1000, "[."),
                                     "\"" + times(1000, ".") + "\" = 1",
                                     numbers + "]",
                                     times(60, "a.") + "a = 1",
                                     "[" + times(60, "a.") + "a]\nx = 1\n[" + times(60, "b.") + "b]\nx = 1",
                                     "x = { a = [ 1, 2 ], b = { c = 1.5 } }\n" + times(1, "y = 3") +
                                         "\n[[t]]\na = 1\n[[t]]\na = 2"};
  std::size_t tried = 0;
  for (auto const& text : all) {
    EXPECT_EQ(refusal(text), "no error") << text.substr(0, 40);
    ++tried;
  }
  EXPECT_EQ(tried, 11u);
}

} // namespace

} // namespace mesobridge::fitting
