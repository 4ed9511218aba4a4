#include "workflows/progress.hpp"
#include "md/error.hpp"
#include "md/rank_launcher.hpp"
#include "workflows/terminal.hpp"
#include <algorithm>
#include <ostream>
#include <utility>

namespace mesobridge::workflows {

namespace {

constexpr auto bar_interval = std::chrono::milliseconds(100);
constexpr auto line_interval = std::chrono::seconds(10);
constexpr auto report_interval = std::chrono::seconds(1);
constexpr std::size_t widest_bar = 30, narrowest_bar = 10, shortest_title = 12;
constexpr char const* erase_line = "\r\033[K";

Progress::Clock::duration interval_of(Progress::Style style) {
  switch (style) {
  case Progress::Style::bar:
    return bar_interval;
  case Progress::Style::reports:
    return report_interval;
  default:
    return line_interval;
  }
}

/// One line of the terminal, whose last column stays free. What there is no room for gives way in turn: the
/// end of the note, the bar's length, the end of the title, the bar, the title.
std::string bar_text(std::string const& whole_title, double fraction, std::string const& left,
                     std::string const& note, std::size_t columns) {
  std::size_t const room = std::max<std::size_t>(columns, 2) - 1;
  auto less = [room](std::size_t taken) { return room - std::min(room, taken); };
  std::string const share = fmt::format("{:3.0f} % · {}", 100 * fraction, left);
  std::size_t const fixed = display_width(share) + std::string(" [] ").size();
  auto const title = fitted(whole_title, std::max(shortest_title, less(fixed + narrowest_bar)));
  auto const taken = display_width(title) + fixed;
  if (taken + narrowest_bar > room) {
    auto const start = fitted(whole_title, less(display_width(share) + 1));
    return fitted(start.empty() ? share : start + " " + share, room);
  }
  auto const length = std::min(widest_bar, room - taken);
  auto const filled = static_cast<std::size_t>(fraction * static_cast<double>(length));
  auto const line =
      fmt::format("{} [{}{}] {}", title, std::string(filled, '#'), std::string(length - filled, '.'), share);
  return fitted(note.empty() ? line : line + " · " + note, room);
}

} // namespace

std::string duration_text(double seconds) {
  constexpr double day = 86400, year = 365.25 * day;
  if (seconds >= 2 * year)
    return fmt::format("{:.3g} years", seconds / year);
  if (seconds >= 3 * day)
    return fmt::format("{:.0f} days", seconds / day);
  auto const s = static_cast<long>(seconds + 0.5);
  if (s < 60)
    return fmt::format("{} s", s);
  if (s < 3600)
    return fmt::format("{} min {:02} s", s / 60, s % 60);
  return fmt::format("{} h {:02} min", s / 3600, s % 3600 / 60);
}

Progress::Progress(Style style, std::ostream& out, std::string title, double total,
                   std::function<Clock::time_point()> now)
    : style_(style), out_(&out), title_(std::move(title)), total_(total), now_(std::move(now)),
      start_(now_()), drawn_(start_) {
  require(total > 0, "total work of '" + title_ + "'", total, "must be > 0");
}

Progress::~Progress() {
  // A moved-from object has an empty clock and nothing on the screen.
  if (now_ && !finished_ && style_ == Style::bar)
    *out_ << erase_line << std::flush;
}

void Progress::update(double done, std::string const& note) {
  if (finished_ || style_ == Style::quiet)
    return;
  auto const now = now_();
  if (!first_)
    first_ = Instant{now, done};
  if (now - drawn_ < interval_of(style_))
    return;
  drawn_ = now;
  draw(now, done, note);
}

std::string Progress::left(Clock::time_point now, double done) const {
  // A resumed run finds much of its work done: what was done since the first update tells its speed.
  if (done <= first_->done)
    return "starting";
  double const elapsed = std::chrono::duration<double>(now - first_->time).count();
  return duration_text(elapsed * std::max(total_ - done, 0.0) / (done - first_->done)) + " left";
}

void Progress::draw(Clock::time_point now, double done, std::string const& note) {
  double const fraction = std::clamp(done / total_, 0.0, 1.0);
  if (style_ == Style::reports)
    *out_ << fmt::format("{:.6f}\n", fraction);
  else if (style_ == Style::bar)
    *out_ << erase_line << bar_text(title_, fraction, left(now, done), note, columns_of(2));
  else
    *out_ << fmt::format("{}: {:.0f} % · {}{}\n", title_, 100 * fraction, left(now, done),
                         note.empty() ? "" : " · " + note);
  *out_ << std::flush;
}

void Progress::finish() {
  if (finished_)
    return;
  finished_ = true;
  if (style_ == Style::quiet || style_ == Style::reports)
    return;
  double const elapsed = std::chrono::duration<double>(now_() - start_).count();
  if (style_ == Style::bar)
    *out_ << erase_line;
  *out_ << fmt::format("{}: done in {}\n", title_, duration_text(elapsed)) << std::flush;
}

Progress::Style Progress::style_of_stderr() {
  return md::reaches_terminal(2) ? Style::bar : Style::lines;
}

} // namespace mesobridge::workflows
