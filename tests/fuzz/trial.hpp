#pragma once
#include <filesystem>
#include <functional>
#include <random>
#include <string>
#include <vector>

namespace mesobridge::fuzz {

/// Random choices of one trial; the same seed gives the same trial on every machine.
class Random {
 public:
  explicit Random(std::uint64_t seed) : bits_(seed) {}

  std::size_t below(std::size_t end) { return static_cast<std::size_t>(bits_() % end); } ///< 0 ... end-1
  double unit() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }                 ///< 0 ... 1
  bool chance(double probability) { return unit() < probability; }
  template <class T>
  T const& of(std::vector<T> const& list) {
    return list[below(list.size())];
  }
  std::uint64_t bits() { return bits_(); }

 private:
  std::mt19937_64 bits_;
};

/// What a trial's last command must do beside what every one must: not die by a signal, not hang, print and
/// write no NaN when it succeeds.
enum class Expected {
  anything, ///< it may succeed or refuse
  refusal,  ///< what was changed contradicts or is missing: success would be a wrong number
  success,  ///< what was changed means the same
};

/// How one command ended.
struct Outcome {
  int status = 0;      ///< exit code, or 128 + the signal that ended it
  bool hung = false;   ///< it had to be killed
  std::string printed; ///< stdout, then stderr
};

/// One input: files in a folder, and the commands that read them there.
struct Trial {
  std::filesystem::path folder;
  std::vector<std::vector<std::string>> commands;
  Expected expected = Expected::anything;
  std::string change; ///< for people
  /// Asked after each command but the last: whether the next one shall run.
  std::function<bool(Outcome const&)> goes_on = [](Outcome const& outcome) { return outcome.status == 0; };
  /// Looks at how all commands ended and what they left; says what is wrong with it, or nothing.
  std::function<std::string(Trial const&, std::vector<Outcome> const&)> judge = nullptr;
};

/// A family of inputs.
struct Kind {
  std::string name;
  /// Makes what all trials begin with, once, in an empty folder.
  std::function<void(std::filesystem::path const&)> prepare;
  /// Changes one fresh copy of that folder.
  std::function<void(Random&, Trial&)> change;
};

std::vector<Kind> const& kinds();

} // namespace mesobridge::fuzz
