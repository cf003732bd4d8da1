// Guided camera rays through spectacles, of eyes that turn, of measured wavefronts and other pupils: the mean is that
// of plain sampling, and the picture of a small light is that of the rays that a ray bundle finds.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "pathtrace/film/render.h"
#include "pathtrace/guide/view_cases.h"
#include "pathtrace/guide/view_guide.h"
#include "pathtrace/sampling/across.h"
#include "support/lights_in_the_dark.h"
#include "support/quadrature.h"
#include "support/replicates.h"
#include "support/units.h"

namespace sturm {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::Vector3f;
using testing::focal_line;
using testing::folded;
using testing::mm;
using testing::progressive;
using testing::raw_polar;
using testing::rim_cut;
using testing::toric;
using testing::view_cases;
using testing::view_eye;
using testing::view_pose;
using testing::view_size;
using testing::ViewCase;
using testing::weighted_polar;

RenderResult rendered(const Scene& scene, const GeneralCamera& camera, bool guided, int samples, std::uint64_t seed,
                      int bounces = 0) {
  RenderSettings settings;
  settings.samples_per_pixel = samples;
  settings.max_bounces = bounces;
  settings.seed = seed;
  settings.guide_emitters = guided;
  return render(scene, camera, settings);
}

/// Means over blocks of `block` × `block` pixels of one channel.
std::vector<double> block_means(const Image& image, int channel, int block) {
  const int across = image.width / block;
  std::vector<double> means(static_cast<std::size_t>(across * across), 0.0);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      means[static_cast<std::size_t>(y / block * across + x / block)] +=
          static_cast<double>(image.at(x, y)[channel]) / (block * block);
  return means;
}

/// One Estimate for each block from many runs.
template <class Run>
std::vector<testing::Estimate> estimates(int replicates, Run&& run) {
  std::vector<std::vector<double>> values;
  for (int r = 0; r < replicates; ++r) {
    const std::vector<double> means = run(r);
    values.resize(means.size());
    for (std::size_t b = 0; b < means.size(); ++b) values[b].push_back(means[b]);
  }
  std::vector<testing::Estimate> result;
  for (const auto& v : values) result.push_back(testing::Estimate::of(v));
  return result;
}

TEST(ViewGuide, SlowTheSameMeanAsPlainSampling) {
  const Scene scene(
      testing::lights_in_the_dark(10.0f));  // large enough for plain sampling to have a normal distribution
  constexpr int replicates = 16, block = 8;
  for (const ViewCase& c : view_cases()) {
    const GeneralCamera camera(view_pose(), c.eye, c.model, c.options(&scene));
    const auto plain = estimates(replicates, [&](int r) {
      return block_means(rendered(scene, camera, false, 256, 100 + r, 1).radiance, 0, block);
    });
    const auto guided = estimates(replicates, [&](int r) {
      return block_means(rendered(scene, camera, true, 48, 900 + r, 1).radiance, 0, block);
    });
    double squares = 0.0;
    int blocks = 0;
    for (std::size_t b = 0; b < plain.size(); ++b) {
      const double error = std::hypot(plain[b].standard_error, guided[b].standard_error),
                   difference = guided[b].mean - plain[b].mean;
      // Welch's t with at least 15 degrees of freedom: |t| > 6.5 has a probability of 1e-5, 128 tests together 0.1 %.
      EXPECT_LE(std::abs(difference), 6.5 * error + 1e-7) << c.name << " block " << b;
      if (!(error > 1e-7)) continue;
      squares += difference * difference / (error * error);
      ++blocks;
    }
    // t² has the mean 15/13 and at most the variance 3.3 with 15 degrees of freedom; five standard deviations.
    EXPECT_LE(squares, blocks * 15.0 / 13.0 + 5.0 * std::sqrt(3.3 * blocks)) << c.name;
  }
}

constexpr double narrow_field = 0.03;

/// A light of radius R at `at` as the rays of a pupil find it: for each pupil point the chief slope whose ray passes a
/// place of its disc, by Newton's method on refracted rays.
struct PictureOfRays {
  std::vector<double> blocks;  ///< means over the picture's blocks, for radiance 1
  double sum = 0.0;            ///< over the pixels
};

class RayBundleOracle {
 public:
  RayBundleOracle(const ViewCase& c, const Vector3d& at)
      : rays_(c.model, c.eye, 0.0),
        at_(at),
        lens_(c.spectacles),
        open_(c.spectacles),
        raw_polar_(c.sampling.kind == PupilSampling::UniformPolar) {
    if (open_) open_->diameter_m = 60 * mm;
  }

