#include "md/error.hpp"
#include "scratch_directory.hpp"
#include "workflows/folder_lock.hpp"
#include "workflows/text_file.hpp"
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace mesobridge::workflows {
namespace {

using tests::ScratchDirectory;

TEST(FolderLock, IsHeldByOneAndNamesIt) {
  ScratchDirectory const scratch;
  auto const file = scratch / FolderLock::file_name;
  {
    FolderLock const lock(scratch / "", "mesobridge run a.toml");
    EXPECT_TRUE(std::filesystem::exists(file));
    try {
      FolderLock const second(scratch / "", "mesobridge run b.toml");
      FAIL();
    } catch (EnvironmentError const& error) {
      for (auto const& part : {std::string("mesobridge run a.toml"), std::to_string(getpid())})
        EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
    EXPECT_EQ(read_text_file(file).find("b.toml"), std::string::npos);
  }
  EXPECT_FALSE(std::filesystem::exists(file));
  FolderLock const again(scratch / "", "mesobridge run b.toml");
}

TEST(FolderLock, OfADeadProcessIsNone) {
  ScratchDirectory const scratch;
  pid_t const child = fork();
  if (child == 0) {
    FolderLock const lock(scratch / "", "one that dies");
    _exit(0); // without its destructor
  }
  int status = 0;
  waitpid(child, &status, 0);
  ASSERT_TRUE(std::filesystem::exists(scratch / FolderLock::file_name));
  FolderLock const lock(scratch / "", "the next");
  EXPECT_NE(read_text_file(scratch / FolderLock::file_name).find("the next"), std::string::npos);
}

TEST(FolderLock, SaysThatAFolderIsNotThere) {
  ScratchDirectory const scratch;
  EXPECT_THROW(FolderLock(scratch / "none", "x"), EnvironmentError);
}

} // namespace
} // namespace mesobridge::workflows
