#include "pathtrace/guide/emitter_guide.h"

#include <Eigen/SVD>
#include <algorithm>
#include <numbers>

#include "pathtrace/guide/pupil_guide.h"

namespace sturm {

namespace {

/// The bounding sphere and a little more: rays are not parallel to the line of sight, so they meet the sphere up to
/// 1/cos of the angle off the centre. What lies outside all the same is left to plain sampling.
constexpr float sphere_margin = 1.5f;

/// Emitters that are seen from more than this share of the pupil at a time are left to plain sampling.
constexpr float largest_pupil_share = 0.9f;

/// More than what single precision loses in a distance across the line of sight.
constexpr float rounding = 1.0f + 1e-4f;

}  // namespace

static_assert(PupilGuide<EmitterGuide>);

EmitterGuide::EmitterGuide(const Scene& scene, const EyeCamera& camera)
    : scene_(scene),
      camera_(camera),
      clusters_(scene.lights()),
      radius_(camera.rays().pupil_radius()),
      plain_pdf_(1.0f / (std::numbers::pi_v<float> * radius_ * radius_)),
      lens_of_cluster_(clusters_.clusters().size(), -1) {
  const float pupil_area = std::numbers::pi_v<float> * radius_ * radius_;
  if (!(pupil_area > 0.0f) || camera.rays().model() == RayModel::metalstigmatism) return;
  for (std::size_t k = 0; k < clusters_.clusters().size(); ++k) {
    const EmitterCluster& cluster = clusters_.clusters()[k];
    const Eigen::Vector3f local = camera.in_eye_frame(cluster.center);
    if (!(local.z() > 2.0f * cluster.radius) || !(cluster.luminance > 0.0f)) continue;  // behind the eye, or around it
    const Eigen::Matrix2f x = Eigen::Matrix2f::Identity() + local.z() * camera.rays().slope_matrix();
    const Eigen::JacobiSVD<Eigen::Matrix2f> svd(x, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Lens lens{static_cast<int>(k),
              local.head<2>(),
              local.z(),
              sphere_margin * cluster.radius,
              0.0f,
              cluster.luminance,
              svd.matrixU().col(0),
              svd.matrixU().col(1),
              svd.matrixV().col(0),
              svd.matrixV().col(1),
              svd.singularValues()};
    lens.farthest = rounding * (lens.sigma.norm() * radius_ + std::numbers::sqrt2_v<float> * lens.reach);
    // Seen from straight behind it.
    const PupilRectangle seen = rectangle(lens, lens.lateral.x() / lens.distance, lens.lateral.y() / lens.distance);
    if (!(seen.area() < largest_pupil_share * pupil_area)) continue;
    lens_of_cluster_[k] = static_cast<int>(lenses_.size());
    lenses_.push_back(lens);
  }
}

GuideUse EmitterGuide::use() const {
  if (!(radius_ > 0.0f)) return GuideUse::no_pupil;
  if (camera_.rays().model() == RayModel::metalstigmatism) return GuideUse::dropped_rays;
  return empty() ? GuideUse::no_small_emitter : GuideUse::in_use;
}

PupilRectangle EmitterGuide::rectangle(const Lens& lens, float qx, float qy, float widening) const {
  const Eigen::Vector2f offset = lens.lateral - lens.distance * Eigen::Vector2f(qx, qy);
  return PupilRectangle::that_reaches({lens.u1.dot(offset), lens.u2.dot(offset)}, lens.sigma, lens.reach + widening,
                                      radius_);
}

void EmitterGuide::find_targets(const EyeCamera::Pixel& pixel, std::vector<GuidedTarget>& targets) const {
  targets.clear();
  if (pixel.pinhole) return;
  const float qx = camera_.slope_x(static_cast<float>(pixel.x) + 0.5f),
              qy = camera_.slope_y(static_cast<float>(pixel.y) + 0.5f);
  const float diagonal = std::numbers::sqrt2_v<float> * (camera_.slope_x(1.0f) - camera_.slope_x(0.0f));
  float sum = 0.0f;
  for (const Lens& lens : lenses_) {
    const float dx = lens.lateral.x() - lens.distance * qx, dy = lens.lateral.y() - lens.distance * qy;
    const float farthest = lens.farthest + lens.distance * diagonal;
    if (dx * dx + dy * dy > farthest * farthest) continue;  // most are not even near
    const PupilRectangle r = rectangle(lens, qx, qy, 0.5f * lens.distance * diagonal);
    if (!(r.area() > 0.0f) || !r.meets_disc(radius_)) continue;
    const float expected = lens.luminance * r.area();
    targets.push_back({lens.cluster, expected});
    sum += expected;
  }
  for (GuidedTarget& target : targets) target.probability /= sum;
}

std::optional<PupilRegion> EmitterGuide::region(int cluster, const Place& place) const {
  const Lens& lens = lens_of(cluster);
  const PupilRegion region{rectangle(lens, place.qx, place.qy), lens.v1, lens.v2};
  return region.rectangle.area() > 0.0f ? std::optional(region) : std::nullopt;
}

std::optional<CameraRay> EmitterGuide::ray(const Place& place, const Eigen::Vector2f& point) const {
  if (point.squaredNorm() > radius_ * radius_) return std::nullopt;
  return camera_.single(place.pixel, {place.film, point.x(), point.y()});
}

}  // namespace sturm
