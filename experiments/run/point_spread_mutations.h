#pragma once
#include <optional>
#include <vector>

#include "experiments/run/mutations.h"
#include "io/specs/prediction_spec.h"
#include "stages/surfaces_picture.h"

namespace sturm {

/// Pictures that point spreads over depth have made by rays, with what they were made of.
struct PointSpreadPictures {
  Eye eye;
  double pixel_slope = 0.0;  ///< of the pictures, without oversampling
  PredictionSpec prediction;
  std::vector<SurfacesPicture> surfaces;  ///< of each picture
  std::vector<Image> predictions;
};

/// The pictures of the mutated predictor, from the surfaces of the honest one; none where the mutation is none of point
/// spreads over depth.
std::optional<std::vector<Image>> mutated_point_spreads(const Mutation& mutation, const PointSpreadPictures& honest);

}  // namespace sturm
