#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "pathtrace/cameras/camera_hits.h"
#include "pathtrace/film/render.h"
#include "pathtrace/scene/embree_rays.h"
#include "support/replicates.h"
#include "support/scenes.h"

namespace sturm {
namespace {

using Eigen::Vector3f;

/// Moments of an image about its centroid in tangent coordinates (x right, y up) [rad], image centre = 0.
struct Moments {
  double mass = 0.0;
  Eigen::Vector2d centroid = Eigen::Vector2d::Zero();
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();

  static Moments of(const Image& image, double pitch) {
    Moments m;
    Eigen::Matrix2d second = Eigen::Matrix2d::Zero();
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) {
        const double value = static_cast<double>(image.at(x, y)[0]);
        const Eigen::Vector2d at = pitch * Eigen::Vector2d(x + 0.5 - 0.5 * image.width, 0.5 * image.height - y - 0.5);
        m.mass += value;
        m.centroid += value * at;
        second += value * at * at.transpose();
      }
    m.centroid /= m.mass;
    m.covariance = second / m.mass - m.centroid * m.centroid.transpose();
    return m;
  }
};

/// One square emitter of side `side`, facing +z, centred at `center`; nothing else.
Scene square_emitter(const Vector3f& center, float side) {
  SceneDescription description;
  description.materials = {testing::lambertian(Vector3f::Zero(), Vector3f::Ones())};
  description.meshes = {
      testing::parallelogram(center - Vector3f(0.5f * side, 0.5f * side, 0), {side, 0, 0}, {0, side, 0}, 0)};
  return Scene(description);
}

CameraPose square_pose(int pixels, double half_slope) {
  CameraPose pose;
  pose.vertical_field = 2.0 * std::atan(half_slope);
  pose.width = pose.height = pixels;
  return pose;
}

RenderResult directly_seen(const Scene& scene, const EyeCamera& camera, int samples, std::uint64_t seed) {
  RenderSettings settings;
  settings.samples_per_pixel = samples;
  settings.max_bounces = 0;
  settings.seed = seed;
  return render(scene, camera, settings);
}

TEST(EyeCamera, UpAndRightInTheWorldIsUpAndRightInThePicture) {
  // Looking along −z, world x is to the right. The emitter is 0.3 m to the right and 0.2 m up at 1 m.
  const Scene scene = square_emitter({0.3f, 0.2f, -1.0f}, 0.02f);
  const CameraPose pose = square_pose(64, 0.5);
  const RenderResult result = directly_seen(scene, EyeCamera(pose, testing::pinhole_rays()), 256, 1);
  const Moments m = Moments::of(result.radiance, pixel_slope(pose));
  // The pixel box moves the centroid of a uniform square by nothing; sampling noise of 256 stratified points on 4
  // pixels.
  EXPECT_NEAR(m.centroid.x(), 0.3, 0.05 * pixel_slope(pose));
  EXPECT_NEAR(m.centroid.y(), 0.2, 0.05 * pixel_slope(pose));
  // By row and column: (0.3/0.5 · 32 + 32, 32 − 0.2/0.5 · 32) = (51.2, 19.2).
  EXPECT_GT(result.radiance.at(51, 19)[0], 0.5f);
  EXPECT_EQ(result.radiance.at(12, 19)[0], 0.0f);
  EXPECT_EQ(result.radiance.at(51, 44)[0], 0.0f);
  // The auxiliary layers know the same.
  EXPECT_NEAR(result.depth.at(51, 19)[0], 1.0f, 1e-5f);  // planar, not along the ray
  EXPECT_TRUE(std::isinf(result.depth.at(12, 19)[0]));
}

TEST(EyeCamera, RightIsLookCrossUp) {
  // Looking along +z from behind, world x is to the left.
  SceneDescription description;
  description.materials = {testing::lambertian(Vector3f::Zero(), Vector3f::Ones())};
  description.spheres = {{{0.3f, 0.2f, 1.0f}, 0.02f, 0}};
  CameraPose pose = square_pose(64, 0.5);
  pose.look_at = {0, 0, 5};
  const Moments m = Moments::of(
      directly_seen(Scene(description), EyeCamera(pose, testing::pinhole_rays()), 256, 1).radiance, pixel_slope(pose));
  EXPECT_NEAR(m.centroid.x(), -0.3, 0.1 * pixel_slope(pose));
  EXPECT_NEAR(m.centroid.y(), +0.2, 0.1 * pixel_slope(pose));
}

TEST(EyeCamera, ATiltedPoseKeepsUpUp) {
  CameraPose pose;
  pose.position = {1, 2, 3};
  pose.look_at = {1, 0, 1};
  pose.up = {0, 1, 0};
  const EyeCamera camera(pose, testing::pinhole_rays());
  EXPECT_NEAR(camera.forward().y(), -std::sqrt(0.5f), 1e-6f);
  EXPECT_GT(camera.slope_y(0.0f), 0.0f);
  EXPECT_LT(camera.slope_x(0.0f), 0.0f);
  EXPECT_NEAR(camera.slope_y(0.0f), std::tan(0.5 * pose.vertical_field), 1e-6);
}

TEST(EyeCamera, WideningKeepsThePitch) {
  const CameraPose pose = square_pose(64, 0.5);
  const CameraPose wide = widened(pose, 10, 3);
  EXPECT_EQ(wide.width, (64 + 20) * 3);
  EXPECT_EQ(wide.height, (64 + 20) * 3);
  EXPECT_NEAR(pixel_slope(wide), pixel_slope(pose) / 3.0, 1e-15);
}

// docs/theory.md#4-the-footprint-of-the-pupil and docs/theory.md#61-second-moments-in-closed-form: a point at distance
// d is seen under slopes q − V p, V = I/d + F − A·I. Its picture has the covariance a²/4 · M with M = V Vᵀ for the
// wavefront; the square emitter and the pixel box add side²/12 to each diagonal element.
struct BlurCase {
  RayModel model;
  double axis;
  double xx, xy, yy;  // M [D²], literal
};

// −1.00 −2.00 × AXIS, A = 0.25 D, d = 0.8 m: V = 0 along the axis and −2 D across it, so M = 4 u uᵀ with u at 60° (AXIS
// 30) or 120° (AXIS 150) in the wearer's frame; sin²: (5·0 + 4)/8 = 0.5 along the axis and (5·4)/8 = 2.5 across it.
constexpr double quarter_root_3 = 0.43301270189221932;
const BlurCase blur_cases[] = {{RayModel::power_matrix, 30.0, 1.0, 4 * quarter_root_3, 3.0},
                               {RayModel::power_matrix, 150.0, 1.0, -4 * quarter_root_3, 3.0},
                               {RayModel::sin2_radial, 30.0, 1.0, 2 * quarter_root_3, 2.0},
                               {RayModel::sin2_radial, 150.0, 1.0, -2 * quarter_root_3, 2.0},
                               {RayModel::thin_lens, 30.0, 1.0, 0.0, 1.0}};

TEST(EyeCamera, ThePictureOfAPointHasTheCovarianceOfItsEllipse) {
  const float side = 0.012f, distance = 0.8f;
  const Scene scene = square_emitter({0.02f, -0.01f, -distance}, side);
  const double radius = 0.02;
  const CameraPose pose = square_pose(48, 0.09);  // blur reaches 0.04 + 0.025 from the axis
  const double boxes = (std::pow(static_cast<double>(side / distance), 2) + std::pow(pixel_slope(pose), 2)) / 12.0;
  for (const BlurCase& c : blur_cases) {
    const Eye eye = Eye::with({-1.0, -2.0, c.axis, 0.0}, 2.0 * radius);
    const EyeCamera camera(pose, {c.model, eye, 0.25});
    std::vector<double> xx, xy, yy, cx, cy;
    for (std::uint64_t seed = 1; seed <= 16; ++seed) {
      const Moments m = Moments::of(directly_seen(scene, camera, 128, seed).radiance, pixel_slope(pose));
      xx.push_back(m.covariance(0, 0) - boxes);
      xy.push_back(m.covariance(0, 1));
      yy.push_back(m.covariance(1, 1) - boxes);
      cx.push_back(m.centroid.x());
      cy.push_back(m.centroid.y());
    }
    const auto check = [&](const std::vector<double>& replicates, double expected, double scale, const char* what) {
      const testing::Estimate e = testing::Estimate::of(replicates);
      // 4 standard errors; a ratio estimator's bias is far below. The noise must be small enough to see a 3 % error.
      EXPECT_NEAR(e.mean, expected, 4.0 * e.standard_error) << what << " " << name_of(c.model) << " axis " << c.axis;
      EXPECT_LT(4.0 * e.standard_error, 0.03 * scale) << what << " " << name_of(c.model) << " axis " << c.axis;
    };
    const double moment = 0.25 * radius * radius;
    check(xx, moment * c.xx, moment * 3.0, "xx");
    check(xy, moment * c.xy, moment * 3.0, "xy");
    check(yy, moment * c.yy, moment * 3.0, "yy");
    check(cx, 0.02 / 0.8, 0.01, "x");
    check(cy, -0.01 / 0.8, 0.01, "y");
  }
}

// Slope form has no focal point to go wrong: a hyperope's rays diverge and the picture is still a disc of radius a·|1/d
// + F|.
TEST(EyeCamera, AHyperopeIsNoSpecialCase) {
  const Scene scene = square_emitter({0, 0, -2.0f}, 0.02f);
  const CameraPose pose = square_pose(32, 0.1);
  const Eye eye = Eye::with({+2.0, 0.0, 180.0, 0.0}, 0.04);
  const Moments m = Moments::of(
      directly_seen(scene, EyeCamera(pose, {RayModel::power_matrix, eye, 0.0}), 2048, 1).radiance, pixel_slope(pose));
  const double boxes = (1e-4 + std::pow(pixel_slope(pose), 2)) / 12.0, expected = 0.25 * std::pow(0.02 * 2.5, 2);
  EXPECT_NEAR(m.covariance(0, 0) - boxes, expected, 0.02 * expected);  // 4σ of about 20 000 hits: 4 · 0.7/√N
  EXPECT_NEAR(m.covariance(1, 1) - boxes, expected, 0.02 * expected);
}

TEST(EyeCamera, DroppedRaysAreCountedAndLeftOut) {
  // −0.50 D focused at 2 m by metalstigmatism's formula is its pole: no ray leaves the eye, and the picture is black
  // but finite.
  const Scene scene = square_emitter({0, 0, -2.0f}, 5.0f);
  const Eye eye = Eye::with({-0.5, 0.0, 180.0, 0.0}, 0.04);
  const RenderResult result =
      directly_seen(scene, EyeCamera(square_pose(4, 0.1), {RayModel::metalstigmatism, eye, 0.0, 2.0}), 20, 1);
  EXPECT_EQ(result.counters.camera.launched, 4u * 4u * 20u);
  EXPECT_EQ(result.counters.camera.dropped, 4u * 4u * 20u);
  EXPECT_EQ(testing::image_mean(result.radiance, 0), 0.0);
  // −0.25 D: every ray counts as bent by a focus behind the eye, none is lost.
  const Eye weak = Eye::with({-0.25, 0.0, 180.0, 0.0}, 0.04);
  const RenderResult bent =
      directly_seen(scene, EyeCamera(square_pose(4, 0.1), {RayModel::metalstigmatism, weak, 0.0, 2.0}), 20, 1);
  EXPECT_EQ(bent.counters.camera.dropped, 0u);
  EXPECT_EQ(bent.counters.camera.negative_focus, 4u * 4u * 20u);
  EXPECT_EQ(testing::image_mean(bent.radiance, 0), 1.0);
}

TEST(HitPacket, ARayPassesByWhatComesBeforeItsStart) {
  SceneDescription description;
  description.materials = {testing::lambertian(Vector3f::Ones())};
  for (const float z : {-1.0f, -3.0f})
    description.meshes.push_back(testing::parallelogram({-1.0f, -1.0f, z}, {2, 0, 0}, {0, 2, 0}, 0));
  const Scene scene(description);
  HitPacket packet;
  const Vector3f towards(0.0f, 0.0f, -0.5f);  // a unit of t is half a metre
  const Vector3f origins[4] = {{0.1f, 0.1f, 0.0f}, {0.2f, 0.1f, 0.0f}, {0.3f, 0.1f, 0.0f}, {0.4f, 0.1f, 0.0f}};
  for (int lane = 0; lane < 4; ++lane) packet.set(lane, origins[lane], towards, lane != 3);
  packet.start_at(1, 2.5f);
  packet.start_at(2, 6.5f);
  packet.first_hits(scene.embree());
  ASSERT_TRUE(packet.hit(0) && packet.hit(1));
  EXPECT_FLOAT_EQ(packet.distance(0), 2.0f);
  EXPECT_FLOAT_EQ(packet.distance(1), 6.0f);
  EXPECT_FALSE(packet.hit(2));  // starts behind both
  EXPECT_FALSE(packet.hit(3));  // is not asked
  for (int lane = 4; lane < HitPacket::size; ++lane) EXPECT_FALSE(packet.hit(lane));
  packet.forget_hits();
  EXPECT_FALSE(packet.hit(0));
}

TEST(CameraHits, PacketsHitWhatSingleRaysHit) {
  const Scene scene = square_emitter({0.05f, 0, -1.0f}, 0.4f);
  const Eye eye = Eye::with({-1.0, -2.0, 30.0, 0.0}, 0.04);
  const EyeCamera camera(square_pose(16, 0.3), {RayModel::power_matrix, eye, 0.0});
  CameraHits hits;
  int hit = 0, missed = 0;
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x)
      for (int count : {16, 11, 8, 3}) {  // each after a fuller block, whose lanes must not shine through
        trace_camera_rays(scene, camera, x, y, 32, count, PixelSequence(Sequence::Sobol, 1, 1), hits);
        for (int i = 0; i < CameraRayBlock::size; ++i) {
          if (i >= count) {
            ASSERT_FALSE(hits.hit(i)) << count << " " << i;
            continue;
          }
          RTCRayHit single = ray_from(hits.origin(i), hits.direction(i));
          ASSERT_EQ(intersect(scene.embree(), single), hits.hit(i));
          (hits.hit(i) ? hit : missed)++;
          if (!hits.hit(i)) continue;
          ASSERT_EQ(single.hit.primID, hits.record(i).primID);
          ASSERT_NEAR(single.ray.tfar, hits.distance(i), 4e-7f);  // 3 ulp at 1 m
        }
      }
  EXPECT_GT(hit, 1000);
  EXPECT_GT(missed, 1000);
}

}  // namespace
}  // namespace sturm
