#include "md/error.hpp"
#include "scratch_directory.hpp"
#include "workflows/provenance.hpp"
#include "workflows/store/store.hpp"
#include "workflows/text_file.hpp"
#include <csignal>
#include <gtest/gtest.h>
#include <numeric>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace mesobridge::workflows {

namespace {

using tests::ScratchDirectory;
using Doubles = std::vector<double>;
using Integers = std::vector<std::int64_t>;

TEST(Store, WhatIsWrittenIsReadBack) {
  ScratchDirectory const scratch;
  Doubles const table{1.5, -2, 3, 0.1, 1e300, -0.0};
  Integers const counts{1, -2, std::int64_t{1} << 62};
  {
    Store store(scratch / "a.h5", Store::Mode::create);
    store.write("states/table", table, {2, 3});
    store.write("states/counts", counts);
    store.write("text", std::string("first line\nsecond: ρ, η"));
    store.write("empty", std::string());
    store.set_attribute("states", "T", 1.25);
    store.set_attribute("states/table", "seed", std::int64_t{7});
    store.set_attribute("states/table", "unit", std::string("Pa"));
    store.set_attribute("states/table", "unit", std::string("J/kg")); // replaces
    store.write("states/counts", Integers{4});                        // replaces
    store.close();
  }
  Store const store(scratch / "a.h5", Store::Mode::read);
  EXPECT_EQ(store.read_doubles("states/table"), table);
  EXPECT_EQ(store.shape("states/table"), (Store::Shape{2, 3}));
  EXPECT_EQ(store.read_integers("states/counts"), Integers{4});
  EXPECT_EQ(store.read_doubles("states/counts"), Doubles{4});
  EXPECT_EQ(store.read_text("text"), "first line\nsecond: ρ, η");
  EXPECT_EQ(store.read_text("empty"), "");
  EXPECT_EQ(store.read_double_attribute("states", "T"), 1.25);
  EXPECT_EQ(store.read_integer_attribute("states/table", "seed"), 7);
  EXPECT_EQ(store.read_text_attribute("states/table", "unit"), "J/kg");
  EXPECT_EQ(store.list("/"), (std::vector<std::string>{"empty", "states", "text"}));
  EXPECT_TRUE(store.contains("states/table"));
  EXPECT_FALSE(store.contains("states/tables"));
  EXPECT_FALSE(store.contains("no/such/path"));
}

TEST(Store, AppendedRowsSurviveWithoutAClose) {
  ScratchDirectory const scratch;
  auto const file = scratch / "series.h5";
  constexpr int rows = 2500; // several chunks
  pid_t const child = fork();
  if (child == 0) { // a run that is killed after its last flush
    Store store(file, Store::Mode::create);
    for (int i = 0; i < rows; ++i)
      store.append("U", Doubles{1.0 * i, -1.0 * i}, {2});
    store.append("step", Integers{1, 2, 3});
    store.flush();
    raise(SIGKILL);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFSIGNALED(status));
  {
    Store store(file, Store::Mode::append);
    EXPECT_EQ(store.shape("U"), (Store::Shape{rows, 2}));
    EXPECT_EQ(store.read_doubles("U").at(2 * 1234 + 1), -1234);
    store.append("step", Integers{4});
    EXPECT_THROW(store.append("U", Doubles{1, 2, 3}, {3}), std::logic_error);
    store.close();
  }
  EXPECT_EQ(Store(file, Store::Mode::read).read_integers("step"), (Integers{1, 2, 3, 4}));
}

TEST(Store, EqualDataMakeEqualFiles) {
  ScratchDirectory const scratch;
  for (auto const* name : {"a.h5", "b.h5"}) {
    Store store(scratch / name, Store::Mode::create);
    store.append("group/U", Doubles{1, 2});
    store.set_attribute("group", "seed", std::int64_t{1});
    store.close();
    if (std::string(name) == "a.h5")
      sleep(1); // a time stamp would differ now
  }
  EXPECT_EQ(sha256_of_file(scratch / "a.h5"), sha256_of_file(scratch / "b.h5"));
}

TEST(Store, UnreadableInputIsTheUsersError) {
  ScratchDirectory const scratch;
  write_text_file(scratch / "text.h5", "this is no HDF5 file");
  EXPECT_THROW(Store(scratch / "text.h5", Store::Mode::read), InputError);
  EXPECT_THROW(Store(scratch / "missing.h5", Store::Mode::read), InputError);
  Store store(scratch / "a.h5", Store::Mode::create);
  store.write("text", std::string("x"));
  EXPECT_THROW(store.read_doubles("missing"), InputError);
  EXPECT_THROW(store.read_doubles("text"), InputError);
  EXPECT_THROW(store.read_text_attribute("text", "unit"), InputError);
  EXPECT_THROW(Store(scratch / "no/such/folder.h5", Store::Mode::create), EnvironmentError);
}

/// Writes until the disk refuses; returns the message.
std::string message_when_full(std::filesystem::path const& file) {
  try {
    Store store(file, Store::Mode::create);
    Doubles const block(100000, 1.0);
    for (int i = 0; i < 100; ++i) {
      store.append("block", block);
      store.flush();
    }
    store.close();
  } catch (EnvironmentError const& error) {
    return error.what();
  }
  return "no error";
}

[[noreturn]] void fill_a_limited_disk(std::filesystem::path const& file) {
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit limit{};
  limit.rlim_cur = limit.rlim_max = 1 << 20;
  setrlimit(RLIMIT_FSIZE, &limit);
  auto const message = message_when_full(file);
  std::cerr << message << std::endl;
  bool const named =
      message.find("full.h5") != message.npos && message.find("File too large") != message.npos;
  std::exit(named ? 0 : 1);
}

TEST(Store, AFullDiskIsNamedWithItsCause) {
  ScratchDirectory const scratch;
  // A limit on the size of files fails in the same places as a full disk, and needs no rights. The limit is
  // set in a process of its own, whose end also shows that HDF5 does not trip over the dead file when it is
  // unloaded.
  EXPECT_EXIT(fill_a_limited_disk(scratch / "full.h5"), testing::ExitedWithCode(0), "^cannot [^\n]*\n$");
  EXPECT_EQ(message_when_full("/dev/full").find("cannot create '/dev/full'"), 0u);
  EXPECT_THROW(write_text_file("/no/such/folder/a.txt", "x"), EnvironmentError);
}

TEST(Provenance, IsWrittenAndHashesAgreeWithThePublishedOnes) {
  ScratchDirectory const scratch;
  write_text_file(scratch / "input.txt", "abc");
  // FIPS 180-2, appendix B.1
  EXPECT_EQ(sha256_of_file(scratch / "input.txt"),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  Provenance const provenance{.command = "mesobridge run x.toml",
                              .seed = 7,
                              .scene = "title = \"x\"\n",
                              .inputs = {scratch / "input.txt"}};
  Store store(scratch / "a.h5", Store::Mode::create);
  write_provenance(store, provenance);
  EXPECT_EQ(store.read_text_attribute("provenance", "command"), "mesobridge run x.toml");
  EXPECT_EQ(store.read_integer_attribute("provenance", "seed"), 7);
  EXPECT_EQ(store.read_text("provenance/scene"), "title = \"x\"\n");
  EXPECT_EQ(store.read_text_attribute("provenance/inputs", "sha256 of input.txt").substr(0, 8), "ba7816bf");
  EXPECT_EQ(provenance_json(provenance)["seed"], 7);
}

} // namespace

} // namespace mesobridge::workflows
