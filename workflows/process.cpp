#include "workflows/process.hpp"
#include "md/child_process.hpp"
#include "md/error.hpp"
#include <cstdio>
#include <cstring>
#include <memory>
#include <sys/wait.h>

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

int wait_for(pid_t process) {
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return md::exit_code_of(status);
}

} // namespace

ProcessResult run_process(std::vector<std::string> const& command, std::string const& input) {
  auto const in = scratch_stream(), out = scratch_stream(), err = scratch_stream();
  fill(in.get(), input);
  auto const program = md::program_file(command.front());
  if (!program)
    throw EnvironmentError(fmt::format("cannot run '{}': {}", command.front(), std::strerror(ENOENT)));
  auto words = command;
  words.front() = *program;
  int const status = wait_for(md::start_child(
      std::move(words), {.streams = std::array{fileno(in.get()), fileno(out.get()), fileno(err.get())}}));
  return {.status = status, .output = content(out.get()), .errors = content(err.get())};
}

} // namespace mesobridge::workflows
