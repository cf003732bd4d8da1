#pragma once
#include <functional>
#include <optional>

#include "pathtrace/film/render.h"
#include "stages/stopwatch.h"

namespace sturm {

/// A picture that is shown while it grows.
struct Preview {
  std::function<void(const Image& radiance)> show;  ///< empty: nothing is shown
  double interval_s = 2.0;                          ///< at least so long between two pictures
};

/// Watches the clock between the passes of a rendering (RenderSettings::after_pass), from when it is made: shows
/// previews, and ends it before the pass that would go beyond a budget of time. The first pass is always made.
class PassWatch {
 public:
  PassWatch(std::optional<double> budget_s, Preview preview) : budget_s_(budget_s), preview_(std::move(preview)) {}

  /// Whether there is anything to watch.
  bool needed() const { return budget_s_ || preview_.show; }

  /// Returns whether another pass fits.
  bool operator()(const PassReport& report);

 private:
  std::optional<double> budget_s_;
  Preview preview_;
  Stopwatch total_;
  double passes_end_ = 0.0;           ///< when the pass before, and what followed it, was over [s]
  std::optional<double> last_shown_;  ///< [s]
};

}  // namespace sturm
