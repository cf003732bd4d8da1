#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "io/specs/camera_spec.h"
#include "io/specs/eye_spec.h"
#include "io/specs/scene_spec.h"
#include "io/specs/spectacles_spec.h"
#include "lensmodel/field_method.h"

namespace sturm {

/// A scene and where the eye stands in it.
struct VisibleSceneSpec {
  SceneSpec scene;         ///< what may be seen
  LineOfSight sight;       ///< of primary gaze, world
  int looks_per_cell = 8;  ///< rows and columns of looks into each cell of the field
};

/// A validated document of format sturm.blurfield/1.
struct BlurFieldSpec {
  Eye eye;                                             ///< whose blur it is
  std::optional<Spectacles> spectacles;                ///< none: the naked eye
  double hfov = 0.0, vfov = 0.0;                       ///< full fields of view [rad], in (0, π)
  int nx = 32, ny = 32, nz = 256;                      ///< lines of sight to the right and down, and distances; ≥ 2
  double near_vergence_D = 4.0, far_vergence_D = 0.0;  ///< 1/distance of the first and last slice [D], near > far
  bool voxels = true, depth_analytic = true;  ///< the forms that are made: a map for each voxel, one for each direction
  FieldMethod method = FieldMethod::ray_transfer;  ///< how voxels are computed
  std::optional<VisibleSceneSpec> visible;  ///< voxels in which nothing of it is seen are left out; none: all are made
  bool skip_rim = true, skip_symmetry = true, skip_empty_voxels = true;  ///< what need not be computed
  std::vector<double> layers_m;                                          ///< > 0, ∞ allowed
  std::vector<std::string> notes, input_files;  ///< for the manifest; absolute paths of further files
  std::shared_ptr<const Json> resolved;         ///< the document with every default spelt out
};

/// Validates and reads a blur field document; `file` names it in errors and is where relative paths start. Throws
/// InputError.
BlurFieldSpec read_blur_field_spec(const Json& document, const std::string& file);

}  // namespace sturm
