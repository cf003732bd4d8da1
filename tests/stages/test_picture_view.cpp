#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "stages/picture_view.h"

namespace sturm {
namespace {

const char* const document = R"({"format": "sturm.render/1", "scene": "box.json",
  "camera": {"position_m": [0, 0, 0], "look_at_m": [0, 0, -1], "up": [0, 1, 0], "vfov_deg": 90, "resolution": [2, 200]},
  "eye": {"prescription": {"sphere_D": -2, "cylinder_D": 0, "axis_deg": 180, "vertex_distance_mm": 0}, "pupil_diameter_mm": 10,
          "accommodation": {"mode": "relaxed"}},
  "method": {"type": "path_trace", "ray_model": "power_matrix"}})";

LayeredImage picture(const std::string& attribute) {
  LayeredImage image;
  image.layers["depth"] = Image(2, 200, 1);
  std::fill(image.layers["depth"].pixels.begin(), image.layers["depth"].pixels.end(), 1.0f);
  *image.layers["depth"].at(1, 0) = std::numeric_limits<float>::infinity();
  image.metadata["sturm"] = attribute;
  return image;
}

std::string changed(const std::string& from, const std::string& to) {
  std::string text = document;
  return text.replace(text.find(from), from.size(), to);
}

TEST(PictureView, TellsFieldOfViewAndBlur) {
  // 90 degrees over 200 px: a pixel is 0.01 of slope. |1/d - 2| D on 5 mm: 5 mrad at 1 m, 10 mrad far away.
  const PictureView view = view_of(picture(document));
  EXPECT_NEAR(*view.pixel_slope, 0.01, 1e-15);
  EXPECT_NEAR(*view.pixels_per_degree, 1.7453292519943295, 1e-12);
  ASSERT_TRUE(view.layers.blur_px);
  EXPECT_NEAR(*view.layers.blur_px->at(0, 0), 0.5, 1e-6);
  EXPECT_NEAR(*view.layers.blur_px->at(1, 0), 1.0, 1e-6);
  EXPECT_EQ(view.missing_blur, "");
}

TEST(PictureView, HasNoBlurWhereOneFormulaDoesNotHold) {
  const PictureView sphere = view_of(picture(changed("\"vfov_deg\": 90", "\"projection\": \"equirectangular\"")));
  EXPECT_NEAR(*sphere.pixels_per_degree, 200.0 / 180.0, 1e-12);
  EXPECT_FALSE(sphere.pixel_slope);
  EXPECT_FALSE(sphere.layers.blur_px);
  EXPECT_NE(sphere.missing_blur, "");
  const PictureView foveal = view_of(picture(changed("\"vfov_deg\": 90", "\"vfov_deg\": 90, \"gaze\": \"foveal\"")));
  EXPECT_TRUE(foveal.pixel_slope);
  EXPECT_FALSE(foveal.layers.blur_px);
}

TEST(PictureView, OtherAttributesOfThatNameTellNothing) {
  for (const std::string& text :
       {std::string("{"), std::string("[]"), std::string("{\"format\": \"sturm.render/1\"}"),
        std::string("{\"format\": \"sturm.scene/1\"}"), changed("\"vfov_deg\": 90", "\"vfov_deg\": \"wide\""),
        changed("\"look_at_m\": [0, 0, -1]", "\"look_at_m\": [0, 0, 0]")}) {
    const PictureView view = view_of(picture(text));
    EXPECT_FALSE(view.pixels_per_degree) << text;
    EXPECT_FALSE(view.layers.blur_px) << text;
    EXPECT_TRUE(view.layers.depth) << text;
  }
  EXPECT_FALSE(view_of(LayeredImage{}).layers.depth);
}

TEST(PictureView, TheOtherPictureHelpsOut) {
  LayeredImage plain;
  plain.layers[""] = Image(2, 200, 3);
  EXPECT_TRUE(view_of(plain, picture(document)).layers.blur_px);
  EXPECT_TRUE(view_of(picture(document), plain).layers.blur_px);
  EXPECT_EQ(view_of(plain, picture(document)).missing_blur, "");
}

}  // namespace
}  // namespace sturm
