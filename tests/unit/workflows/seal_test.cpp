#include "md/error.hpp"
#include "scratch_directory.hpp"
#include "workflows/store/page_digest.hpp"
#include "workflows/store/seal.hpp"
#include "workflows/store/store.hpp"
#include "workflows/text_file.hpp"
#include <fcntl.h>
#include <gtest/gtest.h>
#include <random>
#include <set>

namespace mesobridge::workflows {
namespace {

using tests::ScratchDirectory;

std::string noise(std::size_t size) {
  std::mt19937 generator(3);
  std::string text(size, '\0');
  for (char& c : text)
    c = static_cast<char>(generator());
  return text;
}

PageDigest digest_of(std::filesystem::path const& file) {
  PageDigest digest;
  digest.take(Descriptor(file, O_RDONLY), std::filesystem::file_size(file), file);
  return digest;
}

TEST(PageDigest, OfChangedPagesIsThatOfTheWholeFile) {
  ScratchDirectory const scratch;
  auto const file = scratch / "f";
  EXPECT_EQ(PageDigest::crc(std::string("123456789")), 0xcbf43926u); // the check value of CRC-32
  auto text = noise(300000);
  write_text_file(file, text);
  auto digest = digest_of(file);
  std::set<std::uint64_t> seen{digest.value()};
  for (std::size_t const length : {300001u, 400000u, 409600u, 409601u, 8192u, 100u, 5000u}) {
    auto const before = text.size() / PageDigest::page_size;
    text.resize(length, 'x');
    text[50] = static_cast<char>(text[50] + 1);
    write_text_file(file, text);
    Descriptor const source(file, O_RDONLY);
    digest.take(source, length, std::min(before, length / PageDigest::page_size), length, file);
    digest.take(source, length, 0, 1, file);
    EXPECT_EQ(digest.value(), digest_of(file).value()) << length;
    EXPECT_TRUE(seen.insert(digest.value()).second) << length;
  }
  // Exchanged pages are another file.
  auto const pages = noise(8192);
  write_text_file(file, pages);
  auto const one = digest_of(file).value();
  write_text_file(file, pages.substr(4096) + pages.substr(0, 4096));
  EXPECT_NE(one, digest_of(file).value());
}

TEST(Seal, ShowsEveryDamage) {
  ScratchDirectory const scratch;
  auto const file = scratch / "f";
  auto const text = noise(10000);
  write_text_file(file, text);
  EXPECT_EQ(sealed_length(file), std::nullopt);
  seal(file);
  EXPECT_EQ(sealed_length(file), 10000u);
  auto const sealed = read_text_file(file);
  EXPECT_EQ(sealed.substr(0, 10000), text);
  int refused = 0, unsealed = 0;
  for (std::size_t place = 0; place < sealed.size(); place += place < 9990 ? 111 : 1) {
    auto damaged = sealed;
    damaged[place] = static_cast<char>(damaged[place] ^ 4);
    write_text_file(file, damaged);
    try {
      EXPECT_EQ(sealed_length(file), std::nullopt) << place;
      ++unsealed;
    } catch (InputError const&) {
      ++refused;
    }
  }
  EXPECT_EQ(refused, 100); // in the content
  EXPECT_EQ(unsealed, 32); // in the seal
}

TEST(Seal, IsNotSeenByHdf5) {
  ScratchDirectory const scratch;
  auto const file = scratch / "f.h5";
  std::vector<double> const row{1, 2, 3};
  {
    Store store(file, Store::Mode::create, Store::Safety::marked);
    store.append("a", row);
    store.close();
  }
  ASSERT_TRUE(sealed_length(file));
  EXPECT_EQ(Store(file, Store::Mode::read).read_doubles("a"), row);
  { // It goes on, and is sealed again.
    Store store(file, Store::Mode::append, Store::Safety::marked);
    store.append("a", row);
    store.close();
  }
  ASSERT_TRUE(sealed_length(file));
  EXPECT_EQ(Store(file, Store::Mode::read).read_doubles("a").size(), 6u);
  auto text = read_text_file(file);
  text[text.size() / 2] = static_cast<char>(text[text.size() / 2] ^ 1);
  write_text_file(file, text);
  EXPECT_THROW(Store(file, Store::Mode::append, Store::Safety::marked), InputError);
}

} // namespace
} // namespace mesobridge::workflows
