#pragma once
#include <cstdint>
#include <limits>
#include <optional>

#include "experiments/stress/family.h"
#include "experiments/stress/free_form.h"
#include "io/json/json.h"
#include "io/specs/ellipse_query.h"

namespace sturm::stress {

inline constexpr double flat = std::numeric_limits<double>::infinity();  ///< radius of a plane

/// One surface in the numbers of a document.
struct SurfaceNumbers {
  enum class Kind : std::uint8_t { sphere, torus, conic } kind = Kind::sphere;
  double radius_mm = flat;            ///< of a torus: of the sweep
  double generator_radius_mm = flat;  ///< torus only
  double sweep_meridian_deg = 0.0;    ///< torus only
  double conic_constant = 0.0;        ///< conic only

  bool operator==(const SurfaceNumbers&) const = default;
};

struct MountingNumbers {
  double right_mm = 0.0, up_mm = 0.0;  ///< decentration
  double pantoscopic_tilt_deg = 0.0, wrap_deg = 0.0;

  bool operator==(const MountingNumbers&) const = default;
};

/// A single-vision lens; only these can have a prism.
struct SingleVisionNumbers {
  double sphere_D = 0.0, cylinder_D = 0.0, axis_deg = 180.0, base_curve_D = 0.0;
  double prism_cm_per_m = 0.0, prism_base_deg = 0.0;
};

struct LensNumbers {
  SurfaceNumbers back, front;
  double center_thickness_mm = 2.0, refractive_index = 1.5, vertex_distance_mm = 12.0, diameter_mm = 70.0;
  MountingNumbers mounting;
  std::optional<SingleVisionNumbers> made;  ///< instead of back and front
  std::optional<int>
      free_form;  ///< instead of all but vertex distance and mounting: number of a lens in `FreeFormLenses`
};

/// A case in the numbers of a sturm.ellipse/1 document, so that replaying its document repeats it to the last bit.
struct CaseNumbers {
  Family family = Family::ordinary;
  double sphere_D = 0.0, cylinder_D = 0.0, axis_deg = 180.0, rx_vertex_distance_mm = 12.0;
  double pupil_diameter_mm = 4.0, rotation_center_mm = 13.5;
  enum class Mode : std::uint8_t { relaxed, fixed, best } mode = Mode::relaxed;
  double accommodation_D = 0.0;  ///< fixed: power; best: amplitude
  std::optional<LensNumbers> lens;
  double azimuth_deg = 0.0, elevation_deg = 0.0;
  double distance_m = 1.0;  ///< may be ∞
};

/// The eye of a case, none where the prescription's plane lies at a focal length, which a document is refused for.
std::optional<Eye> eye_of(const CaseNumbers& numbers);

/// The only place that knows the fields of `Spectacles`, as io reads them.
Spectacles spectacles_of(const LensNumbers& numbers, const FreeFormLenses& free_forms);

Eigen::Vector3d gaze_of(const CaseNumbers& numbers);

/// The case as a sturm.ellipse/1 document for the methods `conoid` and `conoid_published`.
Json query_json(const CaseNumbers& numbers, const FreeFormLenses& free_forms);

}  // namespace sturm::stress
