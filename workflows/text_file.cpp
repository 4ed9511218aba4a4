#include "workflows/text_file.hpp"
#include "md/error.hpp"
#include "workflows/store/durable_file.hpp"
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <sstream>
#include <unistd.h>

namespace mesobridge::workflows {

namespace {

[[noreturn]] void fail_to_write(std::filesystem::path const& file, int cause) {
  throw EnvironmentError(fmt::format("cannot write '{}': {}", file.string(), std::strerror(cause)));
}

/// 0, or the errno of the first call that failed.
int write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    auto const written = write(descriptor, text.data(), text.size());
    if (written < 0 && errno != EINTR)
      return errno;
    text.remove_prefix(written > 0 ? static_cast<std::size_t>(written) : 0);
  }
  return 0;
}

} // namespace

std::string read_text_file(std::filesystem::path const& file) {
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored))
    throw InputError(fmt::format("cannot read '{}': it is a directory", file.string()));
  std::ifstream stream(file, std::ios::binary);
  if (!stream)
    throw InputError(fmt::format("cannot read '{}': {}", file.string(), std::strerror(errno)));
  std::ostringstream text;
  text << stream.rdbuf();
  if (stream.bad())
    throw InputError(fmt::format("cannot read '{}': {}", file.string(), std::strerror(errno)));
  return std::move(text).str();
}

void write_text_file(std::filesystem::path const& file, std::string_view text) {
  auto const scratch = file.string() + ".new";
  int const descriptor = open(scratch.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor < 0)
    fail_to_write(file, errno);
  int cause = write_all(descriptor, text);
  if (cause == 0 && fsync(descriptor) != 0)
    cause = errno;
  if (close(descriptor) != 0 && cause == 0)
    cause = errno;
  if (cause == 0 && std::rename(scratch.c_str(), file.c_str()) != 0)
    cause = errno;
  if (cause != 0) {
    unlink(scratch.c_str());
    fail_to_write(file, cause);
  }
  sync_directory_of(file);
}

} // namespace mesobridge::workflows
