// Writes tests/reference/scene_lens/statistics.json from somebody else's renderings of that scene:
//   scene_lens_statistics SEED_A.exr SEED_B.exr > statistics.json
// Compiled by hand against sturm_io. A bulb's rectangle is its spot with a frame of background.
#include <cstdio>

#include "io/images/exr.h"
#include "support/spot_moments.h"

int main(int argc, char** argv) {
  using namespace sturm;
  struct Bulb {
    const char* name;
    testing::Rectangle rectangle;
  };
  const Bulb bulbs[] = {{"near", {168, 100, 22, 17}}, {"middle", {166, 78, 12, 10}}, {"far", {176, 65, 11, 11}}};
  std::printf(
      "{\"source\": \"Cycles (Blender 3.4.1), camera rays refracted by two finely tessellated surfaces; 1024 samples "
      "per pixel of each "
      "seed; clamping, "
      "light threshold, adaptive sampling and denoising off; 1 px box filter; 256x256\",\n\"channel_means\": \"mean R, "
      "G, B of the "
      "picture\",\n"
      "\"spots\": \"centroid from the upper left corner, y down; covariance xx, xy, yy with y up, pixel box taken off; "
      "px\",\n\"seeds\": "
      "[");
  for (int i = 1; i < argc; ++i) {
    const Image image = read_exr(argv[i]).layers.at("");
    double means[3] = {0.0, 0.0, 0.0};
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x)
        for (int k = 0; k < 3; ++k) means[k] += static_cast<double>(image.at(x, y)[k]) / (image.width * image.height);
    std::printf("%s\n{\"channel_means\": [%.9g, %.9g, %.9g], \"spots\": {", i > 1 ? "," : "", means[0], means[1],
                means[2]);
    for (const Bulb& bulb : bulbs) {
      const auto& r = bulb.rectangle;
      const auto m = testing::SpotMoments::of(image, r);
      std::printf(
          "%s\n  \"%s\": {\"rectangle\": [%d, %d, %d, %d], \"sum\": %.9g, \"centroid\": [%.9g, %.9g], \"covariance\": "
          "[%.9g, %.9g, %.9g]}",
          &bulb == bulbs ? "" : ",", bulb.name, r.x, r.y, r.width, r.height, m.sum, m.centroid_px.x(),
          m.centroid_px.y(), m.covariance_px(0, 0), m.covariance_px(0, 1), m.covariance_px(1, 1));
    }
    std::printf("}}");
  }
  std::printf("]}\n");
}
