#pragma once
#include <chrono>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>

namespace mesobridge::workflows {

/// A process that another one watches finds here the descriptor to which it writes the part of its work that
/// is done, 0 ... 1, a line each time.
constexpr char const* reports_variable = "MESOBRIDGE_REPORTS";

/// Shows how far a long piece of work is and how long it will still take: a bar that is redrawn on a
/// terminal, a plain line every 10 s elsewhere, nothing when quiet; a process that is watched reports every
/// second to the one that watches.
class Progress {
 public:
  using Clock = std::chrono::steady_clock;
  enum class Style { bar, lines, reports, quiet };

  /// The total is in any unit of work (> 0); the clock can be replaced in tests.
  Progress(Style style, std::ostream& out, std::string title, double total,
           std::function<Clock::time_point()> now = Clock::now);
  Progress(Progress&&) = default;
  ~Progress();

  /// Cheap enough for an inner loop: draws at most ten times a second.
  void update(double done, std::string const& note = "");

  /// Ends the display with one line that tells the time taken (a bar is removed). Further updates are
  /// ignored.
  void finish();

  /// A bar if stderr is a terminal, lines otherwise.
  static Style style_of_stderr();

 private:
  struct Instant {
    Clock::time_point time;
    double done;
  };
  void draw(Clock::time_point now, double done, std::string const& note);
  std::string left(Clock::time_point now, double done) const;

  Style style_;
  std::ostream* out_;
  std::string title_;
  double total_;
  std::function<Clock::time_point()> now_;
  Clock::time_point start_, drawn_;
  std::optional<Instant> first_; ///< update
  bool finished_ = false;
};

/// "8 s", "2 min 05 s", "3 h 20 min".
std::string duration_text(double seconds);

} // namespace mesobridge::workflows
