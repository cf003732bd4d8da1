#pragma once
#include <emscripten/val.h>

#include <optional>
#include <string>

#include "lensmodel/eye.h"
#include "lensmodel/spectacles.h"

namespace sturm::viewer {

/// One eye and what it wears, as the page asks about them: `Optics` of viewer/src/core_module.d.ts, which has the
/// units, frames and shapes.
class Optics {
 public:
  void set_eye(const emscripten::val& numbers);
  void set_lens(const emscripten::val& numbers);

  emscripten::val correction() const;
  emscripten::val front_spline() const;
  emscripten::val accommodation(double azimuth, double elevation, double vergence_D) const;
  emscripten::val wavefront_slopes() const;

  emscripten::val field_analytic(const emscripten::val& grid) const;
  emscripten::val field_voxels(const emscripten::val& grid) const;

  emscripten::val ellipse(double azimuth, double elevation, double distance_m) const;
  emscripten::val errors(const emscripten::val& gazes_rad, double distance_m) const;
  emscripten::val clear_vision(double azimuth, double elevation, double limit_rad) const;
  emscripten::val gaze_at(const emscripten::val& camera, double x_px, double y_px) const;
  emscripten::val picture_ellipse(const emscripten::val& camera, double x_px, double y_px, double vergence_D) const;

  emscripten::val sights(const emscripten::val& grid) const;
  emscripten::val pixel_rays(const emscripten::val& camera, int x, int y, int width, int height,
                             const emscripten::val& vergences_D) const;
  emscripten::val ray_model(const std::string& model, double accommodation_D, double focus_distance_m,
                            const emscripten::val& points_m) const;

 private:
  const Spectacles* lens() const { return lens_ ? &*lens_ : nullptr; }

  Eye eye_;
  std::optional<Spectacles> lens_;
};

}  // namespace sturm::viewer
