// What is said of a prediction against its bars.
#include <gtest/gtest.h>

#include "compare/findings/prediction_reasons.h"

namespace sturm {
namespace {

/// 256 paths per pixel for each of four replicates.
PictureFinding sampled_view() {
  PictureFinding view;
  view.measures = PictureMeasures::Regions;
  view.samples_per_pixel = 1024;
  view.replicates = 4;
  view.sharp_samples_per_pixel = 16;
  return view;
}

PredictionFinding prediction(double ssim, double faster) {
  PredictionFinding found;
  found.kind = PredictionKind::Layered;
  found.parts = {{.name = "whole", .ssim = Estimate{ssim, std::nullopt}}};
  found.similarity_loss = {.total = 1.0 - ssim, .reference_noise = 0.004, .prediction_noise = 0.02, .method = 0.006};
  found.squared_error = {.total = 1e-4, .prediction_noise = 6e-5, .method = 4e-5};
  found.times_faster = faster;
  found.cost_in_paths = 25.0;
  found.samples_of_equal_error = 200.0;
  found.rmse_needed = 0.0061;
  found.causes = {{.name = "lamp_rims", .pixels = 100, .squared_error = 0.62, .similarity_loss = 0.05},
                  {.name = "occlusion_edges", .pixels = 1900, .squared_error = 0.33, .similarity_loss = 0.15},
                  {.name = "blurred", .pixels = 8000, .squared_error = 0.05, .similarity_loss = 0.8}};
  return found;
}

TEST(PredictionReasons, SayWhatIsReached) {
  const PictureFinding view = sampled_view();
  const auto reasons = prediction_reasons(view, prediction(0.985, 25.0));
  ASSERT_EQ(reasons.size(), 2u);
  EXPECT_EQ(reasons[0], "SSIM 0.9850 reaches 0.98.");
  EXPECT_EQ(reasons[1], "25 × faster than path tracing to the same error (200 paths per pixel) reaches 20.");
}

TEST(PredictionReasons, SayWhatIsMissingAndWhere) {
  const PictureFinding view = sampled_view();
  const auto reasons = prediction_reasons(view, prediction(0.97, 8.0));
  ASSERT_EQ(reasons.size(), 2u);
  EXPECT_NE(
      reasons[0].find(
          "0.0300 that are missing to 1, 0.0040 are noise of the reference (1024 paths per pixel), 0.0200 noise of the "
          "prediction (sharp view of 16), 0.0060 the method. By place: 80 % elsewhere in blur (80 % of the pixels), 15 "
          "% "
          "at edges of depth (19 % of the pixels)."),
      std::string::npos)
      << reasons[0];
  EXPECT_NE(reasons[1].find("20 × needed the RMSE 0.0061 that path tracing has after 20 times as many; it has 0.01. Of "
                            "its squared error 60 %"),
            std::string::npos)
      << reasons[1];
  EXPECT_NE(reasons[1].find(
                "62 % in the blur of lamps' rims (1 % of the pixels), 33 % at edges of depth (19 % of the pixels)."),
            std::string::npos)
      << reasons[1];
  EXPECT_NE(
      prediction_reasons(view, prediction(0.978, 8.0))[0].find("without the reference's noise the bar is reached"),
      std::string::npos);
}

TEST(PredictionReasons, NameAPlaceThatIsAllOfThePicture) {
  PredictionFinding everywhere = prediction(0.97, 8.0);
  everywhere.causes = {{.name = "blurred", .pixels = 10000, .squared_error = 1.0, .similarity_loss = 1.0}};
  EXPECT_NE(prediction_reasons(sampled_view(), everywhere)[0].find("100 % elsewhere in blur (100 % of the pixels)."),
            std::string::npos);
}

TEST(PredictionReasons, AreSilentWithoutNumbers) {
  EXPECT_TRUE(prediction_reasons({}, {}).empty());
}

}  // namespace
}  // namespace sturm