  PictureOfRays picture(double light_radius, int block) const {
    PictureOfRays result;
    const int across = view_size / block;
    result.blocks.assign(static_cast<std::size_t>(across * across), 0.0);
    const double pixel = pixel_slope(view_pose(narrow_field));
    constexpr int radial = 160, azimuthal = 480;
    double index = 0.0;
    for (const testing::Node& node : testing::gauss_legendre_unit(radial))
      for (int k = 0; k < azimuthal; ++k) {
        const double angle = 2.0 * std::numbers::pi * (k + 0.5) / azimuthal;
        const Vector2d p =
            3 * mm * (raw_polar_ ? node.x : std::sqrt(node.x)) * Vector2d(std::cos(angle), std::sin(angle));
        // A place of the light's disc, spread by two irrational steps.
        ++index;
        const double where = std::fmod(0.754877666246693 * index, 1.0),
                     around = std::fmod(0.569840290998053 * index, 1.0) * 2.0 * std::numbers::pi;
        const Vector2d aim = light_radius * std::sqrt(where) * Vector2d(std::cos(around), std::sin(around));
        Vector2d q = at_.head<2>() / -at_.z();
        for (int i = 0; i < 5; ++i) q -= jacobian(p, q).inverse() * (miss(p, q, open_) - aim);
        if (lens_ && trace(*lens_, launched(p, q)).status != LensStatus::ok) continue;
        const double area = std::numbers::pi * light_radius * light_radius / std::abs(jacobian(p, q).determinant());
        const double value = node.weight / azimuthal * area / (pixel * pixel);
        result.sum += value;
        const Vector2d film(0.5 * view_size + q.x() / pixel, 0.5 * view_size - q.y() / pixel);
        if (film.minCoeff() < 0.0 || film.maxCoeff() >= view_size) continue;
        const int bx = static_cast<int>(film.x()) / block, by = static_cast<int>(film.y()) / block;
        result.blocks[static_cast<std::size_t>(by * across + bx)] += value / (block * block);
      }
    return result;
  }

 private:
  LightRay launched(const Vector2d& p, const Vector2d& q) const {
    const PupilRay<double> ray = rays_.through(p.x(), p.y());
    return {{p.x(), p.y(), 0.0}, Vector3d(ray.sx + q.x(), ray.sy + q.y(), -1.0).normalized()};
  }

  /// By how much the ray misses the light, across the ray [m].
  Vector2d miss(const Vector2d& p, const Vector2d& q, const std::optional<Spectacles>& lens) const {
    LightRay ray = launched(p, q);
    if (lens) ray = trace(*lens, ray).exit;
    const Vector3d w = ray.origin - at_, across = w - w.dot(ray.direction) * ray.direction;
    return smallest_rotation({0.0, 0.0, -1.0}, ray.direction).leftCols<2>().transpose() * across;
  }

  Eigen::Matrix2d jacobian(const Vector2d& p, const Vector2d& q) const {
    constexpr double h = 1e-5;
    Eigen::Matrix2d j;
    for (int k = 0; k < 2; ++k)
      j.col(k) = (miss(p, q + h * Vector2d::Unit(k), open_) - miss(p, q - h * Vector2d::Unit(k), open_)) / (2.0 * h);
    return j;
  }

