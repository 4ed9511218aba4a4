#include "md/error.hpp"
#include "workflows/csv_table.hpp"
#include <gtest/gtest.h>

namespace mesobridge::workflows {
namespace {

using Row = std::vector<std::string>;

std::string complaint(std::string const& text) {
  try {
    auto const table = parse_csv(text, "file.csv");
    for (auto const& row : table.rows)
      for (std::size_t c = 0; c < row.cells.size(); ++c)
        csv_number(table, row, c);
  } catch (InputError const& error) {
    return error.what();
  }
  return "nothing was thrown";
}

TEST(CsvTable, OneTableInManyForms) {
  std::vector<std::string> const forms{
      "a,b\n1.5,-2\n3,4e2\n",
      "\xEF\xBB\xBF"
      "a,b\r\n1.5,-2\r\n3,4e2\r\n",
      "a,b\r1.5,-2\r3,4e2",
      "# made by hand\n\n a , b \n 1.5 ,\t-2\n,\n3,4e2\n,,\n",
      "\"a\",\"b\"\n\"1.5\",\"-2\"\n\"+3\",\"4E+2\"\n",
      "a;b\n1,5;-2\n3;4e2\n",
      "a\tb\n1.5\t-2\n3\t4D2\n",
      "   a    b\n   1.5\t -2  \n 3  400.\n",
      "a,b,,\n1.5,\xE2\x88\x92"
      "2,,\n3,4d+2,,\n",
  };
  int compared = 0;
  for (auto const& form : forms) {
    SCOPED_TRACE(form);
    auto const table = parse_csv(form, "file.csv");
    EXPECT_EQ(table.header.cells, (Row{"a", "b"}));
    ASSERT_EQ(table.rows.size(), 2u);
    double const expected[2][2]{{1.5, -2}, {3, 400}};
    for (std::size_t r = 0; r < 2; ++r)
      for (std::size_t c = 0; c < 2; ++c, ++compared)
        EXPECT_EQ(csv_number(table, table.rows[r], c), expected[r][c]);
  }
  EXPECT_EQ(compared, 36);
}

TEST(CsvTable, QuotesHoldSeparatorsAndQuotes) {
  auto const table = parse_csv("name,x\n\"a, \"\"b\"\"\",2\n", "file.csv");
  EXPECT_EQ(table.rows[0].cells, (Row{"a, \"b\"", "2"}));
  EXPECT_EQ(table.rows[0].origin, "file.csv:2");
}

TEST(CsvTable, LinesAreCountedWhateverEndsThem) {
  for (std::string const end : {"\n", "\r\n", "\r"})
    EXPECT_EQ(parse_csv("#" + end + "a" + end + end + "1", "f").rows.at(0).origin, "f:4");
}

TEST(CsvTable, WhatIsWrongIsSaidWithItsLine) {
  std::vector<std::pair<std::string, std::string>> const cases{
      {"", "holds no data"},
      {"a,b\n", "holds no data"},
      {"a,b\n1\n", "file.csv:2: 1 cells, but the header names 2 columns"},
      {"a,b\n1,2,3\n", "file.csv:2: 3 cells"},
      {"a,a\n1,2\n", "file.csv:1: column 'a' stands there twice"},
      {"a,,b\n1,2,3\n", "file.csv:2: '2' stands in column 2, which has no name"},
      {"a\n\"1\n", "file.csv:2: a quote is not closed"},
      {"a,b\n1,x\n", "file.csv:2: column 'b': 'x' must be a finite number"},
      {"a,b\n1,inf\n", "'inf' must be a finite number"},
      {"a,b\n1,1e999\n", "'1e999' must be a finite number"},
      {"a,b\n1,+-2\n", "'+-2' must be a finite number"},
      {"a,b\n1,0x10\n", "'0x10' must be a finite number"},
      {"a,b\n1,\"1,234.5\"\n", "'1,234.5' must be a finite number"},
      {"a;b\n1,5;2\n1.5;2\n", "cannot be told"},
      {"1,2\n3,4\n", "file.csv:1: the first line that is no comment must name the columns"},
      {std::string("a\0,\0b\0", 6), "UTF-16"},
  };
  int ran = 0;
  for (auto const& [text, words] : cases) {
    EXPECT_NE(complaint(text).find(words), std::string::npos) << complaint(text);
    ++ran;
  }
  EXPECT_EQ(ran, 16);
}

} // namespace
} // namespace mesobridge::workflows
