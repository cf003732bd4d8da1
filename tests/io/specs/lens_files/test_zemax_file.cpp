#include <gmock/gmock.h>

#include <cmath>
#include <cstdio>

#include "io/specs/lens_files/lens_file_testing.h"

namespace sturm {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

/// A sequential file of a lens between object and image; the parts of its two surfaces are given.
std::string zmx(const std::string& front, const std::string& back, const std::string& unit = "MM",
                const std::string& glass = "___BLANK 1 0 1.5 58 0 0 0 0 0 0") {
  return "VERS 190513 80 123457 L123457\r\nMODE SEQ\r\nNAME a test's lens\r\nUNIT " + unit +
         " X W X CM MR CPMM\r\nSURF 0\r\n  TYPE STANDARD\r\n  CURV 0.0 0 0 0 0 \"\"\r\n  DISZ INFINITY\r\n  DIAM 0 0 0 "
         "0 1 \"\"\r\n"
         "SURF 1\r\n  STOP\r\n" +
         front + "  GLAS " + glass + "\r\nSURF 2\r\n" + back +
         "SURF 3\r\n  TYPE STANDARD\r\n  CURV 0.0\r\n  DISZ 0\r\n  DIAM 1\r\n";
}

const std::string front = "  TYPE STANDARD\r\n  CURV 0.01 0 0 0 0 \"\"\r\n  DISZ 3.0\r\n  DIAM 32.5 1 0 0 1 \"\"\r\n";
const std::string back = "  TYPE STANDARD\r\n  CURV 0.016 0 0 0 0 \"\"\r\n  DISZ 12\r\n  DIAM 30 1 0 0 1 \"\"\r\n";

class ZemaxFile : public LensFileTest {};

// F₁ = 0.5 · 10 = 5 D, F₂ = −0.5 · 16 = −8 D, 3 mm of index 1.5: −8 + 5/(1 − 0.002 · 5).
constexpr double expected_D = -8.0 + 5.0 / 0.99;

TEST_F(ZemaxFile, TheTwoSurfacesAboutTheGlassAreTheLens) {
  const LensFile file = lens(zmx(front, back), "a.zmx");
  EXPECT_NEAR(power(file).sphere_D, expected_D, 1e-12);
  EXPECT_NEAR(power(file).cylinder_D, 0.0, 1e-12);
  EXPECT_DOUBLE_EQ(file.lens.center_thickness_m, 3e-3);
  EXPECT_DOUBLE_EQ(file.lens.diameter_m, 60e-3);  // the smaller of both
  EXPECT_FALSE(file.made_for);
  EXPECT_TRUE(file.notes.empty());
}

TEST_F(ZemaxFile, IsReadInItsEncodings) {
  const std::string text = zmx(front, back);
  std::string utf16 = "\xFF\xFE", unmarked, big_endian, lines;
  for (const char c : text) {
    utf16 += c, utf16 += '\0', unmarked += c, unmarked += '\0', big_endian += '\0', big_endian += c;
    if (c != '\r') lines += c;
  }
  for (const std::string& bytes :
       {text, utf16, unmarked, big_endian, "\xEF\xBB\xBF" + text, lines, "NOTE 0 f\xFCr\r\n" + text})
    EXPECT_NEAR(power(lens(bytes, "a.ZMX")).sphere_D, expected_D, 1e-12);
}

TEST_F(ZemaxFile, UnitsAreThoseOfTheFile) {
  const auto scaled = [](double per_mm) {  // numbers of a file whose unit is `per_mm` times a millimetre
    char a[200], b[200];
    std::snprintf(a, sizeof a, "  TYPE STANDARD\n  CURV %.17g\n  DISZ %.17g\n  DIAM %.17g\n", 0.01 * per_mm,
                  3.0 / per_mm, 32.5 / per_mm);
    std::snprintf(b, sizeof b, "  TYPE STANDARD\n  CURV %.17g\n  DISZ 1\n  DIAM %.17g\n", 0.016 * per_mm,
                  30.0 / per_mm);
    return std::pair<std::string, std::string>(a, b);
  };
  for (const auto& [unit, per_mm] : {std::pair("CM", 10.0), {"IN", 25.4}, {"METER", 1000.0}, {"M", 1000.0}}) {
    const auto [a, b] = scaled(per_mm);
    const LensFile file = lens(zmx(a, b, unit), "a.zmx");
    EXPECT_NEAR(power(file).sphere_D, expected_D, 1e-11) << unit;
    EXPECT_NEAR(file.lens.diameter_m, 60e-3, 1e-15) << unit;
  }
  EXPECT_THAT(error(zmx(front, back, "FURLONG"), "a.zmx"), AllOf(HasSubstr("line 4"), HasSubstr("UNIT FURLONG")));
}

TEST_F(ZemaxFile, ConicsAndToriKeepTheirShape) {
  const LensFile conic = lens(
      zmx(front + "  CONI -0.8\r\n", "  TYPE EVENASPH\r\n  CURV 0.016\r\n  CONI -1\r\n  PARM 1 0\r\n  PARM 2 0\r\n"),
      "a.zmx");
  EXPECT_DOUBLE_EQ(std::get<ConicSurface>(conic.lens.front).conic_constant, -0.8);
  // A parabola of radius 62.5 mm: r²/2R at 10 mm.
  EXPECT_NEAR(sag(conic.lens.back, 6e-3, 8e-3)->value, 1e-4 / (2.0 * 62.5e-3), 1e-18);
  EXPECT_NEAR(power(conic).sphere_D, expected_D, 1e-12);  // about its axis it is a sphere

  // R = 50 mm about an axis along y: curvature 20 along x, 16 along y.
  const LensFile torus = lens(zmx(front, "  TYPE TOROIDAL\r\n  CURV 0.016\r\n  PARM 1 50\r\n  PARM 2 0\r\n"), "a.zmx");
  const PowerMatrix p = *vertex_power(torus.lens).back_vertex;
  EXPECT_NEAR(p.xx(), -10.0 + 5.0 / 0.99, 1e-12);
  EXPECT_NEAR(p.yy(), -8.0 + 5.0 / 0.99, 1e-12);
  EXPECT_NEAR(sag(torus.lens.back, 10e-3, 0.0)->value, 50e-3 - std::sqrt(2500e-6 - 100e-6), 1e-17);
  EXPECT_NEAR(sag(torus.lens.back, 0.0, 10e-3)->value, 62.5e-3 - std::sqrt(62.5e-3 * 62.5e-3 - 1e-4), 1e-17);
  const LensFile cylinder = lens(zmx(front, "  TYPE TOROIDAL\r\n  CURV 0.016\r\n  PARM 1 0\r\n"), "a.zmx");
  EXPECT_NEAR(vertex_power(cylinder.lens).back.xx(), 0.0, 1e-15);
}

TEST_F(ZemaxFile, HeightsOfAGridStandOnItsConic) {
  // z = r²/2R, R = 62.5 mm, half of it from the conic (a parabola of 125 mm) and half, with a slope-free tilt-free
  // saddle x y/1000 mm, from the grid. Rows run down from the top.
  std::string grid = "  TYPE GRID_SAG\r\n  CURV 0.008\r\n  CONI -1\r\n  PARM 0 0\r\n  GDAT 33 31 2.0 2.0\r\n";
  for (int row = 0; row < 31; ++row)
    for (int column = 0; column < 33; ++column) {
      const double x = 2.0 * (column - 16), y = 2.0 * (15 - row);
      char line[120];
      std::snprintf(line, sizeof line, "  GARR %d %.15g 0 0 0\r\n", 33 * row + column + 1,
                    (x * x + y * y) / 250.0 + x * y / 1000.0);
      grid += line;
    }
  const LensFile file = lens(zmx(front, grid), "a.zmx");
  EXPECT_NEAR(sag(file.lens.back, 6e-3, 8e-3)->value, 1e-4 / 0.125 + 48e-6, 1e-10);  // h⁴ of a spline at its ends
  EXPECT_NEAR(sag(file.lens.back, -6e-3, 8e-3)->value, 1e-4 / 0.125 - 48e-6, 1e-10);
  ASSERT_EQ(file.fits.size(), 1u);
  EXPECT_EQ(file.fits[0].side, "back");
  grid.erase(grid.rfind("  GARR"));
  EXPECT_THAT(error(zmx(front, grid), "a.zmx"), AllOf(HasSubstr("surface 2"), HasSubstr("1022 heights")));
}

TEST_F(ZemaxFile, GlassesAreKnownByNameOrNumber) {
  const LensFile named = lens(zmx(front, back, "MM", "CR-39 0 0 1.5 40 0 0 0 0 0 0"), "a.zmx");
  EXPECT_DOUBLE_EQ(named.lens.refractive_index, 1.498);
  ASSERT_EQ(named.notes.size(), 1u);
  EXPECT_THAT(named.notes[0], HasSubstr("CR-39 is taken with an index of 1.498"));
  EXPECT_DOUBLE_EQ(lens(zmx(front, back, "MM", "POLYCARB 0 0"), "a.zmx").lens.refractive_index, 1.586);
  EXPECT_THAT(error(zmx(front, back, "MM", "N-UNHEARDOF9 0 0 1.5 40"), "a.zmx"),
              AllOf(HasSubstr("surface 1"), HasSubstr("N-UNHEARDOF9"), HasSubstr("\"refractive_index\"")));
  LensFileRequest request;
  request.refractive_index = 1.7;
  EXPECT_DOUBLE_EQ(lens(zmx(front, back, "MM", "N-UNHEARDOF9 0 0"), "a.zmx", request).lens.refractive_index, 1.7);
}

TEST_F(ZemaxFile, WhatIsNoSpectacleLensIsRefused) {
  EXPECT_THAT(error(zmx(front, back + "  GLAS BK7 0 0\r\n"), "a.zmx"),
              AllOf(HasSubstr("surface 2"), HasSubstr("a second glass")));
  EXPECT_THAT(error(zmx(front, back, "MM", "MIRROR 0 0"), "a.zmx"), HasSubstr("a mirror"));
  EXPECT_THAT(error(zmx(front, "  TYPE EVENASPH\r\n  CURV 0.016\r\n  PARM 2 1e-7\r\n"), "a.zmx"),
              AllOf(HasSubstr("surface 2"), HasSubstr("PARM 2"), HasSubstr("without higher terms")));
  EXPECT_THAT(error(zmx(front, "  TYPE EVENASPH\r\n  CURV 0.016\r\n  PARM 8 1e-17\r\n"), "a.zmx"),
              HasSubstr("PARM 8"));  // the last of its terms
  EXPECT_THAT(error(zmx(front, "  TYPE TOROIDAL\r\n  CURV 0.016\r\n  PARM 1 50\r\n  PARM 2 1e-7\r\n"), "a.zmx"),
              AllOf(HasSubstr("PARM 2"), HasSubstr("two circles")));
  EXPECT_THAT(error(zmx(front, "  TYPE EVENASPH\r\n  CURV 0.016\r\n  XDAT 1 0.5 0 0 1\r\n"), "a.zmx"),
              HasSubstr("XDAT other than 0"));
  EXPECT_THAT(error(zmx(front, "  TYPE BICONICX\r\n  CURV 0.016\r\n"), "a.zmx"),
              AllOf(HasSubstr("BICONICX"), HasSubstr("TOROIDAL")));
  EXPECT_THAT(error(zmx(front, "  TYPE COORDBRK\r\n"), "a.zmx"), HasSubstr("TYPE COORDBRK"));
  EXPECT_THAT(error("MODE NSC\r\nSURF 0\r\n", "a.zmx"), HasSubstr("MODE NSC"));
  EXPECT_THAT(error(zmx(front, "  TYPE STANDARD\r\n  CURV 1e300\r\n"), "a.zmx"), HasSubstr("at least 1 mm"));
  EXPECT_THAT(error("hello\n", "a.zmx"), HasSubstr("no SURF"));
  EXPECT_THAT(error("", "a.zmx"), HasSubstr("no SURF"));
  EXPECT_THAT(error("SURF 0\nCURV 0.1\nDISZ 1\n", "a.zmx"), HasSubstr("no GLAS"));
  EXPECT_THAT(error("SURF 0\nCURV 0.1\nDISZ 1\nGLAS BK7 0 0\n", "a.zmx"), HasSubstr("glass behind the last surface"));
  EXPECT_THAT(error("SURF 0\nCURV steep\n", "a.zmx"),
              AllOf(HasSubstr("line 2"), HasSubstr("\"steep\""), HasSubstr("a number in CURV")));
  EXPECT_THAT(error(zmx("  TYPE STANDARD\r\n  CURV 0.01\r\n  DISZ INFINITY\r\n", back), "a.zmx"),
              HasSubstr("without a thickness"));
  EXPECT_THAT(error("SURF 0\nGDAT 100000 100000 1 1\n", "a.zmx"), HasSubstr("2 to 4096 nodes"));
}

}  // namespace
}  // namespace sturm
