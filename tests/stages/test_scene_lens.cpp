// A real toric glass in somebody else's renderer: tests/reference/scene_lens, seen through the same lens by this path
// tracer, and its bulbs' ellipses as the conoid predicts them. The reference's two seeds differ by 0.05 % in the mean,
// 0.5 % in the near bulb's semi-axes, 2 % in the middle one's.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <nlohmann/json.hpp>

#include "conoid/tracing/spectacle_conoid.h"
#include "lensmodel/ellipse.h"
#include "lensmodel/gaze.h"
#include "stages/plan/camera_pose.h"
#include "stages/render_stage.h"
#include "support/reference_file.h"
#include "support/source_folder.h"
#include "support/spot_moments.h"

namespace sturm {
namespace {

using testing::Rectangle;
using testing::SpotMoments;

Json view_document() {
  return Json::parse(R"({
    "format": "sturm.render/1",
    "scene": {"models": [{"file": "scene.obj", "texture_encoding": "linear", "texture_filter": "nearest"}]},
    "camera": {"position_m": [0.278, 0.273, -0.8], "look_at_m": [0.278, 0.273, 0], "vfov_deg": 39.3077, "resolution": [256, 256]},
    "eye": {"prescription": {"sphere_D": 0, "vertex_distance_mm": 0}, "pupil_diameter_mm": 12,
            "accommodation": {"mode": "fixed", "power_D": 0.9523809523809523}},
    "spectacles": {"vertex_distance_mm": 12, "center_thickness_mm": 3, "refractive_index": 1.5,
                   "front": {"type": "torus", "sweep_radius_mm": 100, "generator_radius_mm": 75, "sweep_meridian_deg": 30},
                   "back": {"type": "sphere", "radius_mm": 80}},
    "method": {"type": "path_trace", "ray_model": "power_matrix", "samples_per_pixel": 64}
  })");
}

RenderSpec view_spec(std::uint64_t seed) {
  Json document = view_document();
  document["seed"] = seed;
  return read_render_spec(document, STURM_SOURCE_DIR "/tests/reference/scene_lens/view.json");
}

/// Mean of 4 pictures of 64 samples each. Between such means the middle bulb's semi-axes scatter by 0.6 %, the far
/// one's by 1 % and its orientation by 1.5°.
const Image& our_picture() {
  static const Image picture = [] {
    Image sum(256, 256, 3);
    constexpr int seeds = 4;
    for (int seed = 1; seed <= seeds; ++seed) {
      const RenderOutput output = render_view(view_spec(static_cast<std::uint64_t>(seed)), {});
      EXPECT_EQ(output.counters["lost_rim_rays"], 0);
      EXPECT_EQ(output.counters["lost_tir_rays"], 0);
      const Image& one = output.image.layers.at("");
      for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 256; ++x)
          for (int k = 0; k < 3; ++k) sum.at(x, y)[k] += one.at(x, y)[k] / seeds;
    }
    return sum;
  }();
  return picture;
}

/// What shines, seen directly: no noise of the background in the spots.
const Image& our_emitters() {
  static const Image picture = [] {
    RenderSpec spec = view_spec(1);
    spec.max_bounces = 0;
    spec.samples_per_pixel = 512;
    return render_view(spec, {}).image.layers.at("");
  }();
  return picture;
}

struct Bulb {
  std::string name;
  Eigen::Vector3d center;
};
const Bulb near_bulb{"near", {0.2, 0.3, -0.25}}, middle_bulb{"middle", {0.15, 0.4, 0.25}},
    far_bulb{"far", {0.08, 0.48, 0.53}};
constexpr double bulb_radius = 3e-3;

/// 5 % of the far bulb's semi-axes, 2.37 and 1.69 px, are 10 % of its moments and turn it by 0.1·ab/(a² − b²) = 0.14.
constexpr double far_degrees = 8.0;

Rectangle rectangle_of(const Json& spot) {
  const Json& r = spot["rectangle"];
  return {r[0], r[1], r[2], r[3]};
}

Eigen::Matrix2d reference_covariance(const std::string& bulb) {
  Eigen::Matrix2d mean = Eigen::Matrix2d::Zero();
  const Json file = testing::reference_file("scene_lens/statistics.json");
  for (const Json& seed : file["seeds"]) {
    const Json& c = seed["spots"][bulb]["covariance"];
    mean += 0.5 * (Eigen::Matrix2d() << c[0].get<double>(), c[1].get<double>(), c[1].get<double>(), c[2].get<double>())
                      .finished();
  }
  return mean;
}

void expect_same_ellipse(const Eigen::Matrix2d& a, const Eigen::Matrix2d& b, double relative, double degrees,
                         const std::string& what) {
  const Ellipse x = Ellipse::of_second_moments(a), y = Ellipse::of_second_moments(b);
  EXPECT_NEAR(x.semi_major / y.semi_major, 1.0, relative) << what;
  EXPECT_NEAR(x.semi_minor / y.semi_minor, 1.0, relative) << what;
  EXPECT_NEAR(std::remainder(*x.orientation_deg - *y.orientation_deg, 180.0), 0.0, degrees) << what;
  std::printf("%s: semi-axes %.4f %.4f at %.2f against %.4f %.4f at %.2f\n", what.c_str(), x.semi_major, x.semi_minor,
              *x.orientation_deg, y.semi_major, y.semi_minor, *y.orientation_deg);
}

