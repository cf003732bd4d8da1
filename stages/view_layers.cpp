#include "stages/view_layers.h"

#include <tbb/parallel_for.h>

#include <limits>

#include "conoid/pictures/lamp_reach.h"
#include "lensmodel/symmetric2.h"
#include "pathtrace/film/fragment_view.h"
#include "pathtrace/scene/embree_rays.h"

namespace sturm {

namespace {

/// A sharp view that knows where lamps are and is good for nothing else.
FragmentImage outlines(const Scene& scene, const SightField& field) {
  RenderSettings settings;
  settings.samples_per_pixel = 16;
  settings.max_bounces = 0;
  RenderCounters counters;
  const auto chief_rays = [&field](double x, double y) { return field.chief_ray({x, y}); };
  const PicturePlane& plane = field.plane();
  return render_fragments(scene, plane.width, plane.height, chief_rays, plane.pixel_slope, settings, counters);
}

}  // namespace

ViewLayers view_layers(const Scene& scene, const SightField& field) {
  const int width = field.plane().width, height = field.plane().height;
  ViewLayers layers{Image(width, height, 1), Image(width, height, 1), Image(width, height, 1),
                    lamp_reach(outlines(scene, field), 1, field)};
  tbb::parallel_for(0, height, [&](int y) {
    for (int x = 0; x < width; ++x) {
      const Eigen::Vector2d place(x + 0.5, y + 0.5);
      const Sight sight = field.at(place);
      *layers.depth.at(x, y) = std::numeric_limits<float>::infinity();
      if (!sight.reaches) continue;
      const Eigen::Vector3f origin = sight.origin.cast<float>(), direction = sight.direction.cast<float>();
      RTCRayHit ray = ray_from(origin, direction);
      double vergence = 0.0;
      if (intersect(scene.embree(), ray)) {
        *layers.depth.at(x, y) = ray.ray.tfar;
        vergence = 1.0 / static_cast<double>(ray.ray.tfar);
        const SurfacePoint point = scene.surface_point(ray.hit, origin, direction, ray.ray.tfar);
        *layers.specular.at(x, y) = std::holds_alternative<Diffuse>(point.material->surface) ? 0.0f : 1.0f;
      }
      const Eigen::Matrix2d map =
          SightNeighbourhood(field, place, sight).picture_map(field.slopes(sight, vergence), vergence);
      *layers.blur_px.at(x, y) = static_cast<float>(field.eye().pupil_radius_m * singular_values(map).large);
    }
  });
  return layers;
}

}  // namespace sturm
