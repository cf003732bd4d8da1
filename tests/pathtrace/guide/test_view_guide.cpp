// Guided camera rays through spectacles, of eyes that turn, of measured wavefronts and other pupils: the mean is that
// of plain sampling, and the picture of a small light is that of the rays that a ray bundle finds.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "io/specs/spectacles_spec.h"
#include "pathtrace/cameras/camera_hits.h"
#include "pathtrace/film/render.h"
#include "pathtrace/guide/view_guide.h"
#include "pathtrace/sampling/across.h"
#include "support/lights_in_the_dark.h"
#include "support/quadrature.h"
#include "support/replicates.h"
#include "support/source_folder.h"

namespace sturm {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr double mm = 1e-3;
constexpr int size = 32;

CameraPose pose(double field = 0.12) {
  CameraPose p;
  p.vertical_field = field;
  p.width = p.height = size;
  return p;
}

Spectacles lens_file(const std::string& name) {
  const std::string file = STURM_SOURCE_DIR "/configs/lenses/" + name + ".json";
  return *read_lens_alone(load_json(file), {file, ""}).lens;
}

/// 12 mm below the fitting cross: the eye looks through the near zone, 4 mm from the corridor, where power and cylinder
/// change.
Spectacles progressive_off_axis() {
  Spectacles lens = lens_file("progressive_regular");
  lens.mounting = Mounting({4 * mm, 12 * mm}, 0.0, 0.0);
  return lens;
}

/// The rim's shadow cuts the pupil of 6 mm.
Spectacles narrow(Spectacles lens) {
  lens.diameter_m = 5 * mm;
  return lens;
}

/// A myope of 4√3·3.3 µm/a² = 2.54 D with 0.35 µm of coma over 6 mm: of a light at 1 m, beyond 0.77 of the radius the
/// curvature that makes the blur, 2.54 D − 1 D − 18√8·0.35 µm·r/a³ = 1.54 D − 1.98 D r/a, has changed its sign: two
/// pupil points see the same light.
Eye folded_eye() {
  std::vector<double> coefficients(13, 0.0);
  coefficients[4] = 3.3e-6;
  coefficients[7] = 0.35e-6;
  coefficients[9] = -0.08e-6;
  coefficients[12] = 0.05e-6;
  return Eye::with(ZernikeWave::from_examiner(coefficients, 3 * mm), SecondOrder::LeastSquares, {}, 6 * mm);
}

struct ViewCase {
  const char* name;
  Eye eye;
  RayModel model = RayModel::power_matrix;
  std::optional<Spectacles> spectacles = {};
  Gaze gaze = Gaze::Camera;
  PupilSamplingSpec sampling = {};
  double apodization = 0.0;
  double light_radius = 0.05 * mm;  ///< of the picture of a small light
  double largest_residual = 0.05;   ///< of the conoid, per distance and pupil radius [D]

