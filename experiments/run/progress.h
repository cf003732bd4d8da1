#pragma once
#include <chrono>
#include <mutex>
#include <string>

namespace sturm {

/// Tells on stderr how far a piece of work is: a bar with rate and time left on a terminal, a plain line every tenth
/// otherwise, nothing when quiet. Thread-safe.
class Progress {
 public:
  /// `units` is what the work counts (e.g. samples), for the rate; 0 shows no rate.
  Progress(std::string label, double units, std::string unit_name, bool quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void update(double fraction);
  double seconds() const;

 private:
  void show_bar(double fraction);
  void show_line(double fraction);
  std::string pace(double fraction) const;

  std::string label_, unit_name_;
  double units_;
  bool quiet_, terminal_;
  std::mutex mutex_;
  std::chrono::steady_clock::time_point start_, last_shown_;
  int last_tenth_ = -1;
  bool bar_open_ = false;
};

}  // namespace sturm
