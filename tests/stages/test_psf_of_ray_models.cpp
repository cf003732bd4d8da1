// The point-spread function of every ray model, as it stands in a rendered picture, against the model's bundle of rays:
// its second moments and centroid as `sturm ellipse` has them, and the whole pattern pixel by pixel.
//
// A small square lamp in a black world, straight ahead. With independent samples a pixel's value is the share of its N
// camera rays that met the lamp, so N × value is binomial and its variance is known. A ray through pupil point p with
// the chief slope q passes the lamp's plane at d(q + p/d + s(p)): what a pixel sees is the point reflection −(p/d +
// s(p)) of the ray pattern, spread by the lamp. Reflection leaves second moments alone and turns centroid and coma
// round.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <random>

#include "compare/ellipses/image_ellipse.h"
#include "compare/statistics/statistics.h"
#include "io/specs/ellipse_query.h"
#include "stages/ellipse_stage.h"
#include "stages/ray_bundle.h"
#include "stages/render_stage.h"

namespace sturm {
namespace {

constexpr double distance_m = 1.0;
constexpr int resolution = 48, samples = 4096;
constexpr double semi_axis_px = 13.0;  // of the longer one
constexpr double lamp_side_px = 3.0;
constexpr int bundle_rays =
    1 << 20;  // of the pattern that the pixels are held against: 28 times as many as meet the lamp in the picture
constexpr std::uint64_t picture_seed = 5;

Json eye_document(const std::string& model) {
  Json eye = {
      {"prescription", {{"sphere_D", -1.5}, {"cylinder_D", -1.25}, {"axis_deg", 30}, {"vertex_distance_mm", 0}}},
      {"pupil_diameter_mm", 4},
      {"accommodation", {{"mode", "fixed"}, {"focus_distance_m", 2}}}};
  if (model != "zernike") return eye;
  eye.erase("prescription");
  // Astigmatism and defocus, with a trefoil, both comas and spherical aberration.
  eye["wavefront"] = {
      {"pupil_diameter_mm", 4},
      {"coefficients_um", {{"3", 0.3}, {"4", 0.9}, {"5", -0.25}, {"6", 0.08}, {"7", -0.3}, {"8", 0.2}, {"12", 0.06}}}};
  return eye;
}

/// The target's entry of what `sturm ellipse` answers; every ray counts with the exact weights of a quadrature.
Json ellipse_of(const std::string& model) {
  Json query = Json::parse(R"({"format": "sturm.ellipse/1", "targets": [{"gaze_deg": [0, 0]}],
                               "rays": {"quadrature": {"radial": 14, "azimuthal": 56}}})");
  query["eye"] = eye_document(model);
  query["targets"][0]["distance_m"] = distance_m;
  query["methods"].push_back("rays:" + model);
  return blur_ellipses(read_ellipse_query(query, "query.json")).at("results").at(0);
}

RenderSpec view_of(const std::string& model, double pixel_slope) {
  const double h = 0.5 * lamp_side_px * pixel_slope * distance_m;
  Json view = Json::parse(R"({"format": "sturm.render/1",
    "scene": {"materials": {"lamp": {"emission": [1, 1, 1]}}, "meshes": [{"material": "lamp", "faces": [[0, 1, 2, 3]]}]},
    "camera": {"position_m": [0, 0, 0], "look_at_m": [0, 0, -1]},
    "method": {"type": "path_trace", "max_bounces": 0, "sampler": "independent", "guide_emitters": false}})");
  for (const auto& [x, y] : {std::pair(-h, -h), std::pair(h, -h), std::pair(h, h), std::pair(-h, h)})
    view["scene"]["meshes"][0]["positions_m"].push_back({x, y, -distance_m});
  view["camera"]["vfov_deg"] = 2.0 * std::atan(0.5 * resolution * pixel_slope) * 180.0 / M_PI;
  view["camera"]["resolution"] = {resolution, resolution};
  view["eye"] = eye_document(model);
  view["method"]["ray_model"] = model;
  view["method"]["samples_per_pixel"] = samples;
  view["seed"] = picture_seed;
  return read_render_spec(view, "view.json");
}

/// Expected value of every pixel: the share of (pixel's area × pupil) that sees the lamp, by `bundle_rays` independent
/// rays and lamp points.
std::vector<double> expected_picture(const std::string& model, double pixel_slope, const Eye& eye) {
  const EyeRays<double> rays = eye_rays_for(*ray_model_named(model), eye, eye.accommodation_for(0.0)).value();
  std::vector<double> picture(resolution * resolution);
  std::mt19937_64 random(17);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const double of_one_ray = lamp_side_px * lamp_side_px / bundle_rays;
  for (int i = 0; i < bundle_rays; ++i) {
    double x, y;
    do x = unit(random), y = unit(random);
    while (x * x + y * y > 1.0);
    const auto ray = rays.through(rays.pupil_radius() * x, rays.pupil_radius() * y);
    const double right = -(ray.px / distance_m + ray.sx) / pixel_slope + 0.5 * lamp_side_px * unit(random),
                 up = -(ray.py / distance_m + ray.sy) / pixel_slope + 0.5 * lamp_side_px * unit(random);
    const int column = static_cast<int>(std::floor(0.5 * resolution + right)),
              row = static_cast<int>(std::floor(0.5 * resolution - up));
    if (column >= 0 && column < resolution && row >= 0 && row < resolution)
      picture[row * resolution + column] += of_one_ray;
  }
  return picture;
}

