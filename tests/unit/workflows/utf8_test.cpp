#include "md/error.hpp"
#include "workflows/utf8.hpp"
#include <gtest/gtest.h>

namespace mesobridge::workflows {
namespace {

// The boundaries of RFC 3629's table of well-formed sequences, and what lies just outside.
TEST(Utf8, IsTheTableOfItsRfc) {
  int good = 0, bad = 0;
  for (std::string const text :
       {"", "plain", "\x7f", "\xc2\x80", "\xdf\xbf", "\xe0\xa0\x80", "\xed\x9f\xbf", "\xee\x80\x80",
        "\xef\xbf\xbf", "\xf0\x90\x80\x80", "\xf4\x8f\xbf\xbf", "a\xc3\xbc\xe6\xb0\xb4z"}) {
    EXPECT_TRUE(is_utf8(text)) << escaped_to_utf8(text);
    EXPECT_EQ(escaped_to_utf8(text), text);
    ++good;
  }
  for (std::string const text : {"\x80", "\xbf", "\xc0\x80", "\xc1\xbf", "\xc2", "\xc2\x41", "\xe0\x9f\xbf",
                                 "\xed\xa0\x80", "\xe2\x82", "\xf0\x8f\xbf\xbf", "\xf4\x90\x80\x80",
                                 "\xf5\x80\x80\x80", "\xff", "ok\xfc", "\xe6\xb0"}) {
    EXPECT_FALSE(is_utf8(text)) << escaped_to_utf8(text);
    EXPECT_TRUE(is_utf8(escaped_to_utf8(text)));
    ++bad;
  }
  EXPECT_EQ(good, 12);
  EXPECT_EQ(bad, 15);
}

TEST(Utf8, ShowsTheWordThatIsRefused) {
  EXPECT_NO_THROW(require_utf8({"run", "\xc3\xbc.toml"}));
  try {
    require_utf8({"run", "k\xfc"
                         "bel.toml"});
    FAIL();
  } catch (InputError const& error) {
    EXPECT_NE(std::string(error.what()).find("'k\\xfcbel.toml'"), std::string::npos) << error.what();
  }
}

} // namespace
} // namespace mesobridge::workflows
