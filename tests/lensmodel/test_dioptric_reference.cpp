// Every case of tests/reference/dioptric.json (50-digit arithmetic, checked with two ray tracers by its authors).
//
// The file is in the examiner's frame: x is flipped against the wearer frame of PowerMatrix, so xy components change
// sign and a meridian θ becomes 180° − θ. AXIS itself is defined in the examiner's frame and needs no change.
#include <gtest/gtest.h>

#include <cmath>

#include "lensmodel/power_matrix.h"
#include "lensmodel/symmetric2.h"
#include "lensmodel/units.h"
#include "support/reference_file.h"

namespace sturm {
namespace {

using nlohmann::json;

constexpr double tolerance = 1e-12;  // [D] or [°]; powers reach 30 D, whose rounding unit is 4e-15 D

void expect_matrix(const PowerMatrix& f, const json& examiner, const std::string& what) {
  EXPECT_NEAR(f.xx(), examiner[0].get<double>(), tolerance) << what;
  EXPECT_NEAR(f.xy(), -examiner[1].get<double>(), tolerance) << what;
  EXPECT_NEAR(f.yy(), examiner[2].get<double>(), tolerance) << what;
}

/// AXIS null in the file = no cylinder; the two ends of (0, 180] are one axis.
void expect_prescription(const Prescription& rx, const json& expected, const std::string& what) {
  EXPECT_NEAR(rx.sphere_D, expected[0].get<double>(), tolerance) << what;
  EXPECT_NEAR(rx.cylinder_D, expected[1].get<double>(), tolerance) << what;
  EXPECT_GT(rx.axis_deg, 0.0) << what;
  EXPECT_LE(rx.axis_deg, 180.0) << what;
  if (expected[2].is_null()) return;
  EXPECT_NEAR(std::remainder(rx.axis_deg - expected[2].get<double>(), 180.0), 0.0, tolerance) << what;
}

void expect_lens(const PowerMatrix& f, const json& expected, const std::string& what) {
  expect_matrix(f, expected["matrix_xx_xy_yy"], what);
  const Prescription minus = f.as_prescription();
  EXPECT_LE(minus.cylinder_D, 0.0) << what;
  expect_prescription(minus, expected["minus_cyl"], what + " minus");
  expect_prescription(transposed(minus), expected["plus_cyl"], what + " plus");
}

/// The power meridian in the examiner's frame, in (0, 180], of a direction in the wearer frame.
double examiner_meridian_deg(const Eigen::Vector2d& wearer) {
  return folded_axis_deg(180.0 - line_direction_deg(std::atan2(wearer.y(), wearer.x())));
}

class DioptricReference : public ::testing::Test {
 protected:
  void for_each_case(const auto& check) {
    const json file = testing::reference_file("dioptric.json");
    ASSERT_EQ(file["cases"].size(), 20u);
    for (const json& c : file["cases"]) {
      const json& in = c["inputs"];
      check(Prescription{in["S"], in["C"], in["A"], 0.0}, in, c["outputs"], c["id"].get<std::string>());
    }
  }
};

TEST_F(DioptricReference, PowerVectors) {
  for_each_case([](const Prescription& rx, const json&, const json& out, const std::string& id) {
    const PowerVector v = power_vector(rx);
    EXPECT_NEAR(v.M, out["power_vector_M_J0_J45"][0].get<double>(), tolerance) << id;
    EXPECT_NEAR(v.J0, out["power_vector_M_J0_J45"][1].get<double>(), tolerance) << id;
    EXPECT_NEAR(v.J45, out["power_vector_M_J0_J45"][2].get<double>(), tolerance) << id;
    EXPECT_NEAR(std::hypot(v.M, v.J0, v.J45), out["strength_B"].get<double>(), tolerance) << id;
  });
}

TEST_F(DioptricReference, MatricesAndBothWaysOfWritingThem) {
  for_each_case([](const Prescription& rx, const json&, const json& out, const std::string& id) {
    expect_lens(PowerMatrix::from(rx), out, id);
    expect_prescription(in_minus_cylinder_form(rx), out["minus_cyl"], id + " rewritten");
    expect_prescription(transposed(in_minus_cylinder_form(rx)), out["plus_cyl"], id + " transposed");
  });
}

TEST_F(DioptricReference, PrincipalPowersAndMeridians) {
  for_each_case([](const Prescription& rx, const json&, const json& out, const std::string& id) {
    const PowerMatrix f = PowerMatrix::from(rx);
    const PrincipalValues p = principal_values(f.xx(), f.xy(), f.yy());
    const json& expected = out["principal"];
    EXPECT_NEAR(p.high, expected["power_max"].get<double>(), tolerance) << id;
    EXPECT_NEAR(p.low, expected["power_min"].get<double>(), tolerance) << id;
    EXPECT_EQ(p.isotropic, expected["meridian_of_max_deg"].is_null()) << id;
    if (p.isotropic) return;
    const Eigen::Vector2d low_direction(-p.high_direction.y(), p.high_direction.x());
    const auto difference = [&](const Eigen::Vector2d& d, const char* key) {
      return std::remainder(examiner_meridian_deg(d) - expected[key].get<double>(), 180.0);
    };
    EXPECT_NEAR(difference(p.high_direction, "meridian_of_max_deg"), 0.0, tolerance) << id;
    EXPECT_NEAR(difference(low_direction, "meridian_of_min_deg"), 0.0, tolerance) << id;
  });
}

TEST_F(DioptricReference, EffectivityInBothDirections) {
  for_each_case([](const Prescription& rx, const json&, const json& out, const std::string& id) {
    for (const auto& [key, distance] : {std::pair{"12mm", 0.012}, {"14mm", 0.014}}) {
      const json& expected = out["effectivity"][key];
      const std::string what = id + " " + key;
      const PowerMatrix lens = PowerMatrix::from(rx);
      expect_lens(lens.moved_towards_eye(distance), expected["spectacle_to_cornea"], what + " to cornea");
      expect_lens(lens.moved_towards_eye(-distance), expected["cornea_to_spectacle"], what + " to spectacle");
      Prescription written = rx;
      written.vertex_distance_m = distance;
      expect_matrix(power_at_cornea(written), expected["spectacle_to_cornea"]["matrix_xx_xy_yy"], what);
    }
  });
}

TEST_F(DioptricReference, CrossedSums) {
  for_each_case([](const Prescription& rx, const json& in, const json& out, const std::string& id) {
    const json& second = in["second_Rx"];
    const PowerMatrix sum = PowerMatrix::from(rx) + PowerMatrix::from({second[0], second[1], second[2], 0.0});
    expect_lens(sum, out["crossed_sum"], id);
  });
}

}  // namespace
}  // namespace sturm
