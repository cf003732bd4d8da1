#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compare/studies/bench/curve.h"
#include "compare/studies/bench/reference_image.h"

namespace sturm {

/// The errors of a benchmark: what each is called, where it comes from, and what may be done with it.
struct ErrorKind {
  std::string_view name, title;
  double PictureErrors::*of;
  bool is_root;          ///< the error is the root of the measured number (whose expectation is what noise adds up in)
  bool floor_taken_off;  ///< the reference's noise can be subtracted without bias
};
extern const std::array<ErrorKind, 4> error_kinds;

/// The kind of this name. Throws std::invalid_argument.
const ErrorKind& error_kind(std::string_view name);

/// One rendering.
struct BenchSample {
  double seconds = 0.0;  ///< without loading the scene
  double samples = 0.0;  ///< camera rays of the whole picture
  PictureErrors errors;
};

/// All renderings of one setting, each with its own seed.
struct MeasuredSetting {
  std::string method;
  std::uint64_t samples_per_pixel = 0;  ///< as it was set
  std::vector<BenchSample> rounds;      ///< at least two
  std::string label;                    ///< what else sets it apart from the method's other settings
};

struct MeasuredView {
  std::string id;
  PictureErrors noise_floor;
  std::vector<MeasuredSetting> settings;
};

enum class FloorStatus {
  Clear,  ///< the reference's noise is at most half of what was measured
  Near,   ///< more than that: a better reference would change the value
  Below   ///< what is left after subtraction is not positive: no value
};

/// The error of a setting over its rounds.
struct ErrorEstimate {
  double raw = 0.0;             ///< as measured, the reference's noise included
  std::optional<double> value;  ///< with the noise floor taken off where the kind allows it
  std::optional<double>
      standard_error;  ///< of value, from the scatter of the rounds (for a root: of its square, to first order)
  FloorStatus status = FloorStatus::Clear;
};

ErrorEstimate estimate(const MeasuredSetting& setting, const PictureErrors& noise_floor, const ErrorKind& kind);

double median_seconds(const MeasuredSetting& setting);
double mean_samples(const MeasuredSetting& setting);

/// The points of one method and error, settings without a value left out; beside each what sets it apart.
struct MethodCurve {
  std::vector<CostPoint> points;
  std::vector<std::uint64_t> samples_per_pixel;
  std::vector<std::string> labels;
};
MethodCurve curve_of(const MeasuredView& view, std::string_view method, const ErrorKind& kind);

/// Squared error × seconds of a point: what does not depend on the number of samples where noise falls as their root.
/// The mean squared errors count as they are, the RMSE with its square; 1 − SSIM, too, grows with the square of little
/// noise.
double error_seconds(const CostPoint& point, const ErrorKind& kind);

}  // namespace sturm
