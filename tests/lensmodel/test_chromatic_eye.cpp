// The chromatic eye and the light it sees, against numbers that are printed with the references.
#include <gtest/gtest.h>

#include "lensmodel/chromatic_eye.h"
#include "lensmodel/gauss_legendre.h"
#include "support/reference_file.h"

namespace sturm {
namespace {

TEST(ChromaticEye, IsMyopicForBlue) {
  // The headers of focus.json and wave_eyes.json: −1.549 D at 400 nm, −0.8271 D at 450, 0.554 D (0.5545) at 700.
  EXPECT_NEAR(chromatic_vergence_D(400, 555), -1.549, 5e-4);
  EXPECT_NEAR(chromatic_vergence_D(450, 555), -0.8271, 5e-5);
  EXPECT_NEAR(chromatic_vergence_D(700, 555), 0.5545, 5e-5);
  EXPECT_EQ(chromatic_vergence_D(555, 555), 0.0);
  // Only differences count: from 840 nm, where instruments measure, to 555 nm the eye gets 0.846 D more myopic.
  EXPECT_NEAR(chromatic_vergence_D(555, 840), 633.46 * (1 / 625.898 - 1 / 340.898), 1e-12);
}

TEST(ChromaticEye, SeesWithTheCiesObserver) {
  const auto values = testing::reference_file("wavefronts/focus.json")["header"]["V_lambda_400_to_700_step10"];
  ASSERT_EQ(values.size(), 31u);
  const Light light = luminance_weighted_light(10.0);
  ASSERT_EQ(light.size(), 31u);
  double sum = 0.0, weights = 0.0;
  for (const auto& v : values) sum += v.get<double>();
  for (std::size_t i = 0; i < 31; ++i) {
    EXPECT_EQ(luminous_efficiency(400.0 + 10.0 * static_cast<double>(i)), values[i].get<double>());
    EXPECT_NEAR(light[i].weight, values[i].get<double>() / sum, 1e-15);
    weights += light[i].weight;
  }
  EXPECT_NEAR(weights, 1.0, 1e-14);
  EXPECT_EQ(luminance_weighted_light(20.0).size(), 16u);
  EXPECT_NEAR(luminous_efficiency(555), 0.5 * (0.99495 + 0.995), 1e-15);
  EXPECT_EQ(luminous_efficiency(379), 0.0);
  EXPECT_EQ(luminous_efficiency(780), 1.5e-5);
}

TEST(GaussLegendre, IntegratesPolynomialsExactly) {
  // ∫ x^(2k) over [−1, 1] is 2/(2k + 1); exact up to the degree 2n − 1.
  for (const int n : {1, 2, 5, 24, 200}) {
    const auto nodes = gauss_legendre(n);
    for (int k = 0; k < n; ++k) {
      double sum = 0.0, odd = 0.0;
      for (const auto& [x, weight] : nodes) {
        sum += weight * std::pow(x, 2 * k);
        odd += weight * std::pow(x, 2 * k + 1);
      }
      EXPECT_NEAR(sum, 2.0 / (2 * k + 1), 1e-13) << n << " " << k;
      EXPECT_NEAR(odd, 0.0, 1e-14);
    }
  }
}

}  // namespace
}  // namespace sturm
