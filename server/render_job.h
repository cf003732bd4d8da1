#pragma once
#include <atomic>
#include <chrono>
#include <future>

#include "io/json/json.h"
#include "server/served_view.h"

namespace sturm {

/// A picture that is rendered in a thread of its own. Ending the job's life ends the rendering.
class RenderJob {
 public:
  explicit RenderJob(RenderRequest request);
  ~RenderJob();
  RenderJob(const RenderJob&) = delete;
  RenderJob& operator=(const RenderJob&) = delete;

  double progress() const { return progress_; }  ///< 0 … 1

  /// Whether it is over by then.
  bool over_within(std::chrono::milliseconds time) const {
    return outcome_.wait_for(time) == std::future_status::ready;
  }

  /// Waits for the end. {"picture": PNG as a data URI, "seconds", "notes", "comparison"}, where the comparison with the
  /// page's picture is null or {"ssim", "flip", "rmse_display", "flip_map"}; or {"error": message}.
  Json result() { return outcome_.get(); }

 private:
  std::atomic<double> progress_ = 0.0;
  std::atomic<bool> ended_ = false;
  std::future<Json> outcome_;
};

}  // namespace sturm