  EyeRays<double> rays_;
  Vector3d at_;
  std::optional<Spectacles> lens_, open_;
  bool raw_polar_;  ///< radii are uniform; the other pupils are uniform over the area
};

TEST(ViewGuide, SlowThePictureOfASmallLightIsThatOfItsRays) {
  constexpr int replicates = 24, block = 2, samples = 32;
  constexpr double luminance = 1e6;
  for (const ViewCase& c : {toric(), progressive(), rim_cut(), folded(), weighted_polar(), raw_polar()}) {
    const GeneralCamera camera(view_pose(narrow_field), c.eye, c.model, c.options());
    const auto chief =
        camera.leaving(camera.sight_at(0.55 * view_size, 0.45 * view_size), {0.0, 0.0, 0.0, 0.0, LaunchStatus::ok});
    ASSERT_TRUE(chief);
    const Vector3d at = chief->at(1.0);  // in the middle of the picture, whatever the prism of the lens
    SceneDescription d;
    d.materials = {testing::lambertian(Vector3f::Zero(), Vector3f::Constant(static_cast<float>(luminance)))};
    d.spheres = {{at.cast<float>(), static_cast<float>(c.light_radius), 0}};
    const Scene scene(d);
    const PictureOfRays expected = RayBundleOracle(c, at).picture(c.light_radius, block);
    std::vector<double> sums;
    const auto blocks = estimates(replicates, [&](int r) {
      const Image image = rendered(scene, camera, true, samples, 40 + r).radiance;
      sums.push_back(testing::image_mean(image, 1) * view_size * view_size);
      return block_means(image, 1, block);
    });
    // Everything that the pupil lets through is in the picture, to the scatter of the runs and 1e-3: the oracle's rays
    // are counted in or out at a rim, 1/160 of the pupil's area for a ring and 1/480 for an angle, to the power 3/2 of
    // their number.
    const testing::Estimate sum = testing::Estimate::of(sums);
    EXPECT_NEAR(sum.mean, luminance * expected.sum, 5.0 * sum.standard_error + 1e-3 * luminance * expected.sum)
        << c.name;
    EXPECT_LT(sum.standard_error, 0.02 * sum.mean) << c.name;
    double squares = 0.0;
    int used = 0;
    for (std::size_t b = 0; b < blocks.size(); ++b) {
      const double there = luminance * expected.blocks[b];
      if (there < 1e-2 * luminance * expected.sum / static_cast<double>(blocks.size()) && blocks[b].mean == 0.0)
        continue;
      // The oracle's 77 000 points fall into the blocks like a lattice: to about one part in the number of rings and
      // angles across it.
      const double counting = 0.02 * there + 2e-4 * luminance * expected.sum / (block * block);
      EXPECT_NEAR(blocks[b].mean, there, 6.0 * blocks[b].standard_error + 3.0 * counting) << c.name << " block " << b;
      squares += std::pow(blocks[b].mean - there, 2) / (std::pow(blocks[b].standard_error, 2) + counting * counting);
      ++used;
    }
    // t² with 23 degrees of freedom has the mean 23/21 and the variance 2.6: five standard deviations.
    EXPECT_LE(squares, used * 23.0 / 21.0 + 5.0 * std::sqrt(2.6 * used)) << c.name << ", " << used << " blocks";
    EXPECT_GE(used, 9) << c.name;
  }
}

TEST(ViewGuide, ItsRaysMeetTheirEmitters) {
  // One sphere seen whole: the rectangle is 1.15 times as wide as what sees the sphere, which fills π/4 of it: at best
  // 0.59 of the rays hit. Aberrations widen it, the pupil's rim cuts it, and pixels at the blur's rim propose what they
  // cannot see.
  SceneDescription d;
  d.materials = {testing::lambertian(Vector3f::Zero(), Vector3f::Constant(1e4f))};
  d.spheres = {{{0.003f, -0.004f, -1.0f}, 0.0008f, 0}};
  const Scene scene(d);
  const auto share = [&](const ViewCase& c) {
    const RenderCounters n =
        rendered(scene, GeneralCamera(view_pose(), c.eye, c.model, c.options(&scene)), true, 16, 3).counters;
    return static_cast<double>(n.guided_hits) / static_cast<double>(n.guided_rays);
  };
  EXPECT_GT(share(toric()), 0.35);
  EXPECT_GT(share(progressive()), 0.05);  // 2 mrad of aberrations beside a light of 0.8 mrad
  EXPECT_GT(share(focal_line()), 0.35);
  EXPECT_GT(share(rim_cut()), 0.25);
  EXPECT_GT(share(folded()), 0.01);  // 2.5 mrad of aberrations: hardly more than plain sampling has
}

TEST(ViewGuide, SaysWhetherItIsInUseAndWhyNot) {
  const Scene scene(testing::lights_in_the_dark());
  const auto use = [&](const ViewCase& c) {
    return ViewGuide(scene, GeneralCamera(view_pose(), c.eye, c.model, c.options(&scene))).use();
  };
  EXPECT_EQ(use(toric()), GuideUse::in_use);
  EXPECT_EQ(use({"", view_eye({-3.0}), RayModel::pinhole}), GuideUse::no_pupil);
  EXPECT_EQ(use({"", Eye::with({-3.0}, 0.0)}), GuideUse::no_pupil);
  EXPECT_EQ(use({"", view_eye({-3.0}), RayModel::metalstigmatism}), GuideUse::dropped_rays);
  EXPECT_EQ(use({"", view_eye({-3.0}), RayModel::power_matrix, {}, Gaze::Camera, {PupilSampling::Rings}}),
            GuideUse::fixed_points);
  SceneDescription d = testing::lights_in_the_dark();
  d.meshes = {testing::parallelogram({1, -1, -4}, {-2, 0, 0}, {0, 2, 0}, 1)};  // most of the pupil sees it at a time
  d.spheres.clear();
  const Scene large(d);
  const GeneralCamera camera(view_pose(), toric().eye, toric().model, toric().options());
  EXPECT_EQ(ViewGuide(large, camera).use(), GuideUse::no_small_emitter);
  EXPECT_EQ(rendered(large, camera, true, 16, 1).radiance.pixels,
            rendered(large, camera, false, 16, 1).radiance.pixels);
  EXPECT_EQ(rendered(large, camera, false, 16, 1).guide_use, GuideUse::not_asked);
  EXPECT_EQ(rendered(scene, camera, true, 16, 1).guide_use, GuideUse::in_use);
}

}  // namespace
}  // namespace sturm