  ViewOptions options(const Scene* scene = nullptr) const {
    ViewOptions o;
    o.gaze = gaze;
    o.spectacles = spectacles;
    o.pupil = PupilSampler(sampling, apodization);
    if (scene) o.distance_along = [scene](const LightRay& ray) { return distance_along(*scene, ray); };
    return o;
  }
};

Eye eye(const Prescription& rx, const Accommodation& accommodation = RelaxedAccommodation{}) {
  return Eye::with(rx, 6 * mm, accommodation);
}

// Made when they are first asked for: a lens takes 50 ms, and every test is a process of its own.
const ViewCase& toric() {
  static const ViewCase made{"toric lens", eye({-3.0, -4.5, 65.0}), RayModel::power_matrix,
                             lens_file("oblique_toric_p195")};
  return made;
}

const ViewCase& progressive() {
  static const ViewCase made{"progressive lens off its axis",
                             eye({-3.0}),
                             RayModel::power_matrix,
                             progressive_off_axis(),
                             Gaze::Camera,
                             {},
                             0.0,
                             0.3 * mm,
                             0.6};
  return made;
}

const ViewCase& focal_line() {
  static const ViewCase made{"focal line at 0.4 m", eye({-2.5, 4.0, 60.0}), RayModel::power_matrix, {}, Gaze::Foveal};
  return made;
}

const ViewCase& rim_cut() {
  static const ViewCase made{"pupil cut by the rim", eye({-3.0, -4.5, 65.0}), RayModel::power_matrix,
                             narrow(lens_file("oblique_toric_p195"))};
  return made;
}

const ViewCase& folded() {
  static const ViewCase made{"folded wavefront", folded_eye(), RayModel::zernike, {}, Gaze::Camera, {}, 0.0, 1.0 * mm};
  return made;
}

// Weights and densities of a pupil move light within its blur: the sum over the picture cannot see them.
const ViewCase& weighted_polar() {
  static const ViewCase made{"weighted polar pupil", eye({-3.0, -1.0, 30.0}),
                             RayModel::power_matrix, {},
                             Gaze::Camera,           {PupilSampling::UniformPolarWeighted}};
  return made;
}

const ViewCase& raw_polar() {
  static const ViewCase made{"polar pupil", eye({-3.0, -1.0, 30.0}),      RayModel::power_matrix, {},
                             Gaze::Camera,  {PupilSampling::UniformPolar}};
  return made;
}

std::vector<ViewCase> cases() {
  return {toric(),
          progressive(),
          focal_line(),
          rim_cut(),
          {"folded wavefront behind a lens, Stiles-Crawford",
           folded_eye(),
           RayModel::zernike,
           lens_file("oblique_astigmat"),
           Gaze::Camera,
           {},
           1.04},
          {"turning eye that accommodates behind a lens", eye({-3.0, -4.5, 65.0}, BestAccommodation{2.0}),
           RayModel::power_matrix, lens_file("oblique_toric_p195"), Gaze::Foveal},
          {"polar pupil",
           eye({-1.0, -3.0, 30.0}),
           RayModel::power_matrix,
           {},
           Gaze::Camera,
           {PupilSampling::UniformPolar},
           1.04},
          {"weighted polar pupil, sin² rays",
           eye({-1.0, -3.0, 30.0}),
           RayModel::sin2_radial,
           {},
           Gaze::Camera,
           {PupilSampling::UniformPolarWeighted}}};
}

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
  for (const ViewCase& c : cases()) {
    const GeneralCamera camera(pose(), c.eye, c.model, c.options(&scene));
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
    const int across = size / block;
    result.blocks.assign(static_cast<std::size_t>(across * across), 0.0);
    const double pixel = pixel_slope(pose(narrow_field));
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
        const Vector2d film(0.5 * size + q.x() / pixel, 0.5 * size - q.y() / pixel);
        if (film.minCoeff() < 0.0 || film.maxCoeff() >= size) continue;
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
    const GeneralCamera camera(pose(narrow_field), c.eye, c.model, c.options());
    const auto chief =
        camera.leaving(camera.sight_at(0.55 * size, 0.45 * size), {0.0, 0.0, 0.0, 0.0, LaunchStatus::ok});
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
      sums.push_back(testing::image_mean(image, 1) * size * size);
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
        rendered(scene, GeneralCamera(pose(), c.eye, c.model, c.options(&scene)), true, 16, 3).counters;
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
    return ViewGuide(scene, GeneralCamera(pose(), c.eye, c.model, c.options(&scene))).use();
  };
  EXPECT_EQ(use(toric()), GuideUse::in_use);
  EXPECT_EQ(use({"", eye({-3.0}), RayModel::pinhole}), GuideUse::no_pupil);
  EXPECT_EQ(use({"", Eye::with({-3.0}, 0.0)}), GuideUse::no_pupil);
  EXPECT_EQ(use({"", eye({-3.0}), RayModel::metalstigmatism}), GuideUse::dropped_rays);
  EXPECT_EQ(use({"", eye({-3.0}), RayModel::power_matrix, {}, Gaze::Camera, {PupilSampling::Rings}}),
            GuideUse::fixed_points);
  SceneDescription d = testing::lights_in_the_dark();
  d.meshes = {testing::parallelogram({1, -1, -4}, {-2, 0, 0}, {0, 2, 0}, 1)};  // most of the pupil sees it at a time
  d.spheres.clear();
  const Scene large(d);
  const GeneralCamera camera(pose(), toric().eye, toric().model, toric().options());
  EXPECT_EQ(ViewGuide(large, camera).use(), GuideUse::no_small_emitter);
  EXPECT_EQ(rendered(large, camera, true, 16, 1).radiance.pixels,
            rendered(large, camera, false, 16, 1).radiance.pixels);
  EXPECT_EQ(rendered(large, camera, false, 16, 1).guide_use, GuideUse::not_asked);
  EXPECT_EQ(rendered(scene, camera, true, 16, 1).guide_use, GuideUse::in_use);
}

