#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "io/specs/eye_spec.h"
#include "io/specs/ray_bundle_spec.h"
#include "io/specs/spectacles_spec.h"

namespace sturm {

/// A point to look at (docs/theory.md#32-gaze-models, `foveal` gaze).
struct Target {
  double azimuth = 0.0;     ///< to the wearer's right [rad], |.| ≤ 89°
  double elevation = 0.0;   ///< up [rad], |.| ≤ 89°
  double distance_m = 0.0;  ///< along the line of sight from the pupil's centre, with spectacles along the outgoing
                            ///< chief ray from the exit point [m]; > 0, ∞ allowed
};

/// A validated document of format sturm.ellipse/1.
struct EllipseQuery {
  Eye eye;
  std::optional<Spectacles> spectacles;  ///< none: the naked eye
  std::vector<Target> targets;
  std::vector<std::string> methods;  ///< "conoid", "rays:power_matrix", …
  RayBundleSpec rays;
  std::uint64_t seed = 1;
  std::vector<std::string> notes;        ///< for the manifest
  std::vector<std::string> input_files;  ///< absolute paths of further files that were read
};

/// Validates and reads a query; `file` names the document in errors and is where relative paths start. Throws
/// InputError.
EllipseQuery read_ellipse_query(const Json& document, const std::string& file);

}  // namespace sturm
