#pragma once
#include <functional>
#include <string>

#include "experiments/run/run_folder.h"
#include "io/json/json.h"
#include "stages/render_stage.h"

namespace sturm {

/// The steps of one run in their order, with the time that they took (also when one was taken from an interrupted run).
class Steps {
 public:
  Steps(const RunFolder& folder, bool quiet) : folder_(folder), quiet_(quiet) {}

  /// The value that `make` gives, or gave before the run was interrupted. `name` is the step's file, `label` is what a
  /// reader of the progress sees.
  Json operator()(const std::string& name, const std::string& label,
                  const std::function<Json(const ProgressFunction&)>& make);

  /// Counts the time of work that keeps steps of its own.
  void add_seconds(double seconds) { seconds_ += seconds; }

  /// Seconds of all steps since the last call.
  double lap();

 private:
  const RunFolder& folder_;
  bool quiet_;
  double seconds_ = 0.0;
};

}  // namespace sturm
