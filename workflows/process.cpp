#include "workflows/process.hpp"
#include "md/error.hpp"
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <spawn.h>
#include <sstream>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace mesobridge::workflows {

namespace {

// Files instead of pipes: however much a program reads and writes, nobody waits for a full pipe.
using Stream = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

Stream scratch_stream() {
  Stream stream(std::tmpfile(), std::fclose);
  if (!stream)
    throw EnvironmentError(fmt::format("cannot create a temporary file: {}", std::strerror(errno)));
  return stream;
}

void fill(std::FILE* stream, std::string const& text) {
  bool const written = std::fwrite(text.data(), 1, text.size(), stream) == text.size();
  if (!written || std::fflush(stream) != 0)
    throw EnvironmentError(fmt::format("cannot write to a temporary file: {}", std::strerror(errno)));
  std::rewind(stream);
}

std::string content(std::FILE* stream) {
  std::rewind(stream);
  std::string text;
  char buffer[65536];
  while (auto const size = std::fread(buffer, 1, sizeof buffer, stream))
    text.append(buffer, size);
  return text;
}

struct FileActions {
  posix_spawn_file_actions_t actions;
  FileActions() { posix_spawn_file_actions_init(&actions); }
  ~FileActions() { posix_spawn_file_actions_destroy(&actions); }
  void redirect(std::FILE* stream, int to) { posix_spawn_file_actions_adddup2(&actions, fileno(stream), to); }
};

int wait_for(pid_t process) {
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

} // namespace

ProcessResult run_process(std::vector<std::string> const& command, std::string const& input) {
  auto const in = scratch_stream(), out = scratch_stream(), err = scratch_stream();
  fill(in.get(), input);
  FileActions files;
  files.redirect(in.get(), STDIN_FILENO);
  files.redirect(out.get(), STDOUT_FILENO);
  files.redirect(err.get(), STDERR_FILENO);
  std::vector<char*> words;
  for (auto const& word : command)
    words.push_back(const_cast<char*>(word.c_str())); // posix_spawnp promises not to write there
  words.push_back(nullptr);
  pid_t process = 0;
  int const cause = posix_spawnp(&process, words[0], &files.actions, nullptr, words.data(), environ);
  if (cause != 0)
    throw EnvironmentError(fmt::format("cannot run '{}': {}", command.front(), std::strerror(cause)));
  int const status = wait_for(process);
  return {.status = status, .output = content(out.get()), .errors = content(err.get())};
}

bool program_exists(std::string const& name) {
  char const* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (access((std::filesystem::path(folder) / name).c_str(), X_OK) == 0)
      return true;
  return false;
}

} // namespace mesobridge::workflows
