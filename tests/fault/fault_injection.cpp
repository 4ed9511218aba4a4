// A library to be preloaded (LD_PRELOAD) that lets the calls fail by which a program changes files, as a full
// disk or a broken one does:
//
//   MESOBRIDGE_FAIL_AT     the call to fail, counted from 1; none if not given
//   MESOBRIDGE_FAIL_ERRNO  its errno; if not given, ENOSPC
//   MESOBRIDGE_FAIL_MODE   once    only that call fails
//                          always  that one and all after it
//                          full    of these, those that need room on the disk: existing bytes can be
//                          overwritten short   that one, if it writes, writes half; all after it fail half
//                          that one, if it writes, writes half and says so; nothing else fails
//   MESOBRIDGE_FAIL_COUNT  a file that is told, at the end, how many calls there were
//
// Only regular files count but for the standard output and errors, and only the program itself, not those
// that it starts.

#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <dlfcn.h>
#include <fcntl.h>
#include <string>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

namespace {

struct Plan {
  long at = 0;
  int error = ENOSPC;
  std::string mode = "once", count;
  std::atomic<long> calls{0};
  bool silent = false;

  Plan() {
    auto text = [](char const* name) { return std::getenv(name) ? std::getenv(name) : ""; };
    at = std::atol(text("MESOBRIDGE_FAIL_AT"));
    if (int const given = std::atoi(text("MESOBRIDGE_FAIL_ERRNO")); given != 0)
      error = given;
    if (std::string const given = text("MESOBRIDGE_FAIL_MODE"); !given.empty())
      mode = given;
    count = text("MESOBRIDGE_FAIL_COUNT");
    unsetenv("LD_PRELOAD");
  }
  ~Plan() {
    if (count.empty())
      return;
    silent = true;
    if (auto* out = std::fopen(count.c_str(), "w")) {
      std::fprintf(out, "%ld\n", calls.load());
      std::fclose(out);
    }
  }
};

Plan& plan() {
  static Plan the_plan;
  return the_plan;
}

[[maybe_unused]] Plan& made_early = plan();

enum class Fate { pass, fail, half };

Fate fate(bool needs_room, bool writes) {
  auto& now = plan();
  if (now.silent)
    return Fate::pass;
  long const number = ++now.calls;
  if (now.at == 0 || number < now.at)
    return Fate::pass;
  bool const due = number == now.at;
  if (now.mode == "once")
    return due ? Fate::fail : Fate::pass;
  if (now.mode == "full")
    return needs_room ? Fate::fail : Fate::pass;
  if (due && (now.mode == "short" || now.mode == "half"))
    return writes ? Fate::half : Fate::pass;
  return now.mode == "half" ? Fate::pass : Fate::fail;
}

int fail() {
  errno = plan().error;
  return -1;
}

/// The call of the C library that this library stands before.
template <class Call>
Call real(char const* name) {
  return reinterpret_cast<Call>(dlsym(RTLD_NEXT, name));
}

/// Its length, or -1 when it is no regular file, or one that the program's output is redirected to.
off_t length_of(int descriptor) {
  struct stat status {};
  return descriptor > STDERR_FILENO && fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode)
             ? status.st_size
             : -1;
}

/// Writes as fate wants; `put` is handed the size.
template <class Put>
ssize_t write_by_fate(int descriptor, std::size_t size, off_t offset, Put const& put) {
  auto const length = length_of(descriptor);
  if (length < 0)
    return put(size);
  if (offset < 0)
    offset = fcntl(descriptor, F_GETFL) & O_APPEND ? length : lseek(descriptor, 0, SEEK_CUR);
  switch (fate(offset + static_cast<off_t>(size) > length, true)) {
  case Fate::fail:
    return fail();
  case Fate::half:
    return put(size > 1 ? size / 2 : size);
  case Fate::pass:
    break;
  }
  return put(size);
}

template <class Open>
int open_by_fate(char const* name, int flags, Open const& open) {
  struct stat status {};
  bool const makes = (flags & O_CREAT) && stat(name, &status) != 0;
  if ((flags & O_CREAT) && fate(makes, false) == Fate::fail)
    return fail();
  return open();
}

} // namespace

extern "C" {

ssize_t write(int descriptor, void const* data, size_t size) {
  static auto const next = real<ssize_t (*)(int, void const*, size_t)>("write");
  return write_by_fate(descriptor, size, -1, [&](size_t part) { return next(descriptor, data, part); });
}
ssize_t writev(int descriptor, iovec const* parts, int count) {
  static auto const next = real<ssize_t (*)(int, iovec const*, int)>("writev");
  if (length_of(descriptor) >= 0 && fate(true, false) == Fate::fail)
    return fail();
  return next(descriptor, parts, count);
}
ssize_t pwrite(int descriptor, void const* data, size_t size, off_t offset) {
  static auto const next = real<ssize_t (*)(int, void const*, size_t, off_t)>("pwrite");
  return write_by_fate(descriptor, size, offset,
                       [&](size_t part) { return next(descriptor, data, part, offset); });
}
ssize_t pwrite64(int descriptor, void const* data, size_t size, off64_t offset) {
  return pwrite(descriptor, data, size, offset);
}
int ftruncate(int descriptor, off_t length) {
  static auto const next = real<int (*)(int, off_t)>("ftruncate");
  return fate(length > length_of(descriptor), false) == Fate::fail ? fail() : next(descriptor, length);
}
int ftruncate64(int descriptor, off64_t length) {
  return ftruncate(descriptor, length);
}
int fsync(int descriptor) {
  static auto const next = real<int (*)(int)>("fsync");
  return fate(false, false) == Fate::fail ? fail() : next(descriptor);
}
int fdatasync(int descriptor) {
  static auto const next = real<int (*)(int)>("fdatasync");
  return fate(false, false) == Fate::fail ? fail() : next(descriptor);
}
int close(int descriptor) {
  static auto const next = real<int (*)(int)>("close");
  bool const written = length_of(descriptor) >= 0 && (fcntl(descriptor, F_GETFL) & O_ACCMODE) != O_RDONLY;
  bool const fails = written && fate(false, false) == Fate::fail;
  int const result = next(descriptor);
  return fails ? fail() : result;
}
int rename(char const* from, char const* to) {
  static auto const next = real<int (*)(char const*, char const*)>("rename");
  return fate(false, false) == Fate::fail ? fail() : next(from, to);
}
int link(char const* from, char const* to) {
  static auto const next = real<int (*)(char const*, char const*)>("link");
  return fate(false, false) == Fate::fail ? fail() : next(from, to);
}
int open(char const* name, int flags, ...) {
  static auto const next = real<int (*)(char const*, int, mode_t)>("open");
  va_list rest;
  va_start(rest, flags);
  auto const mode = va_arg(rest, mode_t);
  va_end(rest);
  return open_by_fate(name, flags, [&] { return next(name, flags, mode); });
}
int open64(char const* name, int flags, ...) {
  static auto const next = real<int (*)(char const*, int, mode_t)>("open64");
  va_list rest;
  va_start(rest, flags);
  auto const mode = va_arg(rest, mode_t);
  va_end(rest);
  return open_by_fate(name, flags, [&] { return next(name, flags, mode); });
}

} // extern "C"
