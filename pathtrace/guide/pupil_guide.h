#pragma once
#include <concepts>
#include <optional>
#include <vector>

#include "pathtrace/cameras/camera_concept.h"
#include "pathtrace/guide/guided_target.h"
#include "pathtrace/guide/pupil_region.h"

namespace sturm {

/// What tells a camera's pixels where in the pupil they see small bright emitters. It is made once for a scene and a
/// camera, which must outlive it, and never changes. It may be wrong about where an emitter is seen: that costs
/// efficiency. It may not be wrong about densities.
///
/// Pupil points are in metres, densities per area of the pupil [1/m²].
///
/// - `use()`, `empty()`: whether there is anything to guide, and why not.
/// - `find_targets(pixel, targets)`: the emitters that may be seen in a pixel; their probabilities sum to 1.
/// - `place(pixel, film)`: a place of the picture as the guide sees it; none where no guided ray can start.
/// - `region(cluster, place)`: the pupil points that are proposed for an emitter there; none where no point is expected
///   to see it.
/// - `ray(place, point)`: the camera's ray through a pupil point; none where the point is outside of the pupil.
/// - `plain_weight(point)`: the weight that plain sampling gives to a sample there.
/// - `share_of_plain(guided_pdf, point)`: π_plain/(π_plain + guided_pdf) at a point, π_plain the density of plain
///   sampling.
template <class G>
concept PupilGuide = Camera<typename G::Camera> &&
    requires(const G& guide, const typename G::Camera::Pixel& pixel, const typename G::Camera::FilmPlace& film,
             const typename G::Place& place, int cluster, float pdf, const Eigen::Vector2f& point,
             std::vector<GuidedTarget>& targets) {
  { guide.use() } -> std::same_as<GuideUse>;
  { guide.empty() } -> std::same_as<bool>;
  { guide.scene() } -> std::same_as<const Scene&>;
  { guide.camera() } -> std::same_as<const typename G::Camera&>;
  { guide.clusters() } -> std::same_as<const EmitterClusters&>;
  { guide.find_targets(pixel, targets) } -> std::same_as<void>;
  { guide.place(pixel, film) } -> std::same_as<std::optional<typename G::Place>>;
  { guide.region(cluster, place) } -> std::same_as<std::optional<PupilRegion>>;
  { guide.ray(place, point) } -> std::same_as<std::optional<CameraRay>>;
  { guide.plain_weight(point) } -> std::same_as<float>;
  { guide.share_of_plain(pdf, point) } -> std::same_as<float>;
};

}  // namespace sturm
