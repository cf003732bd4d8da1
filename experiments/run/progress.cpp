#include "experiments/run/progress.h"

#include <unistd.h>

#include <cmath>
#include <cstdio>

namespace sturm {

namespace {

std::string duration_text(double seconds) {
  char text[32];
  if (seconds < 60.0)
    std::snprintf(text, sizeof text, "%.1f s", seconds);
  else
    std::snprintf(text, sizeof text, "%d:%02d min", static_cast<int>(seconds) / 60, static_cast<int>(seconds) % 60);
  return text;
}

/// "3.9 M", "12 k", "250"
std::string count_text(double value) {
  char text[32];
  if (value >= 1e6)
    std::snprintf(text, sizeof text, "%.1f M", value / 1e6);
  else if (value >= 1e3)
    std::snprintf(text, sizeof text, "%.1f k", value / 1e3);
  else
    std::snprintf(text, sizeof text, "%.0f ", value);
  return text;
}

}  // namespace

Progress::Progress(std::string label, double units, std::string unit_name, bool quiet)
    : label_(std::move(label)),
      unit_name_(std::move(unit_name)),
      units_(units),
      quiet_(quiet),
      terminal_(isatty(STDERR_FILENO) != 0),
      start_(std::chrono::steady_clock::now()),
      last_shown_(start_) {}

Progress::~Progress() {
  if (bar_open_) std::fputc('\n', stderr);
}

double Progress::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

void Progress::update(double fraction) {
  if (quiet_) return;
  const std::lock_guard lock(mutex_);
  if (terminal_)
    show_bar(fraction);
  else
    show_line(fraction);
}

std::string Progress::pace(double fraction) const {
  const double elapsed = seconds();
  std::string text;
  if (units_ > 0.0 && elapsed > 0.0) text = count_text(fraction * units_ / elapsed) + unit_name_ + "/s, ";
  if (fraction >= 1.0) return text + duration_text(elapsed);
  return text + (fraction > 0.0 ? duration_text(elapsed * (1.0 - fraction) / fraction) + " left" : "starting");
}

void Progress::show_bar(double fraction) {
  const auto now = std::chrono::steady_clock::now();
  if (fraction < 1.0 && bar_open_ && now - last_shown_ < std::chrono::milliseconds(100)) return;
  last_shown_ = now;
  constexpr int width = 30;
  const int filled = static_cast<int>(std::lround(fraction * width));
  std::fprintf(stderr, "\r\033[K%s [%s%s] %3.0f %%  %s", label_.c_str(),
               std::string(static_cast<std::size_t>(filled), '#').c_str(),
               std::string(static_cast<std::size_t>(width - filled), ' ').c_str(), 100.0 * fraction,
               pace(fraction).c_str());
  std::fflush(stderr);
  bar_open_ = true;
}

void Progress::show_line(double fraction) {
  // Short work says only that it is done; long work speaks at every tenth, at most every two seconds.
  const int tenth = static_cast<int>(fraction * 10.0 + 1e-9);
  const auto now = std::chrono::steady_clock::now();
  const bool finished = tenth >= 10;
  if (tenth <= last_tenth_ || (!finished && now - last_shown_ < std::chrono::seconds(2))) return;
  last_tenth_ = tenth;
  last_shown_ = now;
  std::fprintf(stderr, "%s: %d %%, %s\n", label_.c_str(), 10 * tenth, pace(fraction).c_str());
}

}  // namespace sturm
