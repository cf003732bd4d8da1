// Point spreads by diffraction against closed forms and against the quadratures of tests/reference/wavefronts.
#include <gtest/gtest.h>

#include <cmath>

#include "support/units.h"
#include "support/wave_cases.h"
#include "wavefront/psf/disc_area.h"
#include "wavefront/psf/transfer.h"
#include "wavefront/psf/wave_kernel.h"

namespace sturm {
namespace {

using testing::arcmin;
using testing::examiner_wave;
using testing::pi;

/// Cycles per radian from cycles per degree, along a direction.
Eigen::Vector2d frequency(double cpd, double direction_deg) {
  const double angle = direction_deg * pi / 180.0;
  return cpd * 180.0 / pi * Eigen::Vector2d(std::cos(angle), std::sin(angle));
}

WavePsf spread_of(const PupilWave& pupil, const Light& light, double vergence_D) {
  return wave_psf(pupil, light, vergence_D, wave_sampling(pupil, light, vergence_D));
}

TEST(DiscArea, IsThatOfACircle) {
  EXPECT_NEAR(area_within_disc(0, 2, 0, 2, 1.0), pi / 4, 1e-15);
  EXPECT_EQ(area_within_disc(0, 0.5, 0, 0.5, 1.0), 0.25);
  EXPECT_EQ(area_within_disc(0.8, 0.9, 0.8, 0.9, 1.0), 0.0);
  // The segment beyond x = ½: (π/3 − √3/4)/2 in the first quadrant.
  EXPECT_NEAR(area_within_disc(0.5, 1, 0, 1, 1.0), (pi / 3 - std::sqrt(3.0) / 4) / 2, 1e-15);
  double sum = 0.0;  // 13 × 13 cells of a quarter of the disc
  for (int i = 0; i < 13; ++i)
    for (int k = 0; k < 13; ++k) sum += area_within_disc(i / 13.0, (i + 1) / 13.0, k / 13.0, (k + 1) / 13.0, 1.0);
  EXPECT_NEAR(sum, pi / 4, 1e-14);
}

TEST(WavePsf, WithoutAberrationIsAirys) {
  const PupilWave pupil = examiner_wave({0.0}, 4.0, 4.0);
  const Light light = monochromatic_light(555);
  const WavePsf psf = spread_of(pupil, light, 0.0);
  EXPECT_NEAR(psf.strehl_origin, 1.0, 1e-12);
  EXPECT_NEAR(psf.strehl_peak, 1.0, 1e-4);
  EXPECT_NEAR(psf.peak.norm(), 0.0, 1e-12);
  const double scale = pi * 4e-3 / 555e-9;  // x = π D θ/λ
  for (const double x : {0.5, 1.0, 2.0, 3.0, 5.0, 8.0}) {
    const double airy = std::pow(2.0 * ::j1(x) / x, 2);
    for (const double direction : {0.0, 0.4, 1.1})
      EXPECT_NEAR(
          psf.density(x / scale * Eigen::Vector2d(std::cos(direction), std::sin(direction))) / psf.reference_peak, airy,
          1e-4);
    // Encircled energy 1 − J₀² − J₁² (Rayleigh).
    EXPECT_NEAR(WaveEnergy(psf, {0, 0}).within(x / scale), 1.0 - std::pow(::j0(x), 2) - std::pow(::j1(x), 2), 1e-4);
  }
  EXPECT_NEAR(visual_strehl(psf, pupil, light), 1.0, 1e-3);  // the grid's samples at small frequencies
}

TEST(WavePsf, CellsOnThePupilsRimCountByTheirPartWithinIt) {
  // Without aberration the density at X = 0 is (∫ dp)²/(λ² ∫ dp) = πa²/λ² on every grid, however coarse: cells on the
  // rim that count whole, not at all, or by their middle miss some thousandths of the disc.
  for (const auto& [pupil_mm, grid] : {std::pair(4.0, 128), {4.0, 150}, {3.1, 216}, {5.7, 256}}) {
    const PupilWave pupil = examiner_wave({0.0}, pupil_mm, pupil_mm);
    const Light light = {{480, 0.25}, {555, 0.75}};
    double expected = 0.0;
    for (const SpectralLine& line : light)
      expected += line.weight * pi * std::pow(0.5e-3 * pupil_mm / (1e-9 * line.wavelength_nm), 2);
    const PupilWave focused{pupil.wave, pupil.radius_m, 0.0, 555};
    const WavePsf psf = wave_psf(focused, light, 0.0, wave_sampling(focused, light, 0.0, grid));
    EXPECT_NEAR(psf.reference_peak / expected, 1.0, 1e-8) << pupil_mm << " " << grid;  // cells below 1e-9 are left out
  }
}

TEST(WavePsf, WithoutAberrationHasTheClosedTransferFunction) {
  const PupilWave pupil = examiner_wave({0.0}, 4.0, 4.0);
  const Light light = monochromatic_light(555);
  const WavePsf psf = spread_of(pupil, light, 0.0);
  const double cutoff = 4e-3 / 555e-9;
  for (const double share : {0.05, 0.2, 0.5, 0.8, 0.99}) {
    const double closed = 2 / pi * (std::acos(share) - share * std::sqrt(1 - share * share));
    EXPECT_NEAR(unaberrated_transfer(pupil, light, share * cutoff), closed, 1e-9);
    EXPECT_NEAR(std::abs(wave_transfer(pupil, light, 0.0, {0.0, share * cutoff})), closed, 1e-9);
    // The transform's own: at the nearest frequency of its grid.
    const int k = static_cast<int>(std::lround(share * cutoff / psf.sampling.frequency_step));
    const double s = k * psf.sampling.frequency_step / cutoff;
    EXPECT_NEAR(std::abs(psf.otf(psf.highest, k)), 2 / pi * (std::acos(s) - s * std::sqrt(1 - s * s)), 1e-4);
  }
  EXPECT_EQ(std::abs(wave_transfer(pupil, light, 0.0, {0.0, 1.01 * cutoff})), 0.0);
}

TEST(WavePsf, DefocusHasTheStrehlRatioOfASquaredSinc) {
  // ½ D over 3 mm at 555 nm: W₂₀ = V a²/(2λ) = 1.01351… waves; Strehl sinc²(W₂₀).
  const PupilWave pupil = examiner_wave({0.0}, 3.0, 3.0);
  const double waves = 0.5 * 2.25e-6 / 2 / 555e-9;
  const double expected = std::pow(std::sin(pi * waves) / (pi * waves), 2);
  EXPECT_NEAR(spread_of(pupil, monochromatic_light(555), 0.5).strehl_origin, expected, 2e-5);
  EXPECT_NEAR(spread_of(pupil, monochromatic_light(555), -0.5).strehl_origin, expected, 2e-5);
}

TEST(WavePsf, ItsGridAndItsQuadratureAgree) {
  const PupilWave pupil = examiner_wave(testing::hofer_eye(5), 6.0, 5.0, 0.05);
  const Light light = {{450, 0.2}, {555, 0.5}, {650, 0.3}};
  const WavePsf psf = spread_of(pupil, light, 0.4);
  for (const auto& [kx, ky] : {std::pair(12, 0), std::pair(30, -25), std::pair(5, 60), std::pair(80, 80)}) {
    const auto expected = wave_transfer(pupil, light, 0.4, psf.sampling.frequency_step * Eigen::Vector2d(kx, ky));
    EXPECT_NEAR(std::abs(psf.otf(psf.highest + ky, kx) - expected), 0.0, 3e-4) << kx << " " << ky;
  }
}

TEST(WavePsf, LiesWhereTheRaysLand) {
  // Tilt of 1 µm in sine and 2 µm in cosine over 4 mm.
  const PupilWave tilted = examiner_wave({0, 1.0, 2.0}, 4.0, 4.0);
  const WavePsf psf = spread_of(tilted, monochromatic_light(555), 0.0);
  // ∂(c·2r sin θ)/∂y = 2c/a = 2·1e-6/2e-3.
  EXPECT_NEAR(psf.peak.y(), 1e-3, 2e-6);  // 1/64 of the grid's pixel of 69e-6
  EXPECT_NEAR(psf.peak.x(), 2e-3, 2e-6);
  EXPECT_NEAR(psf.strehl_peak, 1.0, 1e-3);
  EXPECT_LT(psf.strehl_origin, 1e-3);
  EXPECT_NEAR(WaveEnergy(psf, {2e-3, 1e-3}).radius(0.5).value(), 0.5353 * 555e-9 / 4e-3, 1e-6);
}

TEST(WavePsf, IsRefusedWhereItWouldAlias) {
  const PupilWave pupil = examiner_wave({0.0}, 6.0, 6.0);
  const Light light = monochromatic_light(555);
  EXPECT_THROW(wave_sampling(pupil, light, 0.5, 64), AliasedSampling);
  EXPECT_THROW(wave_sampling(pupil, light, 40.0), AliasedSampling);
  const WaveSampling sampling = wave_sampling(pupil, light, 5.0);
  EXPECT_GT(sampling.window_rad(), 2 * 5.0 * 3e-3);  // rays of ±15 mrad
  EXPECT_GT(sampling.grid * sampling.frequency_step, 2 * 6e-3 / 555e-9);
}

TEST(WavePsf, CellsHoldItsEnergy) {
  const PupilWave pupil = examiner_wave(testing::hofer_eye(1), 6.0, 3.0);
  const WavePsf psf = spread_of(pupil, monochromatic_light(555), 0.5);
  const PsfCells fine = cells_of(psf, 0.25 * arcmin, 81), coarse = cells_of(psf, 0.75 * arcmin, 27);
  EXPECT_GT(fine.energy.minCoeff(), -1e-12);
  for (int i = 0; i < 27; ++i)
    for (int k = 0; k < 27; ++k) EXPECT_NEAR(coarse.energy(i, k), (fine.energy.block<3, 3>(3 * i, 3 * k).sum()), 1e-12);
  const SpreadKernel kernel = wave_kernel(psf, 0.5 * arcmin, 512);
  EXPECT_NEAR(kernel.sum(), 1.0, 1e-6);
  EXPECT_THROW(wave_kernel(psf, 0.5 * arcmin, kernel.radius_px - 1), std::invalid_argument);
  EXPECT_THROW(wave_kernel(psf, 1e-9 * arcmin, 512), std::invalid_argument);  // before any memory is taken
}

TEST(WavePsf, CellsBeyondItsWindowAreEmpty) {
  const PupilWave pupil = examiner_wave({0.0}, 4.0, 4.0);
  const WavePsf psf = spread_of(pupil, monochromatic_light(555), 0.0);
  const double window = psf.sampling.window_rad(), all = psf.otf(psf.highest, 0).real();
  // Three periods across; cells that the window's border cuts.
  const PsfCells cells = cells_of(psf, window / 10.0, 31), within = cells_of(psf, window / 10.0, 11);
  EXPECT_NEAR(cells.energy.sum(), all, 1e-12);
  EXPECT_NEAR(within.energy.sum(), all, 1e-12);
  EXPECT_EQ(cells.energy(15, 25), 0.0);
  EXPECT_GT(cells.energy(15, 20), 0.0);
  EXPECT_NEAR(cells_of(psf, 3.0 * window, 1).energy.sum(), all, 1e-12);
}

TEST(WavePsf, ReferencesAt550nm) {
  const auto file = testing::reference_file("wave_psf.json");
  for (const auto& c : file["cases"]) {
    const PupilWave pupil = examiner_wave(testing::coefficient_list(c["inputs"]["zernike_osa_um"]),
                                          c["inputs"]["pupil_mm"], c["inputs"]["pupil_mm"], 0.0, 550);
    const Light light = monochromatic_light(550);
    const WavePsf psf = spread_of(pupil, light, 0.0);
    const auto& expected = c["outputs"];
    EXPECT_NEAR(psf.strehl_origin, expected["strehl"].get<double>(), 1e-4) << c["name"];
    const double cpd[] = {3, 6, 12, 18, 24, 30};
    for (const auto& [name, direction] :
         {std::pair("x", 0), std::pair("y", 90), std::pair("diag45", 45), std::pair("diag135", 135)})
      for (std::size_t i = 0; i < 6; ++i)
        EXPECT_NEAR(std::abs(wave_transfer(pupil, light, 0.0, frequency(cpd[i], direction))),
                    expected["mtf"][name][i].get<double>(), 1e-6)
            << c["name"] << name << cpd[i];
    const WaveEnergy energy(psf, {0, 0});
    for (const auto& [key, share] : {std::pair("r50_arcmin", 0.5), std::pair("r80_arcmin", 0.8)}) {
      const double radius = expected["ee_radius_arcmin"][key].get<double>();
      EXPECT_NEAR(energy.radius(share).value() / arcmin, radius, 2e-3 * radius) << c["name"] << key;
    }
  }
}

/// The 16 spreads of an eye through focus.
void expect_focus_case(const nlohmann::json& c, bool polychromatic) {
  for (const bool apodised : {false, true}) {
    const std::string key = std::string(polychromatic ? "poly_" : "mono_") + (apodised ? "stiles_crawford" : "uniform");
    const auto& expected = c["outputs"][key];
    const PupilWave pupil = examiner_wave(testing::hofer_eye(c["inputs"]["subject"]), c["inputs"]["measured_pupil_mm"],
                                          c["inputs"]["pupil_mm"], apodised ? 0.05 : 0.0);
    const Light light = polychromatic ? luminance_weighted_light(10.0) : monochromatic_light(555);
    const double vergence = c["inputs"]["defocus_V_D"];
    const WavePsf psf = spread_of(pupil, light, vergence);
    // The references' own two ways differ by 2e-5 (Strehl), 1.1e-4 (MTF) and 0.25 % (radii).
    EXPECT_NEAR(psf.strehl_origin, expected["strehl_origin"].get<double>(), 1e-4) << c["id"] << key;
    const double cpd[] = {5, 10, 20, 30};
    for (std::size_t d = 0; d < 4; ++d)
      for (std::size_t i = 0; i < 4; ++i)
        EXPECT_NEAR(std::abs(wave_transfer(pupil, light, vergence, frequency(cpd[i], 45.0 * static_cast<double>(d)))),
                    expected["mtf_dir_by_cpd"][d][i].get<double>(), 5e-5)
            << c["id"] << key << d << i;
    const WaveEnergy energy(psf, {0, 0});
    for (const auto& [name, share] : {std::pair("ee50_radius_arcmin", 0.5), std::pair("ee80_radius_arcmin", 0.8)}) {
      const double radius = expected[name].get<double>();
      EXPECT_NEAR(energy.radius(share).value() / arcmin, radius, 2e-3 * radius) << c["id"] << key << name;
    }
  }
}

TEST(WavePsf, RealEyesThroughFocusInOneWavelength) {
  const auto file = testing::reference_file("wavefronts/focus.json");
  ASSERT_EQ(file["cases"].size(), 48u);
  for (std::size_t i = 1; i < file["cases"].size(); i += 11) expect_focus_case(file["cases"][i], false);
}

TEST(WavePsf, SlowRealEyesThroughFocusInOneWavelengthAll) {
  const auto file = testing::reference_file("wavefronts/focus.json");
  for (const auto& c : file["cases"]) expect_focus_case(c, false);
}

TEST(WavePsf, SlowRealEyesThroughFocusInWhiteLight) {
  const auto file = testing::reference_file("wavefronts/focus.json");
  for (std::size_t i = 3; i < file["cases"].size(); i += 15) expect_focus_case(file["cases"][i], true);
}

TEST(WavePsf, SlowRealEyesThroughFocusInWhiteLightByThree) {
  const auto file = testing::reference_file("wavefronts/focus.json");
  // A third of the cases, of every eye and pupil; all of them take four minutes.
  for (std::size_t i = 0; i < file["cases"].size(); i += 3) expect_focus_case(file["cases"][i], true);
}

TEST(WavePsf, PeaksAreWhereTheReferencesFoundThem) {
  const auto file = testing::reference_file("wavefronts/wave_eyes.json");
  for (const auto& c : file["cases"]) {
    const auto& expected = c["outputs"]["mono_uniform"];
    const PupilWave pupil =
        examiner_wave(testing::coefficient_list(c["inputs"]["zernike_um_6mm"]), 6.0, c["inputs"]["pupil_mm"]);
    const WavePsf psf = spread_of(pupil, monochromatic_light(555), 0.0);
    EXPECT_NEAR(psf.strehl_peak, expected["strehl_peak"].get<double>(), 1e-3) << c["id"];
    EXPECT_NEAR(psf.peak.x() / arcmin, expected["peak_xy_arcmin"][0].get<double>(), 0.02) << c["id"];
    EXPECT_NEAR(psf.peak.y() / arcmin, expected["peak_xy_arcmin"][1].get<double>(), 0.02) << c["id"];
  }
}

}  // namespace
}  // namespace sturm