TEST(ViewConoid, RaysPassWhereItSays) {
  for (const ViewCase& c : {toric(), progressive(), focal_line()}) {
    const GeneralCamera camera(pose(), c.eye, c.model, c.options());
    const PupilSlopes slopes = fitted_slopes(camera.rays());
    const ViewConoidField field(camera, slopes);
    const double film_x = 21.3, film_y = 9.8;  // between the corners
    const GeneralCamera::Sight sight = camera.sight_at(film_x, film_y);
    const auto chief = camera.leaving(sight, {0.0, 0.0, 0.0, 0.0, LaunchStatus::ok});
    ASSERT_TRUE(chief);
    const auto conoid = field.at(film_x, film_y);
    ASSERT_TRUE(conoid);
    const double distance = 2.0;
    for (const Vector2d& p :
         {Vector2d(2.1 * mm, 0.4 * mm), Vector2d(-0.7 * mm, 1.9 * mm), Vector2d(-1.5 * mm, -1.5 * mm)}) {
      const PupilRay<double> through = camera.rays().through(p.x(), p.y());
      const auto ray = camera.leaving(sight, through);
      ASSERT_TRUE(ray);
      const LightRay there{chief->at(distance), chief->direction};
      const Vector2d seen = offset_across(axes_across(*chief), there, *ray),
                     said = conoid->constant(distance) + conoid->by_point(distance) * p +
                            conoid->by_slope(distance) * Vector2d(through.sx, through.sy);
      // The residual was found with rays at the rim of the pupil, which are off most.
      EXPECT_LT((seen - said).norm(), conoid->offset_residual_m + distance * conoid->direction_residual + 1e-9)
          << c.name;
      EXPECT_LT(conoid->offset_residual_m + distance * conoid->direction_residual,
                c.largest_residual * 3 * mm * distance)
          << c.name;
    }
  }
}

TEST(PupilSlopes, OfSin2RaysByHand) {
  // s = P(φ) p with P = F₁cos² + F₂ sin² along the axes: 4 E[s pᵀ]/a² has (3F₁ + F₂)/4 and (F₁ + 3F₂)/4 on its
  // diagonal. AXIS 90 has the cylinder's power along x: F₁ = −4, F₂ = −1. The difference from it is a(F₁ − F₂)/4 at
  // most: along the axes, and between them.
  const PupilSlopes slopes =
      fitted_slopes(EyeRays<double>(RayModel::sin2_radial, Eye::with({-1.0, -3.0, 90.0, 0.0}, 6 * mm), 0.0));
  EXPECT_NEAR(slopes.matrix(0, 0), -3.25, 1e-12);
  EXPECT_NEAR(slopes.matrix(1, 1), -1.75, 1e-12);
  EXPECT_NEAR(slopes.matrix(0, 1), 0.0, 1e-12);
  EXPECT_NEAR(slopes.constant.norm(), 0.0, 1e-15);
  EXPECT_NEAR(slopes.residual, 3 * mm * 0.75, 1e-12);
}

TEST(PupilSampler, DensityAndWeightAreThoseOfItsPoints) {
  // The mean of weight × f over the unit square is the integral of density × weight × f over the disc.
  const auto f = [](const Vector2d& p) {
    return 1.0 + p.x() * p.x() + 0.5 * p.y() + 2.0 * p.squaredNorm() * p.squaredNorm();
  };
  for (const PupilSampling kind :
       {PupilSampling::UniformDisk, PupilSampling::UniformPolar, PupilSampling::UniformPolarWeighted})
    for (const double apodization : {0.0, 1.04}) {
      const PupilSampler sampler({kind}, apodization);
      constexpr int n = 400;
      double points = 0.0, integral = 0.0, total = 0.0;
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
          const double u = (i + 0.5) / n, v = (j + 0.5) / n, angle = 2.0 * std::numbers::pi * v;
          const WeightedPoint at = sampler.at(u, v);
          EXPECT_NEAR(sampler.weight(at.point), at.weight, 1e-12 * at.weight);
          points += at.weight * f(at.point) / (n * n);
          const Vector2d p = u * Vector2d(std::cos(angle), std::sin(angle));  // dA = 2π u du dv
          const double share = 2.0 * std::numbers::pi * u * sampler.density(p) / (n * n);
          integral += share * sampler.weight(p) * f(p);
          total += share;
        }
      EXPECT_NEAR(total, 1.0, 1e-5);  // midpoint rule, O(1/n²)
      EXPECT_NEAR(points, integral, 1e-4);
    }
}

}  // namespace
}  // namespace sturm
