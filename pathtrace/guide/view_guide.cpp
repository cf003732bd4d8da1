#include "pathtrace/guide/view_guide.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lensmodel/symmetric2.h"
#include "pathtrace/guide/pupil_guide.h"
#include "pathtrace/sampling/across.h"

namespace sturm {

namespace {

/// The bounding sphere and a little more: for what the interpolated conoid does not know. What lies outside all the
/// same is left to plain sampling.
constexpr double conoid_margin = 1.15;

/// Emitters that are seen from more than this share of the pupil at a time are left to plain sampling.
constexpr double largest_guided_share = 0.9;

Eigen::Vector2d quarter_turned(const Eigen::Vector2d& v) {
  return {-v.y(), v.x()};
}

}  // namespace

static_assert(PupilGuide<ViewGuide>);

ViewGuide::ViewGuide(const Scene& scene, const GeneralCamera& camera)
    : scene_(scene),
      camera_(camera),
      radius_(camera.rays().pupil_radius()),
      clusters_(scene.lights()),
      slopes_(fitted_slopes(camera.rays())) {
  if (!(radius_ > 0.0))
    use_ = GuideUse::no_pupil;
  else if (camera.rays().model() == RayModel::metalstigmatism)
    use_ = GuideUse::dropped_rays;
  else if (!camera.pupil().has_density())
    use_ = GuideUse::fixed_points;
  else if (clusters_.clusters().empty())
    use_ = GuideUse::no_small_emitter;
  if (empty()) return;
  conoids_.emplace(camera, slopes_);
  if (!worth_it_somewhere()) use_ = GuideUse::no_small_emitter;
}

std::optional<ViewGuide::Place> ViewGuide::place(const GeneralCamera::Pixel& pixel,
                                                 const GeneralCamera::FilmPlace& film) const {
  const auto conoid = conoids_->at(film.x(), film.y());
  if (!conoid) return std::nullopt;
  Place place{camera_.place(pixel, film), {}, {}, *conoid, slopes_.matrix};
  const auto chief = camera_.leaving(place.camera.sight, {0.0, 0.0, 0.0, 0.0, LaunchStatus::ok});
  if (!chief) return std::nullopt;
  place.chief = *chief;
  place.across = axes_across(*chief);
  place.slope_matrix -= place.camera.accommodation_change * Eigen::Matrix2d::Identity();
  return place;
}

std::optional<ViewGuide::Aspect> ViewGuide::aspect(int index, const Place& place) const {
  const EmitterCluster& cluster = clusters_.clusters()[static_cast<std::size_t>(index)];
  const Eigen::Vector3d way = camera_.in_head(place.camera.sight, cluster.center.cast<double>()) - place.chief.origin;
  const double distance = way.dot(place.chief.direction), radius = static_cast<double>(cluster.radius);
  if (!(distance > 2.0 * radius) || !(cluster.luminance > 0.0f)) return std::nullopt;  // behind the eye, or around it
  const Eigen::Matrix2d by_slope = place.conoid.by_slope(distance);
  return Aspect{place.conoid.by_point(distance) + by_slope * place.slope_matrix,
                place.across * way - place.conoid.constant(distance) - by_slope * slopes_.constant, distance,
                conoid_margin * radius + place.conoid.offset_residual_m + distance * place.conoid.direction_residual +
                    singular_values(by_slope).large * slopes_.residual};
}

PupilRegion ViewGuide::region_of(const Aspect& aspect, const Eigen::Vector2d& lateral, double reach) const {
  const Eigen::Matrix2d square = aspect.x.transpose() * aspect.x;
  const Eigen::Vector2d v1 = principal_values(square(0, 0), square(0, 1), square(1, 1)).high_direction,
                        v2 = quarter_turned(v1), image = aspect.x * v1;
  const double large = image.norm();
  const Eigen::Vector2d u1 = large > 0.0 ? Eigen::Vector2d(image / large) : Eigen::Vector2d(1.0, 0.0);
  const double small = quarter_turned(u1).dot(aspect.x * v2);  // with its sign: X may mirror
  const Eigen::Vector2d u2 = (small < 0.0 ? -1.0 : 1.0) * quarter_turned(u1);
  return {PupilRectangle::that_reaches({static_cast<float>(u1.dot(lateral)), static_cast<float>(u2.dot(lateral))},
                                       {static_cast<float>(large), static_cast<float>(std::abs(small))},
                                       static_cast<float>(reach), static_cast<float>(radius_)),
          v1.cast<float>(), v2.cast<float>()};
}

std::optional<PupilRegion> ViewGuide::region(int cluster, const Place& place) const {
  const auto seen = aspect(cluster, place);
  return seen ? region_within(*seen, 0.0) : std::nullopt;
}

std::optional<PupilRegion> ViewGuide::region_within(const Aspect& aspect, double widening) const {
  const double reach = aspect.reach + widening;
  if (aspect.lateral.norm() > aspect.x.norm() * radius_ + std::numbers::sqrt2 * reach)
    return std::nullopt;  // most are not even near
  const PupilRegion region = region_of(aspect, aspect.lateral, reach);
  if (!(region.rectangle.area() > 0.0f) || !region.rectangle.meets_disc(static_cast<float>(radius_)))
    return std::nullopt;
  return region;
}

bool ViewGuide::worth_it(const Aspect& aspect) const {
  const double area = static_cast<double>(region_of(aspect, Eigen::Vector2d::Zero(), aspect.reach).rectangle.area());
  return area < largest_guided_share * std::numbers::pi * radius_ * radius_;
}

/// Looks along the chief rays of the conoids' corners, with an eye that seeks focus relaxed and tense, at each
/// cluster's distance as if it were straight ahead.
bool ViewGuide::worth_it_somewhere() const {
  const auto* best = std::get_if<BestAccommodation>(&camera_.eye().accommodation);
  for (const EmitterCluster& cluster : clusters_.clusters()) {
    if (!(cluster.luminance > 0.0f)) continue;
    const double distance = (cluster.center.cast<double>() - camera_.position()).norm();
    for (const auto& conoid : conoids_->corners()) {
      if (!conoid) continue;
      for (const double change : {0.0, best ? best->amplitude_D : 0.0}) {
        const Eigen::Matrix2d slopes = slopes_.matrix - change * Eigen::Matrix2d::Identity();
        if (worth_it({conoid->by_point(distance) + conoid->by_slope(distance) * slopes,
                      {},
                      distance,
                      conoid_margin * static_cast<double>(cluster.radius)}))
          return true;
      }
    }
  }
  return false;
}

void ViewGuide::find_targets(const GeneralCamera::Pixel& pixel, std::vector<GuidedTarget>& targets) const {
  targets.clear();
  // An eye that seeks focus may find it at another distance in a corner of the pixel.
  std::vector<Place> places;
  for (const Eigen::Vector2d& at : {Eigen::Vector2d(0.5, 0.5), {0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}, {1.0, 1.0}}) {
    if (const auto there = place(pixel, {pixel.x + at.x(), pixel.y + at.y()})) places.push_back(*there);
    if (!camera_.seeks_focus()) break;
  }
  // Half a diagonal of the pixel, and half as much again for spectacles that magnify; 50 mm for an eye that turns about
  // its centre.
  const double half_diagonal = 1.5 * 0.5 * std::numbers::sqrt2 * camera_.pixel_angle();
  constexpr double turning = 50e-3;
  float sum = 0.0f;
  for (int k = 0; k < static_cast<int>(clusters_.clusters().size()); ++k) {
    float expected = 0.0f;
    for (const Place& at : places) {
      const auto seen = aspect(k, at);
      if (!seen) continue;
      const auto there = region_within(*seen, half_diagonal * (seen->distance + turning));
      if (there && worth_it(*seen))
        expected =
            std::max(expected, clusters_.clusters()[static_cast<std::size_t>(k)].luminance * there->rectangle.area());
    }
    if (!(expected > 0.0f)) continue;
    targets.push_back({k, expected});
    sum += expected;
  }
  for (GuidedTarget& target : targets) target.probability /= sum;
}

std::optional<CameraRay> ViewGuide::ray(const Place& place, const Eigen::Vector2f& point) const {
  if ((point.cast<double>() / radius_).squaredNorm() > 1.0) return std::nullopt;
  return camera_.through(place.camera, static_cast<double>(point.x()), static_cast<double>(point.y()));
}

float ViewGuide::plain_weight(const Eigen::Vector2f& point) const {
  return static_cast<float>(camera_.pupil().weight(point.cast<double>() / radius_));
}

float ViewGuide::share_of_plain(float guided_pdf, const Eigen::Vector2f& point) const {
  const auto plain_pdf =
      static_cast<float>(camera_.pupil().density(point.cast<double>() / radius_) / (radius_ * radius_));
  return 1.0f / (1.0f + guided_pdf / plain_pdf);  // the plain density may be infinite
}

}  // namespace sturm
