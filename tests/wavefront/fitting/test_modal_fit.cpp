// Wavefronts from slopes against least squares of another program (tests/reference/wavefronts), a real sensor, and bad
// spots.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <random>
#include <tuple>

#include "lensmodel/zernike_wave.h"
#include "support/reference_file.h"
#include "support/sensor_cases.h"
#include "wavefront/fitting/order_choice.h"

namespace sturm {
namespace {

constexpr double um = 1e-6;

std::vector<SlopeSample> spots_of(const nlohmann::json& c) {
  return testing::slope_samples(c["inputs"]["spots"].get<std::vector<std::vector<double>>>());
}

/// (c − truth)ᵀ C⁻¹ (c − truth) with the full covariance.
double chi_square(const ModalFit& fit, const nlohmann::json& truth_um, double noise) {
  Eigen::VectorXd difference = fit.coefficients;
  for (std::size_t i = 0; i < fit.modes.size(); ++i)
    difference[static_cast<Eigen::Index>(i)] -= um * truth_um[std::to_string(fit.modes[i])].get<double>();
  return difference.dot((noise * noise * fit.unit_covariance).ldlt().solve(difference));
}

TEST(ModalFit, PointSlopesGiveTheReferencesCoefficients) {
  const auto file = testing::reference_file("wavefronts/shwfs.json");
  ASSERT_EQ(file["cases"].size(), 16u);
  for (const auto& c : file["cases"]) {
    const auto spots = spots_of(c);
    const ModalFit fit = fit_modes_robustly(slope_problem(spots, modes_of_slopes(5), 3e-3, 0.0));
    const auto& out = c["outputs"];
    EXPECT_THAT(fit.used, ::testing::Each(true)) << c["id"];
    EXPECT_NEAR(fit.condition_number, out["condition_number"].get<double>(), 1e-8) << c["id"];
    EXPECT_NEAR(fit.residual_rms, out["residual_rms_rad"].get<double>(), 1e-8 * fit.residual_rms + 1e-19) << c["id"];
    EXPECT_NEAR(fit.noise.value(), out["sigma_hat_rad"].get<double>(), 1e-8 * fit.residual_rms + 1e-19) << c["id"];
    for (int i = 0; i < 20; ++i) {
      const auto k = static_cast<std::size_t>(i);
      EXPECT_NEAR(fit.coefficients[i] / um, out["zernike_lsq_um"][k].get<double>(), 1e-9) << c["id"] << " " << i + 1;
      const double unit = out["unit_covariance_um2_per_rad2_lower"][k][k];
      EXPECT_NEAR(fit.standard_error(i, 1.0) / um / std::sqrt(unit), 1.0, 1e-6) << c["id"] << " " << i + 1;
      for (std::size_t l = 0; l <= k; ++l)
        EXPECT_NEAR(fit.unit_covariance(i, static_cast<Eigen::Index>(l)) / um / um,
                    out["unit_covariance_um2_per_rad2_lower"][k][l].get<double>(), 1e-6 * unit);
    }
    const double sigma = c["inputs"]["sigma_rad"];
    if (sigma > 0.0 && !c["inputs"]["true_has_modes_beyond_the_fit"].get<bool>()) {
      const double chi = chi_square(fit, c["inputs"]["true_zernike_um"], sigma);
      EXPECT_GT(chi, 5.54) << c["id"];  // 99.8 % of χ² with 20 degrees of freedom
      EXPECT_LT(chi, 45.31) << c["id"];
    }
  }
}

TEST(ModalFit, MeanSlopesGiveTheReferencesCoefficients) {
  const auto reference = testing::reference_file("wavefronts/shack_hartmann.json");
  for (const auto& c : reference["cases"]) {
    const auto spots =
        testing::slope_samples(testing::number_table("tests/reference/wavefronts/" + c["file"].get<std::string>()));
    const ModalFit fit = fit_modes_robustly(slope_problem(spots, modes_of_slopes(6), 3e-3, 0.3e-3));
    const double noise = c["noise_rad"];
    for (int i = 0; i < 27; ++i) {
      const std::string j = std::to_string(i + 1);
      EXPECT_NEAR(fit.coefficients[i] / um, c["least_squares_um"][j].get<double>(), 1e-9) << c["file"] << j;
      EXPECT_NEAR(fit.standard_error(i, noise) / um / c["standard_error_um"][j].get<double>(), 1.0, 1e-6)
          << c["file"] << j;
    }
    const double chi = chi_square(fit, c["true_um"], noise);
    EXPECT_GT(chi, 9.09) << c["file"];  // 99.8 % of χ² with 27 degrees of freedom
    EXPECT_LT(chi, 55.5) << c["file"];
    // Gradients at the centre are another definition, and tell on strong aberrations: the fit is not the reference's.
    const ModalFit centre = fit_modes(slope_problem(spots, modes_of_slopes(6), 3e-3, 0.0), fit.used);
    EXPECT_GT((centre.coefficients - fit.coefficients).cwiseAbs().maxCoeff() / um, 1e-4) << c["file"];
  }
}

TEST(ModalFit, AMeanGradientIsThatOfTheSquare) {
  // Z₁₂ = √5 (6r⁴ − 6r² + 1), ∂/∂x = √5 (24x³ + 24xy² − 12x); over a square of half side h the mean of x³ is x³ + x h²,
  // of xy² is x y² + x h²/3.
  const double x = 0.3, y = -0.5, h = 0.1;
  const ModalProblem problem = slope_problem({{{x, y}, {0, 0}}}, {12}, 1.0, 2 * h);
  EXPECT_NEAR(problem.design(0, 0),
              std::sqrt(5.0) * (24 * (x * x * x + x * h * h) + 24 * (x * y * y + x * h * h / 3) - 12 * x), 1e-13);
  const ModalProblem centre = slope_problem({{{x, y}, {0, 0}}}, {12}, 1.0, 0.0);
  EXPECT_NEAR(centre.design(0, 0), std::sqrt(5.0) * (24 * x * x * x + 24 * x * y * y - 12 * x), 1e-13);
}

/// The real sensor: 127 spots of a laboratory's wavefront, about the spots' mean, 2 mm pupil radius.
std::vector<SlopeSample> real_spots() {
  const auto rows = testing::number_table("configs/data/shwfs_mshwfs_centroids.csv");
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const auto& row : rows) mean += Eigen::Vector2d(row[0], row[1]) / static_cast<double>(rows.size());
  std::vector<SlopeSample> samples;
  for (const auto& row : rows)  // pixels of 7.4 µm; y down
    samples.push_back({7.4e-6 * Eigen::Vector2d(row[0] - mean.x(), mean.y() - row[1]), {row[4], -row[5]}});
  return samples;
}

TEST(ModalFit, ARealSensor) {
  const auto spots = real_spots();
  ASSERT_EQ(spots.size(), 127u);
  const ModalFit fit = fit_modes_robustly(slope_problem(spots, modes_of_slopes(5), 2e-3, 0.3e-3));
  EXPECT_NEAR(fit.residual_rms * 1e3, 0.0643, 0.0002);
  EXPECT_NEAR(fit.noise.value() * 1e3, 0.0670, 0.0002);
  EXPECT_NEAR(fit.condition_number, 4.2, 0.05);
  const OrderChoice choice =
      choose_order([&](int order) { return slope_problem(spots, modes_of_slopes(order), 2e-3, 0.3e-3); }, 127);
  EXPECT_EQ(choice.radial_order, 7);
  ASSERT_EQ(choice.trials.size(), 9u);  // orders 2 … 10
  EXPECT_NEAR(choice.trials[5].left_out_rms.value() * 1e3, 0.0658, 1e-4);
  EXPECT_NEAR(choice.trials[3].left_out_rms.value() * 1e3, 0.0724, 1e-4);
  EXPECT_NEAR(choice.trials[6].left_out_rms.value() * 1e3, 0.0730, 1e-4);
}

TEST(ModalFit, SpuriousSpotsAreFoundAndDoNotMatter) {
  const auto file = testing::reference_file("wavefronts/shwfs.json");
  for (const char* id : {"S1_2e-05_0_complete", "S3_0.0001_30_complete", "S1_2e-05_0_higher_orders"})
    for (const auto& c : file["cases"]) {
      if (c["id"] != id) continue;
      auto spots = spots_of(c);
      std::vector<bool> good(spots.size(), true);
      // A tenth of the spots belongs to a neighbouring lenslet or to a reflex: 5 … 20 mrad away.
      for (std::size_t i = 3; i < spots.size(); i += 10) {
        const double angle = static_cast<double>(i);
        spots[i].slope += (5e-3 + 1e-4 * static_cast<double>(i)) * Eigen::Vector2d(std::cos(angle), std::sin(angle));
        good[i] = false;
      }
      const ModalProblem problem = slope_problem(spots, modes_of_slopes(5), 3e-3, 0.0);
      const ModalFit fit = fit_modes_robustly(problem);
      EXPECT_EQ(fit.used, good) << id;
      const ModalFit rest = fit_modes(problem, good);
      EXPECT_LT((fit.coefficients - rest.coefficients).cwiseAbs().maxCoeff(), 1e-15) << id;
      // What they would have done: the error of ordinary least squares is hundreds of times larger.
      const ModalFit pulled = fit_modes(problem, std::vector<bool>(spots.size(), true));
      EXPECT_GT((pulled.coefficients - rest.coefficients).cwiseAbs().maxCoeff(), 0.1 * um) << id;
    }
}

/// Noise alone on a square grid of lenslets about the middle of the pupil, `across` of them in its radius.
std::vector<SlopeSample> noisy_spots(double across, double noise, std::mt19937& random) {
  std::normal_distribution<double> deviate(0.0, noise);
  std::vector<SlopeSample> spots;
  const int most = static_cast<int>(across);
  for (int y = -most; y <= most; ++y)
    for (int x = -most; x <= most; ++x)
      if (std::hypot(x, y) <= across)
        spots.push_back({3e-3 / across * Eigen::Vector2d(x, y), Eigen::Vector2d(deviate(random), deviate(random))});
  return spots;
}

TEST(ModalFit, NoiseOfFewSpotsIsNotSpurious) {
  std::mt19937 random(20261201);
  constexpr int fits = 300;
  for (const auto& [spots_expected, across, order] :
       {std::tuple(13u, 2.0, 3), {21u, 2.5, 4}, {21u, 2.5, 5}, {29u, 3.0, 6}}) {
    long long rejected = 0, spots_in_all = 0;
    for (int i = 0; i < fits; ++i) {
      const auto spots = noisy_spots(across, 5e-5, random);
      const ModalFit fit = fit_modes_robustly(slope_problem(spots, modes_of_slopes(order), 3e-3, 0.0));
      rejected += std::count(fit.used.begin(), fit.used.end(), false);
      spots_in_all += static_cast<long long>(spots.size());
    }
    EXPECT_EQ(spots_in_all, fits * spots_expected);
    RecordProperty("rejected_" + std::to_string(spots_expected) + "_" + std::to_string(order),
                   std::to_string(rejected));
    EXPECT_EQ(rejected, 0) << spots_expected << " spots, order " << order;
  }
}

TEST(ModalFit, LeavingOutIsFittingTheOthers) {
  const auto c = testing::reference_file("wavefronts/shwfs.json")["cases"][6];
  const auto spots = spots_of(c);
  const ModalProblem problem = slope_problem(spots, modes_of_slopes(4), 3e-3, 0.0);
  const std::vector<bool> all(spots.size(), true);
  double sum = 0.0;
  for (std::size_t i = 0; i < spots.size(); ++i) {
    std::vector<bool> others = all;
    others[i] = false;
    sum += fit_modes(problem, others).residuals.segment<2>(2 * static_cast<Eigen::Index>(i)).squaredNorm();
  }
  const double expected = std::sqrt(sum / (2.0 * static_cast<double>(spots.size())));
  EXPECT_NEAR(fit_modes(problem, all).left_out_rms.value() / expected, 1.0, 1e-9);
}

TEST(ModalFit, HeightsGiveBackAWavefront) {
  std::vector<double> c = {0.1, -0.2, 0.3, 0.05, 0.4, -0.1, 0.02, 0.03, -0.04, 0.01};
  for (double& value : c) value *= um;
  const ZernikeWave wave = ZernikeWave::from_examiner(c, 2e-3);
  std::vector<HeightSample> samples;
  for (int i = -10; i <= 10; ++i)
    for (int k = -10; k <= 10; ++k)
      if (i * i + k * k <= 100) samples.push_back({{2e-4 * i, 2e-4 * k}, wave.height({-2e-4 * i, 2e-4 * k})});
  std::vector<int> modes = modes_of_slopes(3);
  modes.insert(modes.begin(), 0);
  samples[40].height += 2 * um;  // dust
  const ModalFit fit = fit_modes_robustly(height_problem(samples, modes, 2e-3));
  EXPECT_FALSE(fit.used[40]);
  for (int i = 0; i < 10; ++i) EXPECT_NEAR(fit.coefficients[i], c[static_cast<std::size_t>(i)], 1e-18);
}

TEST(ModalFit, RefusesWhatTheSpotsDoNotTell) {
  std::vector<SlopeSample> line, few;
  for (int i = -20; i <= 20; ++i) line.push_back({{1e-4 * i, 0.0}, {1e-5 * i, 0.0}});
  few.assign(line.begin(), line.begin() + 3);
  EXPECT_THROW(fit_modes_robustly(slope_problem(line, modes_of_slopes(4), 2e-3, 0.0)), UndeterminedFit);
  EXPECT_THROW(fit_modes_robustly(slope_problem(few, modes_of_slopes(4), 2e-3, 0.0)), UndeterminedFit);
  EXPECT_THROW(choose_order([&](int order) { return slope_problem(few, modes_of_slopes(order), 2e-3, 0.0); }, 3),
               UndeterminedFit);
}

}  // namespace
}  // namespace sturm
