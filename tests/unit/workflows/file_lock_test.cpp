#include "md/error.hpp"
#include "scratch_directory.hpp"
#include "workflows/store/file_lock.hpp"
#include "workflows/store/store.hpp"
#include "workflows/store/undo_journal.hpp"
#include "workflows/text_file.hpp"
#include <chrono>
#include <csignal>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace mesobridge::workflows {
namespace {

using tests::ScratchDirectory;
using namespace std::chrono_literals;

/// Another process that has the store open for a while.
class Holder {
 public:
  Holder(std::filesystem::path const& file, std::chrono::milliseconds how_long) : child_(fork()) {
    if (child_ != 0)
      return;
    try {
      Store store(file, Store::Mode::append, Store::Safety::marked);
      write_text_file(file.string() + ".held", "");
      std::this_thread::sleep_for(how_long);
      _exit(0);
    } catch (...) { // nothing of this may reach the other tests
      _exit(1);
    }
  }
  ~Holder() {
    kill(child_, SIGKILL);
    waitpid(child_, nullptr, 0);
  }
  void wait_until_held(std::filesystem::path const& file) const {
    for (int k = 0; k < 1000 && !std::filesystem::exists(file.string() + ".held"); ++k)
      std::this_thread::sleep_for(5ms);
  }

 private:
  pid_t child_;
};

std::filesystem::path small_store(ScratchDirectory const& scratch) {
  auto const file = scratch / "a.h5";
  Store store(file, Store::Mode::create, Store::Safety::marked);
  store.write("numbers", std::vector<double>{1, 2});
  store.close();
  return file;
}

TEST(FileLock, ARunWaitsForTheRanksOfTheOneBeforeToEnd) {
  ScratchDirectory const scratch;
  auto const file = small_store(scratch);
  Holder const holder(file, 2s);
  holder.wait_until_held(file);
  EXPECT_THROW(FileLock(file, FileLock::Kind::exclusive, 0.01), EnvironmentError) << "nobody holds it";
  Store const store(file, Store::Mode::append);
  EXPECT_EQ(store.read_doubles("numbers"), (std::vector<double>{1, 2}));
}

TEST(FileLock, SaysThatSomebodyElseIsAtWork) {
  ScratchDirectory const scratch;
  auto const file = small_store(scratch);
  Holder const holder(file, 60s);
  holder.wait_until_held(file);
  try {
    FileLock const lock(file, FileLock::Kind::shared, 0.1);
    FAIL() << "locked twice";
  } catch (EnvironmentError const& error) {
    EXPECT_NE(std::string(error.what()).find("in use by another process"), std::string::npos) << error.what();
  }
}

TEST(FileLock, WhatALiveWriterHasNotYetMarkedIsLeftAlone) {
  ScratchDirectory const scratch;
  auto const file = small_store(scratch);
  Holder const holder(file, 60s);
  holder.wait_until_held(file);
  ASSERT_TRUE(UndoJournal::exists(file));
  EXPECT_THROW(Store::mend(file, 0.1), EnvironmentError);
  EXPECT_TRUE(UndoJournal::exists(file));
}

TEST(FileLock, ReadersDoNotDisturbEachOther) {
  ScratchDirectory const scratch;
  auto const file = small_store(scratch);
  Store const first(file, Store::Mode::read), second(file, Store::Mode::read);
  EXPECT_EQ(second.read_doubles("numbers"), first.read_doubles("numbers"));
}

} // namespace
} // namespace mesobridge::workflows
