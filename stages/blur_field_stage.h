#pragma once
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "conoid/blur_field/depth_analytic_field.h"
#include "conoid/blur_field/voxel_fill.h"
#include "io/json/json.h"
#include "io/specs/blur_field_spec.h"
#include "lensmodel/ellipse_layer.h"

namespace sturm {

/// A blur field and how it came about.
struct BlurField {
  FieldGrid grid;                              ///< places of lines of sight and distances
  TracedDirections directions;                 ///< the conoid of each line of sight
  std::optional<DepthAnalyticField> analytic;  ///< if the document asks for it
  std::optional<VoxelField> voxels;            ///< the same
  Json summary;  ///< sizes, counters and the interpolation error: what does not depend on the run
  std::map<std::string, double> seconds;  ///< wall-clock by part [s]
};

BlurField compute_blur_field(const BlurFieldSpec& spec);  ///< on all cores; the same bits for any number of threads

/// The conoids of all lines of sight of a blur field alone.
TracedDirections field_directions(const BlurFieldSpec& spec);

/// The ellipses of all lines of sight at the distances of the spec ([Kakimoto2010] fig. 12). Each stands where its
/// chief ray goes, on the picture plane; `best` accommodation is that of each ellipse.
std::vector<EllipseLayer> ellipse_layers(const BlurFieldSpec& spec, const TracedDirections& directions);

}  // namespace sturm
