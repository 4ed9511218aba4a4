#include "workflows/store/damage_guard.hpp"
#include <array>
#include <csignal>
#include <cstring>
#include <unistd.h>

namespace mesobridge::workflows {
namespace {

constexpr int bad_input = 2; ///< exit code
constexpr std::array signals{SIGSEGV, SIGBUS, SIGFPE};

/// The file that this thread's library call reads; nothing outside such calls.
thread_local constinit char const* guarded_file = nullptr;
std::array<struct sigaction, signals.size()> others_handlers;

void say(char const* text) {
  [[maybe_unused]] auto const ignored = ::write(STDERR_FILENO, text, std::strlen(text));
}

extern "C" void on_crash(int signal) {
  if (guarded_file) {
    say("mesobridge: cannot read '"), say(guarded_file);
    say("': it is damaged, so that the HDF5 library crashes on it\n");
    _exit(bad_input);
  }
  for (std::size_t k = 0; k < signals.size(); ++k) // the instruction is repeated, and the crash is theirs
    if (signals[k] == signal)
      sigaction(signal, &others_handlers[k], nullptr);
}

void install_once() {
  static bool const installed = [] {
    struct sigaction action {};
    action.sa_handler = on_crash;
    for (std::size_t k = 0; k < signals.size(); ++k)
      sigaction(signals[k], &action, &others_handlers[k]);
    return true;
  }();
  (void)installed;
}

} // namespace

DamageGuard::DamageGuard(std::filesystem::path const& file) : file_(file.string()), before_(guarded_file) {
  install_once();
  guarded_file = file_.c_str();
}

DamageGuard::~DamageGuard() {
  guarded_file = before_;
}

} // namespace mesobridge::workflows
