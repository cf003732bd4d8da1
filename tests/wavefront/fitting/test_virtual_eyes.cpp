// Random eyes follow the statistics that they are drawn from.
#include <gtest/gtest.h>

#include <cmath>

#include "wavefront/fitting/virtual_eyes.h"

namespace sturm {
namespace {

TEST(VirtualEyes, AreFourPopulations) {
  const auto& eyes = thibos_eyes();
  ASSERT_EQ(eyes.size(), 4u);
  const double pupils[] = {3.0, 4.5, 6.0, 7.5};
  const int modes[] = {15, 28, 36, 66}, measured[] = {200, 200, 200, 140};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(eyes[i].pupil_diameter_mm, pupils[i]);
    EXPECT_EQ(eyes[i].mean.size(), modes[i]);
    EXPECT_EQ(eyes[i].eyes, measured[i]);
    EXPECT_TRUE(eyes[i].covariance == eyes[i].covariance.transpose());
  }
  EXPECT_EQ(eyes[0].mean[0], 0.0236473);  // the first numbers of the file
  EXPECT_EQ(eyes[0].covariance(1, 0), -0.014866);
}

TEST(VirtualEyes, OneSeedIsOneEye) {
  const EyeStatistics& population = thibos_eyes()[2];
  EXPECT_TRUE(draw_eye(population, 5) == draw_eye(population, 5));
  EXPECT_TRUE(draw_eye(population, 5) != draw_eye(population, 6));
}

TEST(VirtualEyes, HaveThePopulationsMeanAndCovariance) {
  const EyeStatistics& population = thibos_eyes()[2];
  constexpr int count = 4000;
  const auto size = population.mean.size();
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(size);
  Eigen::MatrixXd square = Eigen::MatrixXd::Zero(size, size);
  for (int seed = 0; seed < count; ++seed) {
    const Eigen::VectorXd d = draw_eye(population, static_cast<std::uint64_t>(seed)) - population.mean;
    sum += d;
    square += d * d.transpose();
  }
  for (Eigen::Index i = 0; i < size; ++i) {
    const double deviation = std::sqrt(population.covariance(i, i));
    EXPECT_LT(std::abs(sum[i] / count), 5 * deviation / std::sqrt(count)) << i;  // 5σ of a mean
    for (Eigen::Index k = 0; k <= i; ++k) {
      const double other = std::sqrt(population.covariance(k, k)), expected = population.covariance(i, k);
      const double error = std::sqrt((deviation * deviation * other * other + expected * expected) / count);  // Wishart
      EXPECT_LT(std::abs(square(i, k) / count - expected), 5.5 * error) << i << " " << k;
    }
  }
}

}  // namespace
}  // namespace sturm
