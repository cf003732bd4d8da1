// Rays of a wavefront: moments, radii and their distance from waves (tests/reference/wavefronts/rays_vs_waves.json),
// and the conoid's ellipse in second order.
#include <gtest/gtest.h>

#include <cmath>

#include "support/wave_cases.h"
#include "wavefront/psf/ray_fan.h"

namespace sturm {
namespace {

using testing::arcmin;
using testing::examiner_wave;

PupilWave reference_eye(const nlohmann::json& inputs) {
  const std::string eye = inputs["eye"];
  return examiner_wave(eye == "ideal" ? std::vector<double>{0.0} : testing::hofer_eye(eye.back() - '0'), 6.0,
                       inputs["pupil_mm"]);
}

TEST(RayMoments, ReferencesToTheirDigits) {
  const auto file = testing::reference_file("wavefronts/rays_vs_waves.json");
  ASSERT_EQ(file["cases"].size(), 54u);
  for (const auto& c : file["cases"]) {
    const RayMoments moments =
        ray_moments(reference_eye(c["inputs"]), monochromatic_light(555), c["inputs"]["defocus_V_D"].get<double>());
    const auto& out = c["outputs"];
    const double size = out["ray_covariance_arcmin2"][0].get<double>() + out["ray_covariance_arcmin2"][2].get<double>();
    const double half_digit = 5e-6;  // six digits are stored
    for (int i = 0; i < 2; ++i)
      EXPECT_NEAR(moments.centroid[i] / arcmin, out["ray_centroid_arcmin"][i].get<double>(),
                  half_digit * std::sqrt(size) + 1e-9);
    EXPECT_NEAR(moments.covariance(0, 0) / arcmin / arcmin, out["ray_covariance_arcmin2"][0].get<double>(),
                half_digit * size);
    EXPECT_NEAR(moments.covariance(0, 1) / arcmin / arcmin, out["ray_covariance_arcmin2"][1].get<double>(),
                half_digit * size);
    EXPECT_NEAR(moments.covariance(1, 1) / arcmin / arcmin, out["ray_covariance_arcmin2"][2].get<double>(),
                half_digit * size);
  }
}

TEST(RayMoments, OfOtherProgramsToRounding) {
  const auto file = testing::reference_file("wave_psf.json");
  for (const auto& c : file["cases"]) {
    const PupilWave pupil = examiner_wave(testing::coefficient_list(c["inputs"]["zernike_osa_um"]),
                                          c["inputs"]["pupil_mm"], c["inputs"]["pupil_mm"]);
    const RayMoments moments = ray_moments(pupil, monochromatic_light(555), 0.0);
    const auto& expected = c["outputs"]["geometric"];
    const double xx = expected["cov_arcmin2_xx_xy_yy"][0], xy = expected["cov_arcmin2_xx_xy_yy"][1],
                 yy = expected["cov_arcmin2_xx_xy_yy"][2];
    EXPECT_NEAR(moments.centroid.x() / arcmin, expected["centroid_arcmin"][0].get<double>(), 1e-11);
    EXPECT_NEAR(moments.centroid.y() / arcmin, expected["centroid_arcmin"][1].get<double>(), 1e-11);
    EXPECT_NEAR(moments.covariance(0, 0) / arcmin / arcmin, xx, 1e-11 * (xx + yy) + 1e-15);
    EXPECT_NEAR(moments.covariance(0, 1) / arcmin / arcmin, xy, 1e-11 * (xx + yy) + 1e-15);
    EXPECT_NEAR(moments.covariance(1, 1) / arcmin / arcmin, yy, 1e-11 * (xx + yy) + 1e-15);
  }
}

TEST(RayMoments, OfSecondOrderAreTheConoids) {
  // −2 / −1.5 × 30 at the cornea over 4 mm, target at 1 m: X/d = I/d + F, covariance a²/4 X Xᵀ. F by hand in the wearer
  // frame: AXIS 30 acts along 60°, F = −2 I − 1.5 u uᵀ with u = (½, √3/2).
  const Eye eye = Eye::with({-2.0, -1.5, 30.0, 0.0}, 4e-3);
  const RayMoments moments = ray_moments(PupilWave::of(eye, 555), monochromatic_light(555), 1.0);
  Eigen::Matrix2d x;
  x << 1 - 2 - 1.5 * 0.25, -1.5 * std::sqrt(3.0) / 4, -1.5 * std::sqrt(3.0) / 4, 1 - 2 - 1.5 * 0.75;
  const Eigen::Matrix2d expected = 1e-6 * x * x.transpose();
  EXPECT_LT((moments.covariance - expected).norm(), 1e-12 * expected.norm());
  EXPECT_LT(moments.centroid.norm(), 1e-15);
}

TEST(RayMoments, OfStilesCrawfordPupilsFollowTheGamma) {
  // E[t] = 1/q − e^(−q)/(1 − e^(−q)), t = r²/a² (theory 5.3); covariance V²a²/2 E[t] for defocus V.
  const double q = 0.05 * 9.0 * std::log(10.0), mean = 1 / q - std::exp(-q) / (1 - std::exp(-q));
  const PupilWave pupil = examiner_wave({0.0}, 6.0, 6.0, 0.05);
  const RayMoments moments = ray_moments(pupil, monochromatic_light(555), 0.7);
  EXPECT_NEAR(moments.covariance(0, 0), 0.49 * 9e-6 / 2 * mean, 1e-12 * 0.49 * 9e-6);
  const RayFan fan(pupil, monochromatic_light(555), 1 << 18);
  double sum = 0.0;
  fan.for_each(0.7, [&](const Eigen::Vector2d& x, double share) { sum += share * x.squaredNorm(); });
  EXPECT_NEAR(sum, 0.49 * 9e-6 * mean, 1e-5 * 0.49 * 9e-6);
}

TEST(RayFan, ADefocusedEyeSeesADisc) {
  const PupilWave pupil = examiner_wave({0.0}, 4.0, 4.0);
  const RayFan fan(pupil, monochromatic_light(555), usual_ray_count);
  EXPECT_NEAR(ray_radius(fan, 1.0, {0, 0}, 0.5), 2e-3 * std::sqrt(0.5), 1e-8);
  EXPECT_NEAR(ray_radius(fan, 1.0, {0, 0}, 0.8), 2e-3 * std::sqrt(0.8), 1e-8);
  // No visible noise: cells within the disc of 6.9′ differ from a level plane by less than 1 %.
  const PsfCells cells = cells_of(fan, 1.0, 0.5 * arcmin, 31);
  const double expected = std::pow(0.5 * arcmin, 2) / (3.14159265358979 * 4e-6);
  for (int i = -8; i <= 8; ++i)
    for (int k = -8; k <= 8; ++k) EXPECT_NEAR(cells.energy(15 + i, 15 + k) / expected, 1.0, 0.01);
  EXPECT_NEAR(cells.outside(), 0.0, 1e-12);
}

TEST(RayFan, ChromaticRaysSpreadInFocus) {
  const PupilWave pupil = examiner_wave({0.0}, 4.0, 4.0);
  const Light light = luminance_weighted_light(10.0);
  double square = 0.0;
  for (const SpectralLine& line : light)
    square += line.weight * std::pow(chromatic_vergence_D(line.wavelength_nm, 555), 2);
  EXPECT_NEAR(ray_moments(pupil, light, 0.0).covariance(0, 0), square * 1e-6, 1e-12);
  const RayFan fan(pupil, light, usual_ray_count);
  double sum = 0.0;
  fan.for_each(0.0, [&](const Eigen::Vector2d& x, double share) { sum += share * x.squaredNorm(); });
  EXPECT_NEAR(sum / (2e-6 * square), 1.0, 1e-4);
}

TEST(RayFan, PartsOfAPupilMakeUpTheWhole) {
  // The second moments about the origin of a defocused eye with Stiles–Crawford, part by part.
  const PupilWave pupil = examiner_wave({0.0}, 6.0, 6.0, 0.05);
  const PupilSector parts[] = {{0.0, 0.3, 0.0, 1.0}, {0.3, 1.0, 0.0, 0.25}, {0.3, 1.0, 0.25, 1.0}};
  const auto square = [&](const PupilSector& sector) {
    double sum = 0.0;
    RayFan(pupil, monochromatic_light(555), 1 << 16, sector).for_each(0.7, [&](const Eigen::Vector2d& x, double share) {
      sum += share * x.squaredNorm();
    });
    return sum;
  };
  double shares = 0.0, sum = 0.0;
  for (const PupilSector& part : parts) {
    shares += pupil.share_of(part);
    sum += pupil.share_of(part) * square(part);
  }
  EXPECT_NEAR(shares, 1.0, 1e-14);
  EXPECT_NEAR(sum / square({}), 1.0, 1e-4);
  // ∫ 10^(−0.45 t) dt over 0 … 0.3 and 0 … 1: (1 − 10^−0.135)/(1 − 10^−0.45).
  EXPECT_NEAR(pupil.share_of(parts[0]), 0.41410572, 1e-7);
}

void expect_variation(const nlohmann::json& c) {
  const PupilWave pupil = reference_eye(c["inputs"]);
  const double vergence = c["inputs"]["defocus_V_D"];
  const Light green = monochromatic_light(555), white = luminance_weighted_light(20.0);
  const auto wave = [&](const Light& light) {
    return wave_psf(pupil, light, vergence, wave_sampling(pupil, light, vergence));
  };
  const WavePsf wave555 = wave(green), wavepoly = wave(white);
  const RayFan rays(pupil, green, usual_ray_count), rayspoly(pupil, white, usual_ray_count);
  const auto& out = c["outputs"];
  for (const auto& [name, cell, side] :
       {std::tuple("0.5", 0.5, 195), std::tuple("1", 1.0, 97), std::tuple("2", 2.0, 49)}) {
    const double size = cell * arcmin;
    const PsfCells r = cells_of(rays, vergence, size, side), rp = cells_of(rayspoly, vergence, size, side),
                   w = cells_of(wave555, size, side), wp = cells_of(wavepoly, size, side);
    const std::string suffix = std::string("_cell") + name;
    const auto expect = [&](const std::string& pair, double got) {
      const auto found = out.find("tv_" + pair + suffix);
      if (found == out.end()) return;
      EXPECT_NEAR(got, found->get<double>(), 0.005) << c["id"] << pair << suffix;
    };
    expect("rays_wave555", total_variation(r, w));
    expect("rays_wavepoly", total_variation(r, wp));
    expect("rayspoly_wavepoly", total_variation(rp, wp));
    expect("wave555_wavepoly", total_variation(w, wp));
  }
  for (const auto& [key, share] : {std::pair("ray_ee50_arcmin", 0.5), std::pair("ray_ee80_arcmin", 0.8)})
    EXPECT_NEAR(ray_radius(rays, vergence, {0, 0}, share) / arcmin, out[key].get<double>(),
                0.01 * out[key].get<double>() + 1e-9)
        << c["id"];
  for (const auto& [key, share] : {std::pair("wave_ee50_arcmin", 0.5), std::pair("wave_ee80_arcmin", 0.8)})
    // The reference's transform has pixels of 0.117'.
    EXPECT_NEAR(WaveEnergy(wave555, {0, 0}).radius(share).value() / arcmin, out[key].get<double>(),
                0.01 * out[key].get<double>() + 0.1 * 0.117)
        << c["id"];
}

TEST(RayFan, DistancesFromWavesAreTheReferences) {
  const auto file = testing::reference_file("wavefronts/rays_vs_waves.json");
  for (std::size_t i = 15; i < file["cases"].size(); i += 26) expect_variation(file["cases"][i]);
}

TEST(RayFan, SlowDistancesFromWavesAreTheReferencesByTwo) {
  const auto file = testing::reference_file("wavefronts/rays_vs_waves.json");
  for (std::size_t i = 0; i < file["cases"].size(); i += 2) expect_variation(file["cases"][i]);
}

}  // namespace
}  // namespace sturm
