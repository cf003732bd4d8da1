#include <gmock/gmock.h>

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "io/json/schema.h"
#include "io/specs/lens_files/lens_file_testing.h"
#include "io/specs/spectacles_spec.h"

namespace sturm {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::string job =
    "JOB=4711\r\nDO=B\r\nSPH=-2.00;+1.25\r\nCYL=-1.50;0.00\r\nAX=30;?\r\nLIND=1.498;1.498\r\nCTHICK=2.00;3.10\r\n"
    "FRNT=4.25;6.00\r\nDIA=65;60\r\nTIND=1.530\r\n";

class VcaFile : public LensFileTest {
 protected:
  static LensFileRequest eye(EyeSide side) {
    LensFileRequest request;
    request.eye = side;
    return request;
  }
};

TEST_F(VcaFile, AJobMakesTheLensOfItsPrescription) {
  const LensFile right = lens(job, "job.oma", eye(EyeSide::right));
  EXPECT_NEAR(power(right).sphere_D, -2.0, 1e-12);
  EXPECT_NEAR(power(right).cylinder_D, -1.5, 1e-12);
  EXPECT_NEAR(power(right).axis_deg, 30.0, 1e-9);
  EXPECT_DOUBLE_EQ(right.lens.diameter_m, 65e-3);
  // The curve is stated for the tooling index 1.53: R = 530/4.25 mm.
  EXPECT_NEAR(std::get<SphereSurface>(right.lens.front).curvature, 4.25 / 0.53, 1e-12);
  const LensFile left = lens(job, "job.oma", eye(EyeSide::left));
  EXPECT_NEAR(power(left).sphere_D, 1.25, 1e-12);
  EXPECT_NEAR(power(left).cylinder_D, 0.0, 1e-12);
  EXPECT_DOUBLE_EQ(left.lens.center_thickness_m, 3.1e-3);
  EXPECT_THAT(error(job, "job.oma"), AllOf(HasSubstr("a job for both eyes"), HasSubstr("\"eye\"")));
}

TEST_F(VcaFile, IsReadAsDevicesWriteIt) {
  for (const std::string& text : {std::string("do=R\nsph=-2.00\ncyl=-1.50\nax=30\nlind=1.498\ncthick=2\nfrnt=4.25\n"),
                                  std::string("\x1CREQ=LEN\x1DSPH = -2.00 ; ?\x1D"
                                              "CYL=-1.50;\x1D"
                                              "AX=030;\x1DLIND=1.498;\x1D"
                                              "CTHICK=2.0;\x1D"
                                              "FRNT=4.25;\x1E"),
                                  std::string("SPH=-2.00;\rCYL=-1,50;\rAX=30;\rLIND=1.498;\rCTHICK=2;\rFRNT=4.25;\r")})
    EXPECT_NEAR(power(lens(text, "JOB.OMA")).cylinder_D, -1.5, 1e-12) << text;
  const LensFile noted = lens(job + "_X=1\r\nLMATID=1;1\r\nSPH=-2.00;0\r\n", "job.vca", eye(EyeSide::right));
  EXPECT_THAT(noted.notes,
              ElementsAre(HasSubstr("records SPH the last one counts"), HasSubstr("do not count: LMATID, _X")));
}

TEST_F(VcaFile, SurfacesWithoutAPrescriptionMakeTheLens) {
  // Radii 530/6 and 530/4 mm, index 1.6, 3 mm: F₁ = 0.6·6/0.53, F₂ = −0.6·4/0.53.
  const double front = 0.6 * 6.0 / 0.53, back = -0.6 * 4.0 / 0.53;
  for (const char* curve : {"4.00", "-4.00"}) {
    const LensFile file =
        lens(std::string("DO=L\nFRNT=;6.00\nBACK=;") + curve + "\nLIND=;1.6\nCTHICK=;3.0\n", "job.lms");
    EXPECT_NEAR(power(file).sphere_D, back + front / (1.0 - 0.003 / 1.6 * front), 1e-12);
    EXPECT_FALSE(file.made_for);
  }
}

TEST_F(VcaFile, HeightsStandAsAnExaminerSeesThem) {
  // A back of two curvatures: z = 8 x²/2 + 12 y²/2 [m⁻¹] + 1 x y; first row at the top, first column at the examiner's
  // left, which is the wearer's right.
  std::string text = "DO=R\nLIND=1.5\nCTHICK=2\nDIA=50\nFRNT=5.3\nSURFMT=1;R;B;61;61;60;60;0\n";
  for (int row = 0; row < 61; ++row) {
    text += "ZZ=";
    for (int column = 0; column < 61; ++column) {
      const double x = 30.0 - column, y = 30.0 - row;
      char cell[40];
      std::snprintf(cell, sizeof cell, "%s%.9f", column ? ";" : "", (4.0 * x * x + 6.0 * y * y + x * y) * 1e-3);
      text += cell;
    }
    text += "\n";
  }
  const LensFile file = lens(text, "job.sdf");
  const PowerMatrix back = vertex_power(file.lens).back;
  EXPECT_NEAR(back.xx(), -0.5 * 8.0, 1e-5);  // nine digits of heights: 1e-12 m / h² at h = 1 mm
  EXPECT_NEAR(back.yy(), -0.5 * 12.0, 1e-5);
  EXPECT_NEAR(back.xy(), -0.5 * 1.0, 1e-5);
  EXPECT_NEAR(vertex_power(file.lens).front.xx(), 5.3 * 0.5 / 0.53, 1e-12);
  ASSERT_EQ(file.fits.size(), 1u);
  const LensFile prismatic = lens(text + "SPH=-1.00\nPRVM=2\nPRVA=90\n", "job.sdf");
  EXPECT_DOUBLE_EQ(prismatic.made_for->prism_cm_per_m, 2.0);
  EXPECT_EQ(prismatic.prism_cm_per_m, 0.0);  // heights have it in them
  text.erase(text.rfind("ZZ="));
  EXPECT_THAT(error(text, "job.sdf"),
              AllOf(HasSubstr("line 6"), HasSubstr("3660 heights"), HasSubstr("61 records ZZ")));
}

TEST_F(VcaFile, EachEyeHasItsOwnHeights) {
  // Backs z = c r²/2 with c = 6 m⁻¹ of the left eye, which stands first, and 10 m⁻¹ of the right one; a semicolon ends
  // each row.
  std::string text = "DO=B\nLIND=1.5\nCTHICK=2\nDIA=40\nFRNT=5.3\nTIND=1.5\n";
  for (const auto& [side, curvature] : {std::pair("L", 6.0), {"R", 10.0}}) {
    text += std::string("SURFMT=1;") + side + ";B;41;41;40;40\n";
    for (int row = 0; row < 41; ++row) {
      text += "ZZ=";
      for (int column = 0; column < 41; ++column) {
        const double x = column - 20.0, y = row - 20.0;
        char cell[40];
        std::snprintf(cell, sizeof cell, "%.9f;", 0.5e-3 * curvature * (x * x + y * y));
        text += cell;
      }
      text += "\n";
    }
  }
  // Nine digits of heights: 1e-12 m / h² at h = 1 mm.
  EXPECT_NEAR(vertex_power(lens(text, "job.sdf", eye(EyeSide::right)).lens).back.xx(), -0.5 * 10.0, 1e-5);
  EXPECT_NEAR(vertex_power(lens(text, "job.sdf", eye(EyeSide::left)).lens).back.xx(), -0.5 * 6.0, 1e-5);
  // The front's curve is stated for 1.5, the lens's own index.
  EXPECT_NEAR(vertex_power(lens(text, "job.sdf", eye(EyeSide::left)).lens).front.xx(), 5.3, 1e-12);
}

TEST_F(VcaFile, PrismsAndAdditionsAreNotLost) {
  const std::string prism = job + "PRVM=2.00;1.50\r\nPRVA=90;180\r\nADD=2.00;2.00\r\n";
  const LensFile file = lens(prism, "job.oma", eye(EyeSide::right));
  EXPECT_EQ(file.made_for->prism_cm_per_m, 2.0);
  EXPECT_EQ(file.made_for->prism_base_deg, 90.0);
  EXPECT_EQ(file.prism_cm_per_m, 2.0);
  EXPECT_THAT(file.notes, ElementsAre(HasSubstr("addition of 2 D is not made")));
  // Base in of a left eye is on the examiner's left.
  const LensFile left = lens(job + "PRVIN=0;1.5\r\nPRVUP=0;0\r\n", "job.oma", eye(EyeSide::left));
  EXPECT_DOUBLE_EQ(left.made_for->prism_cm_per_m, 1.5);
  EXPECT_DOUBLE_EQ(left.made_for->prism_base_deg, 180.0);
  const LensFile down = lens(job + "PRVUP=-1.5;0\r\n", "job.oma", eye(EyeSide::right));
  EXPECT_DOUBLE_EQ(down.made_for->prism_cm_per_m, 1.5);
  EXPECT_DOUBLE_EQ(down.made_for->prism_base_deg, 270.0);
  EXPECT_THAT(error(job + "PRVM=2;2\r\n", "job.oma", eye(EyeSide::right)),
              AllOf(HasSubstr("line 11"), HasSubstr("no PRVA")));
}

TEST_F(VcaFile, WhatIsMissingIsNamed) {
  EXPECT_THAT(error("hello\n", "a.oma"), HasSubstr("no records"));
  EXPECT_THAT(error("SPH=-1\nCTHICK=2\n", "a.oma"), HasSubstr("no LIND"));
  EXPECT_THAT(error("SPH=-1\nLIND=1.5\n", "a.oma"), HasSubstr("no CTHICK"));
  EXPECT_THAT(error("FRNT=4\nLIND=1.5\nCTHICK=2\n", "a.oma"), HasSubstr("no BACK for the right eye"));
  EXPECT_THAT(error("SPH=-1\nCYL=-1\nLIND=1.5\nCTHICK=2\n", "a.oma"), AllOf(HasSubstr("line 2"), HasSubstr("no AX")));
  EXPECT_THAT(error("SPH=strong\nLIND=1.5\nCTHICK=2\n", "a.oma"), AllOf(HasSubstr("line 1"), HasSubstr("SPH=strong")));
  EXPECT_THAT(error("SPH=-1\nLIND=0.5\nCTHICK=2\n", "a.oma"), AllOf(HasSubstr("LIND=0.5"), HasSubstr("1.1")));
  EXPECT_THAT(error("SURFMT=1;R;B;3000000;5;60;60\n", "a.oma"), HasSubstr("4 to 2048"));
  EXPECT_THAT(error("ZZ=1;2\n", "a.oma"), HasSubstr("SURFMT before"));
}

TEST_F(VcaFile, IsALensOfADocument) {
  write_text(folder_ / "job.oma", job + "PRVM=2.00;0\r\nPRVA=90;0\r\n");
  const Source where{(folder_ / "eye.json").string(), ""};
  const Json document = {
      {"format", "sturm.spectacles/1"},
      {"lens_file", {{"file", "job.oma"}, {"eye", "right"}, {"vertex_distance_mm", 14}, {"diameter_mm", 50}}}};
  validate(document, "spectacles", where.file);
  const SpectaclesSpec spec = read_lens_alone(document, where);
  EXPECT_DOUBLE_EQ(spec.lens->vertex_distance_m, 14e-3);
  EXPECT_DOUBLE_EQ(spec.lens->diameter_m, 50e-3);
  EXPECT_TRUE(spec.lens->mounting.has_wedge());
  ASSERT_EQ(spec.input_files.size(), 1u);
  EXPECT_EQ(spec.input_files[0], (folder_ / "job.oma").string());
  EXPECT_EQ(spec.made_for->cylinder_D, -1.5);
  EXPECT_THAT(input_error([&] { read_spectacles("job.oma", where, Eye{}); }), HasSubstr("a job for both eyes"));
  EXPECT_THAT(input_error([&] { read_spectacles("none.zmx", where, Eye{}); }),
              AllOf(HasSubstr("none.zmx"), HasSubstr("there is no file")));
}

}  // namespace
}  // namespace sturm
