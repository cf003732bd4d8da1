#include "pathtrace/cameras/general_camera.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "lensmodel/best_accommodation.h"
#include "lensmodel/gaze.h"
#include "pathtrace/sampling/across.h"

namespace sturm {

namespace {

LaunchStatus status_of(LensStatus status) {
  switch (status) {
    case LensStatus::ok:
      return LaunchStatus::ok;
    case LensStatus::missed_lens:
      return LaunchStatus::lost_rim;
    case LensStatus::total_internal_reflection:
      return LaunchStatus::lost_total_reflection;
    default:
      return LaunchStatus::lost_no_convergence;
  }
}

/// Axes of a head that has turned to the right by `longitude` and then up by `latitude`.
Eigen::Matrix3d turned_head(double longitude, double latitude) {
  return (Eigen::AngleAxisd(-longitude, Eigen::Vector3d::UnitY()) *
          Eigen::AngleAxisd(latitude, Eigen::Vector3d::UnitX()))
      .toRotationMatrix();
}

constexpr PupilRay<double> chief_ray{0.0, 0.0, 0.0, 0.0, LaunchStatus::ok};

double accommodation_at_rest(const Eye& eye) {
  return std::holds_alternative<BestAccommodation>(eye.accommodation) ? 0.0 : eye.accommodation_for(0.0);
}

}  // namespace

static_assert(Camera<GeneralCamera>);

GeneralCamera::GeneralCamera(const CameraPose& pose, const Eye& eye, RayModel model, ViewOptions options)
    : pose_(pose),
      eye_(eye),
      rays_(model, eye, accommodation_at_rest(eye),
            eye.stated_focus_distance_m().value_or(std::numeric_limits<double>::infinity())),
      options_(std::move(options)),
      seeks_focus_(std::holds_alternative<BestAccommodation>(eye.accommodation)),
      pixel_slope_(pixel_slope(pose)),
      world_from_head_(head_axes(pose)) {
  if (options_.projection == Projection::Equirectangular && options_.gaze == Gaze::Foveal)
    throw std::invalid_argument("an eye cannot turn to the whole sphere");
  if (seeks_focus_ && !options_.distance_along)
    throw std::invalid_argument("an eye that accommodates best needs distances");
}

Eigen::Vector3d GeneralCamera::in_world(const Sight& sight, const Eigen::Vector3d& point) const {
  return pose_.position + sight.world_from_head * (point + options_.sideways_m * Eigen::Vector3d::UnitX());
}

Eigen::Vector3d GeneralCamera::in_head(const Sight& sight, const Eigen::Vector3d& world) const {
  return sight.world_from_head.transpose() * (world - pose_.position) - options_.sideways_m * Eigen::Vector3d::UnitX();
}

double GeneralCamera::pixel_angle() const {
  if (options_.projection == Projection::Perspective) return pixel_slope_;
  return std::max(2.0 * std::numbers::pi / pose_.width, std::numbers::pi / pose_.height);
}

GeneralCamera::Sight GeneralCamera::sight_at(double px, double py) const {
  Sight sight{world_from_head_, Eigen::Vector3d::Zero(), Eigen::Matrix3d::Identity(), Eigen::Vector2d::Zero()};
  if (options_.projection == Projection::Equirectangular) {
    const double longitude = (px / pose_.width - 0.5) * 2.0 * std::numbers::pi,
                 latitude = (0.5 - py / pose_.height) * std::numbers::pi;
    sight.world_from_head = world_from_head_ * turned_head(longitude, latitude);
    return sight;
  }
  const Eigen::Vector2d slope((px - 0.5 * pose_.width) * pixel_slope_, (0.5 * pose_.height - py) * pixel_slope_);
  if (options_.gaze == Gaze::Camera) {
    sight.slope = slope;
    return sight;
  }
  const Eigen::Vector3d gaze = Eigen::Vector3d(slope.x(), slope.y(), -1.0).normalized();
  sight.pupil_center = turned_pupil_center(gaze, eye_.rotation_center_m);
  sight.turn = smallest_rotation({0.0, 0.0, -1.0}, gaze);
  return sight;
}

/// The ray before the eye or before the spectacles, head frame. False where it is lost.
bool GeneralCamera::launch(const Sight& sight, const PupilRay<double>& ray, LightRay& out, LaunchStatus& status) const {
  out = sight.in_head(ray);
  if (!options_.spectacles) return true;
  const LensPath path = trace(*options_.spectacles, out);
  if (path.status != LensStatus::ok) {
    status = status_of(path.status);
    return false;
  }
  out = path.exit;
  return true;
}

std::optional<LightRay> GeneralCamera::leaving(const Sight& sight, const PupilRay<double>& ray) const {
  LaunchStatus status = LaunchStatus::ok;
  LightRay out;
  return launch(sight, ray, out, status) ? std::optional(out) : std::nullopt;
}

GeneralCamera::Bundle GeneralCamera::bundle_about(const Sight& sight) const {
  if (!options_.spectacles) return {};
  const auto chief = leaving(sight, chief_ray);
  return chief ? differences(sight, *chief) : Bundle{};
}

GeneralCamera::Bundle GeneralCamera::differences(const Sight& sight, const LightRay& chief) const {
  Bundle bundle;
  constexpr double step = 1e-4;
  LaunchStatus status = LaunchStatus::ok;
  const Eigen::Matrix<double, 2, 3> across = axes_across(chief);
  for (int k = 0; k < 4; ++k) {
    const Eigen::Vector2d e = step * Eigen::Vector2d::Unit(k % 2), p = k < 2 ? e : Eigen::Vector2d::Zero(), s = e - p;
    LightRay ahead, behind;
    if (!launch(sight, {p.x(), p.y(), s.x(), s.y(), status}, ahead, status)) continue;
    if (!launch(sight, {-p.x(), -p.y(), -s.x(), -s.y(), status}, behind, status)) continue;
    (k < 2 ? bundle.offset_by_point : bundle.offset_by_slope).col(k % 2) =
        (offset_across(across, chief, ahead) - offset_across(across, chief, behind)) / (2.0 * step);
    (k < 2 ? bundle.direction_by_point : bundle.direction_by_slope).col(k % 2) =
        across * (ahead.direction - behind.direction) / (2.0 * step);
  }
  return bundle;
}

/// By how much the eye accommodates to what its line of sight meets [D].
double GeneralCamera::accommodation_change(const Sight& sight, const Bundle& bundle) const {
  const auto chief = leaving(sight, chief_ray);
  if (!chief) return 0.0;
  const LightRay world{in_world(sight, chief->origin), sight.world_from_head * chief->direction};
  const double vergence = 1.0 / options_.distance_along(world);
  const double amplitude = std::get<BestAccommodation>(eye_.accommodation).amplitude_D;
  if (!options_.spectacles) return eye_.accommodation_for(vergence);
  const Eigen::Matrix2d by_point = vergence * bundle.offset_by_point + bundle.direction_by_point,
                        by_slope = vergence * bundle.offset_by_slope + bundle.direction_by_slope;
  return best_accommodation(by_point + by_slope * eye_.correction.matrix(), by_slope, amplitude);
}

GeneralCamera::Pixel GeneralCamera::pixel(int x, int y) const {
  return {x, y, seeks_focus_ ? bundle_about(sight_at(x + 0.5, y + 0.5)) : Bundle{}};
}

GeneralCamera::Place GeneralCamera::place(const Pixel& pixel, const FilmPlace& film) const {
  Place place{sight_at(film.x(), film.y())};
  if (seeks_focus_) place.accommodation_change = accommodation_change(place.sight, pixel.focus_bundle);
  return place;
}

GeneralCamera::SamplePlace GeneralCamera::place_of(const Pixel& pixel, std::uint32_t sample,
                                                   const PixelSequence& sequence) const {
  const owen_sobol::Pair film = sequence.pair(sample, dimension::film), lens = sequence.pair(sample, dimension::lens);
  return {film_place(pixel, film), options_.pupil.at(unit_double(lens.x), unit_double(lens.y))};
}

CameraRay GeneralCamera::through(const Place& place, double px, double py) const {
  const bool planar = options_.projection == Projection::Perspective && options_.gaze == Gaze::Camera;
  PupilRay<double> ray = rays_.through(px, py);
  if (seeks_focus_) {
    ray.sx -= place.accommodation_change * ray.px;
    ray.sy -= place.accommodation_change * ray.py;
  }
  LaunchStatus status = ray.status;
  LightRay out{Eigen::Vector3d::Zero(), -Eigen::Vector3d::UnitZ()};
  if (goes_on(ray.status)) launch(place.sight, ray, out, status);
  // Rays that leave spectacles at more than 89.9° from the line of sight keep their length.
  const double length = planar && -out.direction.z() > 1.7e-3 ? -1.0 / out.direction.z() : 1.0;
  return {in_world(place.sight, out.origin).cast<float>(),
          (length * (place.sight.world_from_head * out.direction)).cast<float>(), status};
}

CameraRay GeneralCamera::single(const Pixel& pixel, const SamplePlace& at) const {
  return through(place(pixel, at.film), rays_.pupil_radius() * at.pupil.point.x(),
                 rays_.pupil_radius() * at.pupil.point.y());
}

void GeneralCamera::generate(int x, int y, std::uint32_t first_sample, const PixelSequence& sequence,
                             CameraRayBlock& block) const {
  const Pixel shared = pixel(x, y);
  for (int i = 0; i < CameraRayBlock::size; ++i) {
    const SamplePlace at = place_of(shared, first_sample + static_cast<std::uint32_t>(i), sequence);
    const CameraRay ray = single(shared, at);
    block.status[i] = ray.status;
    block.weight[i] = static_cast<float>(rays_.model() == RayModel::pinhole ? 1.0 : at.pupil.weight);
    for (int k = 0; k < 3; ++k) {
      block.origin[k][i] = ray.origin[k];
      block.direction[k][i] = ray.direction[k];
    }
  }
}

}  // namespace sturm
