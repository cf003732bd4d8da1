#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "compare/findings/measurement.h"
#include "io/specs/experiment/picture_measures.h"
#include "io/specs/prediction_spec.h"
#include "lensmodel/ray_model.h"

namespace sturm {

/// A number with its standard error.
struct Estimate {
  Number value, uncertainty;

  bool operator==(const Estimate&) const = default;
};

/// A metric of two pictures. One whose error is not estimated is written as a bare number.
struct PictureMetric {
  Number value{};
  bool has_error = false;
  Number uncertainty{};  ///< standard error
  Number degrees{};      ///< of freedom of it; none: as the replicates have it

  bool operator==(const PictureMetric&) const = default;
};

/// Metrics of the means of two halves of the path-traced pictures against each other: what noise alone makes of a
/// comparison with half of the samples each.
struct PictureNoiseFloor {
  std::map<std::string, Number> metrics;
  std::map<std::string, Number> uncertainties;  ///< standard errors; empty with fewer than four replicates

  Number of(const std::string& metric) const;
  bool operator==(const PictureNoiseFloor&) const = default;
};

/// Where a picture lies in the run folder.
struct PictureFiles {
  std::string exr, png;

  bool operator==(const PictureFiles&) const = default;
};

/// Errors of single predictions within a part of the picture, in display space.
struct PartErrors {
  std::string name;  ///< "whole" of the whole picture
  std::optional<std::uint64_t> pixels{};
  std::optional<Estimate> ssim{};  ///< none where no window's middle lies in the part
  Estimate rmse{}, mean_square{};
  Number reference_noise{};   ///< standard deviation of the path-traced mean
  Number prediction_noise{};  ///< of a single prediction
  Number share_of_squared_error{};

  bool operator==(const PartErrors&) const = default;
};

/// What a part of the picture contributes, each pixel counted once.
struct CauseShares {
  std::string name;
  std::optional<std::uint64_t> pixels{};
  Number squared_error{}, prediction_noise{}, similarity_loss{};

  bool operator==(const CauseShares&) const = default;
};

/// An error, and what of it is noise of either picture or the method's own. Parts may be negative by noise.
struct ErrorBudget {
  Number total{}, reference_noise{}, prediction_noise{}, method{};

  bool operator==(const ErrorBudget&) const = default;
};

/// A prediction of one kind against the path-traced pictures.
struct PredictionFinding {
  std::optional<PredictionKind> kind;
  SeenPsf psf = SeenPsf::Rays;  ///< of PredictionKind::DepthPsf
  bool layer_sum = false;       ///< of PredictionKind::DepthPsf: layers blurred and added, without one hiding another
  PictureFiles files;
  std::map<std::string, Number> seconds;         ///< by part of the work, with their "total"
  std::map<std::string, PictureMetric> metrics;  ///< of means over all replicates (PictureMeasures::Metrics)

  // PictureMeasures::Regions
  std::vector<PartErrors> parts;  ///< the whole picture first
  std::vector<CauseShares> causes;
  ErrorBudget similarity_loss, squared_error;  ///< of the latter the noise of the reference is taken off
  Number samples_of_equal_error;               ///< paths per pixel; none where the error is below the reference's noise
  Number times_faster, cost_in_paths, rmse_needed;

  PictureMetric metric(const std::string& name) const;  ///< without a value if there is none
  Number seconds_of(const std::string& part) const;
  PartErrors whole() const;  ///< without numbers if there is none
  /// As statistics have it: "depth_psf_waves" for waves, "depth_psf_sum" for the sum of layers; or "".
  std::string kind_name() const;
  bool operator==(const PredictionFinding&) const = default;
};

/// Path tracing of few and of all samples per pixel.
struct PathTracingCost {
  std::array<Number, 2> samples_per_pixel, seconds, rmse;
  Number order;  ///< variance ∝ n^−order; none where noise did not fall

  bool operator==(const PathTracingCost&) const = default;
};

/// One view, path traced by one ray model, and its predictions.
struct PictureFinding {
  PictureMeasures measures = PictureMeasures::Metrics;
  std::string id, scene;
  std::optional<RayModel> ray_model;
  Number pupil_mm;
  PictureFiles path_traced;
  Number seconds_path_traced;
  std::optional<std::uint64_t> samples_per_pixel;  ///< paths, of all replicates together
  std::optional<std::uint64_t> replicates;
  PictureNoiseFloor noise_floor;
  std::vector<PredictionFinding> predictions;

  // PictureMeasures::Metrics
  std::string prescription;  ///< id
  std::string same_view_as;  ///< IMAGE/RAY_MODEL whose path-traced pictures these are; "" where they are its own
  /// What a predictor with an error would have brought about, by the mutation's id.
  std::map<std::string, PictureFinding> mutated;

  // PictureMeasures::Regions
  std::string note, gaze;
  std::optional<bool> spectacles;
  std::array<std::optional<std::uint64_t>, 2> resolution;
  std::optional<std::uint64_t> sharp_samples_per_pixel;
  PathTracingCost cost;

  /// The only prediction of a picture with metrics; without numbers if there is none.
  PredictionFinding prediction() const;
  std::string model() const;  ///< name of the ray model, or ""
  bool operator==(const PictureFinding&) const = default;
};

}  // namespace sturm
