#pragma once
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "io/specs/eye_spec.h"
#include "io/specs/ray_bundle_spec.h"
#include "io/specs/spectacles_spec.h"
#include "lensmodel/ray_model.h"
#include "lensmodel/words.h"

namespace sturm {

/// A point to look at (docs/theory.md#32-gaze-models, `foveal` gaze).
struct Target {
  double azimuth = 0.0;     ///< to the wearer's right [rad], |.| ≤ 89°
  double elevation = 0.0;   ///< up [rad], |.| ≤ 89°
  double distance_m = 0.0;  ///< along the line of sight from the pupil's centre, with spectacles along the outgoing
                            ///< chief ray from the exit point [m]; > 0, ∞ allowed
};

/// How a blur ellipse is computed without tracing rays.
enum class ConoidMethod {
  conoid,            ///< first order along the chief ray, exact
  conoid_published,  ///< [Kakimoto2010] eqs. 9–12
  previous           ///< [Kakimoto2010] Table 1
};

inline constexpr Words<ConoidMethod, 3> conoid_method_words{{{ConoidMethod::conoid, "conoid"},
                                                             {ConoidMethod::conoid_published, "conoid_published"},
                                                             {ConoidMethod::previous, "previous"}}};  ///< in documents

/// How a blur ellipse is found: by a conoid, or measured on rays.
using EllipseMethod = std::variant<ConoidMethod, RayModel>;

/// The word for it in documents: "conoid", "rays:power_matrix", …
std::string name_of(const EllipseMethod& method);

/// A validated document of format sturm.ellipse/1.
struct EllipseQuery {
  Eye eye;                               ///< who looks
  std::optional<Spectacles> spectacles;  ///< none: the naked eye
  std::vector<Target> targets;           ///< in the order of the document
  std::vector<EllipseMethod> methods;    ///< each answers for every target
  RayBundleSpec rays;                    ///< of the methods that measure on rays
  std::uint64_t seed = 1;                ///< of their random numbers
  std::vector<std::string> notes;        ///< for the manifest
  std::vector<std::string> input_files;  ///< absolute paths of further files that were read
};

/// Validates and reads a query; `file` names the document in errors and is where relative paths start. Throws
/// InputError.
EllipseQuery read_ellipse_query(const Json& document, const std::string& file);

}  // namespace sturm