TEST(SlowSceneLens, MeanAndBulbsAreTheReferences) {
  const Json file = testing::reference_file("scene_lens/statistics.json");
  for (int k = 0; k < 3; ++k) {
    double ours = 0.0;
    for (int y = 0; y < 256; ++y)
      for (int x = 0; x < 256; ++x) ours += static_cast<double>(our_picture().at(x, y)[k]) / (256.0 * 256.0);
    const double theirs =
        0.5 * (file["seeds"][0]["channel_means"][k].get<double>() + file["seeds"][1]["channel_means"][k].get<double>());
    EXPECT_NEAR(ours / theirs, 1.0, 0.005) << "channel " << k;
    std::printf("channel %d: ratio of means %.5f\n", k, ours / theirs);
  }
  // The far bulb lights the wall 3 cm behind it, which is no even background for it and for the middle one: there whole
  // pictures are compared.
  for (const auto& [bulb, relative, degrees] : {std::tuple(near_bulb, 0.02, 1.5), std::tuple(middle_bulb, 0.02, 1.5),
                                                std::tuple(far_bulb, 0.05, far_degrees)}) {
    const Json& spot = file["seeds"][0]["spots"][bulb.name];
    const SpotMoments ours = SpotMoments::of(bulb.name == "near" ? our_emitters() : our_picture(), rectangle_of(spot));
    expect_same_ellipse(ours.covariance_px, reference_covariance(bulb.name), relative, degrees, bulb.name);
    EXPECT_NEAR(ours.centroid_px.x(), spot["centroid"][0].get<double>(), 0.1) << bulb.name;
    EXPECT_NEAR(ours.centroid_px.y(), spot["centroid"][1].get<double>(), 0.1) << bulb.name;
  }
}

/// What the conoid makes of a bulb in the picture of an eye that looks straight ahead, in px². A ray leaves the pupil
/// at (p, 0) along (c + S p, −1). Across its chief ray N ∝ (c, −1) it has the offset D₀p and the direction D₁(c + S p),
/// so at the bulb it is off by P D₀ p + Q D₁(S p + δc); it hits the bulb's point b where δc = G (b − P D₀ p) − S p with
/// G = (Q D₁)⁻¹. Pupil and bulb are uniform discs.
Eigen::Matrix2d predicted_covariance(const Bulb& bulb, const RenderSpec& spec) {
  const Eigen::Vector3d target((0.278 - bulb.center.x()), bulb.center.y() - 0.273,
                               -(bulb.center.z() + 0.8));  // looking along +z: x flips
  Eigen::Vector3d gaze = target.normalized();
  SpectacleConoid conoid;
  for (int step = 0; step < 20; ++step) {  // prism: look so that the chief ray behind the lens meets the bulb
    conoid = trace_conoid(*spec.eye.spectacles, gaze, 0.0);
    gaze = (gaze + (target - conoid.chief_ray.origin).normalized() - conoid.chief_ray.direction).normalized();
  }
  const double distance = (target - conoid.chief_ray.origin).norm();
  const Eigen::Matrix3d across = smallest_rotation({0.0, 0.0, -1.0}, gaze);
  const Eigen::Matrix2d d0 =
      [&] {  // along the ray onto the plane across it: an offset in the pupil keeps its part across N
        Eigen::Matrix2d m;
        m << across.col(0).x(), across.col(0).y(), across.col(1).x(), across.col(1).y();
        return m;
      }();
  const double planar = -gaze.z();  // N = planar·(c, −1): a change of slope δc changes N across itself by planar·D₀ δc
  const Eigen::Matrix2d d1 = planar * d0;
  const Eigen::Matrix2d p = distance * conoid.angular_p(1.0 / distance),
                        q = distance * conoid.angular_q(1.0 / distance);
  const Eigen::Matrix2d g = (q * d1).inverse();
  const Eigen::Matrix2d slopes = spec.eye.eye.slope_matrix(spec.eye.eye.accommodation_for(0.0)).matrix();
  const Eigen::Matrix2d by_pupil = g * p * d0 + slopes;
  const Eigen::Matrix2d covariance =
      covariance_of_disc_image(by_pupil, spec.eye.eye.pupil_radius_m) + covariance_of_disc_image(g, bulb_radius);
  return covariance / std::pow(pixel_slope(camera_pose(spec.camera)), 2);
}

TEST(SlowSceneLens, TheConoidPredictsTheEllipses) {
  const RenderSpec spec = view_spec(1);
  const Json file = testing::reference_file("scene_lens/statistics.json");
  expect_same_ellipse(predicted_covariance(near_bulb, spec), reference_covariance("near"), 0.02, 1.5,
                      "near, reference");
  // Of the other two the picture of the emitters alone: the reference's background is not even there.
  for (const auto& [bulb, relative, degrees] :
       {std::tuple(middle_bulb, 0.02, 1.5), std::tuple(far_bulb, 0.05, far_degrees)}) {
    const SpotMoments ours = SpotMoments::of(our_emitters(), rectangle_of(file["seeds"][0]["spots"][bulb.name]));
    expect_same_ellipse(predicted_covariance(bulb, spec), ours.covariance_px, relative, degrees, bulb.name);
  }
}

}  // namespace
}  // namespace sturm