/// Pearson's χ² of the hits of all pixels as a normal deviate. Pixels that expect fewer than 10 hits are put together.
/// The expectation is itself counted with `bundle_rays` rays, whose noise adds to the variance.
double pattern_deviate(const Image& image, const std::vector<double>& expected) {
  constexpr double fewest = 10.0;
  const double noise_of_expectation =
      samples * lamp_side_px * lamp_side_px / bundle_rays;  // over that of the picture's own hits
  double chi_squared = 0.0, rest_hits = 0.0, rest_expected = 0.0;
  int bins = 0;
  const auto add = [&](double hits, double mean) {
    const double difference = hits - mean;
    chi_squared +=
        difference * difference / (mean * (1.0 - std::min(mean / samples, 1.0)) + mean * noise_of_expectation);
    ++bins;
  };
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const double hits = samples * static_cast<double>(image.pixels[3 * i]), mean = samples * expected[i];
    if (mean >= fewest) {
      add(hits, mean);
    } else {
      rest_hits += hits;
      rest_expected += mean;
    }
  }
  if (rest_expected >= fewest)
    add(rest_hits, rest_expected);
  else
    EXPECT_LT(rest_hits, rest_expected + 5.0 * std::sqrt(fewest));  // next to nothing falls where nothing is expected
  return normal_upper_quantile(std::clamp(chi_squared_upper_tail(chi_squared, bins), 1e-300, 1.0 - 1e-16));
}

/// Of the centroid [px]: pixels are independent and binomial.
Eigen::Vector2d centroid_standard_error(const Image& image, const ImageEllipse& measured) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  double light = 0.0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const double value = *image.at(x, y);
      light += value;
      sum += value * (1.0 - value) / samples * (Eigen::Vector2d(x + 0.5, y + 0.5) - measured.centroid_px).cwiseAbs2();
    }
  return sum.cwiseSqrt() / light;
}

class PsfSlow : public ::testing::TestWithParam<const char*> {};

TEST_P(PsfSlow, ThePictureOfAPointIsTheReflectedBundle) {
  const std::string model = GetParam();
  const Json ellipse = ellipse_of(model);
  ASSERT_EQ(ellipse.at("status"), "ok");
  const double semi_axis = ellipse.at("semi_axes_rad").at(0).get<double>();
  const double pixel_slope = semi_axis > 0.0 ? semi_axis / semi_axis_px : 1e-4;
  const RenderSpec spec = view_of(model, pixel_slope);
  const Image picture = render_view(spec, {}).image.layers.at("");

  const double z_pattern = pattern_deviate(picture, expected_picture(model, pixel_slope, spec.eye.eye));
  EXPECT_LT(z_pattern, 4.0) << model;  // one-sided, 3e-5
  EXPECT_GT(z_pattern, -4.0) << model;
  if (model == "pinhole") {  // the lamp itself, with sharp edges: its pattern is all there is
    EXPECT_EQ(semi_axis, 0.0);
    return;
  }

  Image variance = picture;
  for (float& v : variance.pixels) v = v * (1.0f - v) / samples;
  SpotImaging imaging;
  imaging.pixel_slope = pixel_slope;
  imaging.axis_px = {0.5 * resolution, 0.5 * resolution};
  imaging.emitter_covariance = std::pow(lamp_side_px * pixel_slope, 2) / 12.0 * Eigen::Matrix2d::Identity();
  const ImageEllipse measured = measure_image_ellipse(picture, &variance, imaging);
  const Eigen::Vector2d reflected(-ellipse.at("centroid_m").at(0).get<double>() / distance_m,
                                  -ellipse.at("centroid_m").at(1).get<double>() / distance_m);
  const Eigen::Vector2d z_centroid =
      (measured.centroid - reflected).cwiseQuotient(centroid_standard_error(picture, measured) * pixel_slope);
  EXPECT_LT(z_centroid.cwiseAbs().maxCoeff(), 4.0)
      << model << ": " << measured.centroid.transpose() << " against " << reflected.transpose();
  const double covariance[] = {measured.covariance(0, 0), measured.covariance(0, 1), measured.covariance(1, 1)};
  for (int entry = 0; entry < 3; ++entry) {
    const double expected = ellipse.at("covariance_rad2").at(entry).get<double>();
    const double z = (covariance[entry] - expected) / std::sqrt((*measured.entry_covariance)(entry, entry));
    EXPECT_LT(std::abs(z), 4.0) << model << ", entry " << entry << ": " << covariance[entry] << " against " << expected;
    std::printf("%s: covariance entry %d, z = %.2f\n", model.c_str(), entry, z);
  }
  std::printf("%s: centroid z = %.2f, %.2f; pattern z = %.2f\n", model.c_str(), z_centroid.x(), z_centroid.y(),
              z_pattern);
}

INSTANTIATE_TEST_SUITE_P(EveryModel, PsfSlow,
                         ::testing::Values("pinhole", "thin_lens", "metalstigmatism", "sin2_radial", "power_matrix",
                                           "zernike"),
                         [](const auto& parameter) { return std::string(parameter.param); });

}  // namespace
}  // namespace sturm
