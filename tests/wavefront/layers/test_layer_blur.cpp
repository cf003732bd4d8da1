#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "wavefront/layers/flat_pictures.h"

namespace sturm {
namespace {

using testing::flat_picture;
using testing::light;

constexpr double pixel = testing::flat_pixel;

Eye myope(double pupil_mm) {
  return testing::astigmatic_myope(pupil_mm);
}

Image seen(const LayeredPicture& picture, const Eye& eye, int parts = 1) {
  return testing::seen_through(ray_kernels(eye, 0.0, pixel, {parts, false}), picture);
}

TEST(LayerBlur, ConstantPictureStays) {
  LayeredPicture picture = flat_picture(400, 300, 1.0);
  for (int y = 0; y < 300; ++y)
    for (int x = 0; x < 400; ++x) {
      picture.vergence_D[static_cast<std::size_t>(y) * 400 + x] = x < 200 ? 3.0 : y < 150 ? 1.0 : 0.2;
      std::fill_n(picture.radiance.at(x, y), 3, 0.37f);
    }
  for (const int parts : {1, 4})
    for (const float value : seen(picture, myope(5.0), parts).pixels) EXPECT_NEAR(value, 0.37f, 1e-6);
}

TEST(LayerBlur, LightAwayFromTheBorderIsKept) {
  LayeredPicture picture = flat_picture(600, 300, 0.5);
  for (int y = 100; y < 200; ++y)
    for (int x = 200; x < 400; ++x)
      for (int c = 0; c < 3; ++c)
        picture.radiance.at(x, y)[c] = static_cast<float>(0.2 + 0.1 * ((x * 7 + y * 3 + c) % 5));
  EXPECT_NEAR(light(seen(picture, myope(6.0))) / light(picture.radiance), 1.0, 1e-6);
}

TEST(LayerBlur, LightOfSurfacesAtSeveralDistancesIsKept) {
  // A lit card before a dark wall, and a lit patch of the wall that no blur of the card reaches.
  LayeredPicture picture = flat_picture(600, 400, 0.5);
  for (int y = 120; y < 280; ++y)
    for (int x = 100; x < 500; ++x) {
      if (x < 260) picture.vergence_D[static_cast<std::size_t>(y) * 600 + x] = 2.5;
      if (x < 260 || x >= 400)
        for (int c = 0; c < 3; ++c)
          picture.radiance.at(x, y)[c] = static_cast<float>(0.2 + 0.1 * ((x * 7 + y * 3 + c) % 5));
    }
  for (const int parts : {1, 4})
    EXPECT_NEAR(light(seen(picture, myope(5.0), parts)) / light(picture.radiance), 1.0, 5e-4) << parts;
}

TEST(LayerBlur, ADarkObjectTakesTheLightThatItCovers) {
  // A dark card at 0.4 m, seen sharply, before a blurred bright wall: outside of the card the wall is as bright as
  // ever.
  LayeredPicture picture = flat_picture(400, 300, 0.0);
  std::fill(picture.radiance.pixels.begin(), picture.radiance.pixels.end(), 0.8f);
  for (int y = 100; y < 200; ++y)
    for (int x = 150; x < 250; ++x) {
      picture.vergence_D[static_cast<std::size_t>(y) * 400 + x] = 2.5;
      std::fill_n(picture.radiance.at(x, y), 3, 0.0f);
    }
  const Eye eye = Eye::with(Prescription{-2.5, 0.0, 0.0, 0.0}, 5e-3);
  for (const int parts : {1, 4}) {
    const Image test = seen(picture, eye, parts);
    for (int x = 0; x < 400; ++x)
      ASSERT_NEAR(test.at(x, 150)[0], x >= 150 && x < 250 ? 0.0f : 0.8f, 1e-5) << parts << " " << x;
  }
}

TEST(LayerBlur, FlatPictureIsTheConvolutionByItsKernel) {
  LayeredPicture picture = flat_picture(300, 260, 0.8);
  for (std::size_t i = 0; i < picture.radiance.pixels.size(); ++i)
    picture.radiance.pixels[i] = static_cast<float>((i * 2654435761u >> 16) % 1000) / 1000.0f;
  const SpreadKernel kernel = ray_kernels(myope(6.0), 0.0, pixel, {}).kernel(0.8, 0, 0);
  ASSERT_GT(kernel.radius_px, 6);
  const Image test = seen(picture, myope(6.0));
  for (const auto& [x, y] : {std::pair{150, 130}, {40, 200}, {230, 128}, {200, 60}})
    for (int c = 0; c < 3; ++c) {
      double sum = 0.0;
      for (int dy = -kernel.radius_px; dy <= kernel.radius_px; ++dy)
        for (int dx = -kernel.radius_px; dx <= kernel.radius_px; ++dx)
          sum += kernel.weight(dx, dy) * picture.radiance.at(x - dx, y - dy)[c];
      EXPECT_NEAR(test.at(x, y)[c], sum, 1e-5);
    }
}

TEST(LayerBlur, LampLeavesWhatItDoesNotReach) {
  LayeredPicture dark = flat_picture(500, 300, 0.5);
  for (std::size_t i = 0; i < dark.radiance.pixels.size(); ++i)
    dark.radiance.pixels[i] = 0.3f + 0.1f * static_cast<float>(i % 7);
  LayeredPicture lit = dark;
  for (int c = 0; c < 3; ++c) lit.radiance.at(120, 130)[c] = 1e4f;
  const Image without = seen(dark, myope(6.0)), with = seen(lit, myope(6.0));
  const int reach = ray_kernels(myope(6.0), 0.0, pixel, {}).kernel(0.5, 0, 0).radius_px;
  for (int y = 0; y < 300; ++y)
    for (int x = 0; x < 500; ++x)
      if (std::max(std::abs(x - 120), std::abs(y - 130)) > reach) {
        ASSERT_NEAR(with.at(x, y)[0], without.at(x, y)[0], 1e-5);
      }
  EXPECT_GT(with.at(121, 131)[0], 5.0f);  // 1e4 over a kernel of some hundred pixels
}

TEST(LayerBlur, LampIsSpreadByItsKernel) {
  // Coma upwards and to the side: the kernel of this eye is not its own mirror image.
  const Eye eye = Eye::with(ZernikeWave::from_examiner(std::vector<double>{0, 0, 0, 0, 0, 0, 0, 3e-6, 1.5e-6}, 3e-3),
                            SecondOrder::LeastSquares, std::nullopt, 6e-3);
  const KernelModel model = ray_kernels(eye, 0.0, pixel, {});
  const SpreadKernel kernel = model.kernel(2.0, 0, 0);
  LayeredPicture picture = flat_picture(300, 260, 2.0);
  std::fill(picture.radiance.pixels.begin(), picture.radiance.pixels.end(), 0.3f);
  std::fill_n(picture.radiance.at(150, 130), 3, 1e4f);
  BlurCounters work;
  const Image test = blur_layers(picture, KernelBank(model, {2.0}), work);
  ASSERT_GT(work.lamp_pixels, 0);
  double asymmetry = 0.0;
  for (int dy = -kernel.radius_px; dy <= kernel.radius_px; ++dy)
    for (int dx = -kernel.radius_px; dx <= kernel.radius_px; ++dx) {
      EXPECT_NEAR(test.at(150 + dx, 130 + dy)[0], 0.3 + (1e4 - 0.3) * kernel.weight(dx, dy), 1e-2);
      asymmetry += std::abs(kernel.weight(dx, dy) - kernel.weight(-dx, -dy));
    }
  EXPECT_GT(asymmetry, 0.3);
}

TEST(LayerBlur, NothingIsNegativeAndNothingWrapsAround) {
  LayeredPicture picture = flat_picture(260, 260, 0.5);
  for (int y = 0; y < 260; ++y) std::fill_n(picture.radiance.at(0, y), 3, 50.0f);
  const Image test = seen(picture, myope(6.0));
  for (const float value : test.pixels) ASSERT_GE(value, 0.0f);
  for (int y = 0; y < 260; ++y) ASSERT_LT(test.at(259, y)[0], 1e-5f);
}

TEST(LayerBlur, SameBitsForAnyNumberOfThreads) {
  LayeredPicture picture = flat_picture(600, 400, 0.5);
  for (std::size_t i = 0; i < picture.vergence_D.size(); ++i) {
    picture.vergence_D[i] = 0.2 + 2.0 * static_cast<double>(i % 600) / 600.0;
    picture.radiance.pixels[3 * i] = static_cast<float>(i % 11);
  }
  const Image many = seen(picture, myope(5.0), 4);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(seen(picture, myope(5.0), 4).pixels, many.pixels);
}

TEST(LayerBlur, SlantedSurfaceHasNoSteps) {
  LayeredPicture picture = flat_picture(300, 400, 0.0);
  for (int y = 0; y < 400; ++y)
    for (int x = 0; x < 300; ++x) {
      picture.vergence_D[static_cast<std::size_t>(y) * 300 + x] = 0.1 + (3.3 - 0.1) * y / 399.0;
      std::fill_n(picture.radiance.at(x, y), 3, static_cast<float>(0.2 + 0.6 * x / 299.0));
    }
  const Image test = seen(picture, myope(5.0), 4);
  // A ramp across the slant stays a ramp, up to the spread of the kernel's mean (none for a second-order eye).
  for (int y = 40; y < 360; ++y)
    for (int x = 60; x < 240; x += 20) {
      ASSERT_NEAR(test.at(x, y)[0], 0.2 + 0.6 * x / 299.0, 0.002);
      ASSERT_LT(std::abs(test.at(x, y)[0] - test.at(x, y - 1)[0]), 1.0 / 255.0);
    }
}

TEST(LayerBlur, StripesOnASlantedSurfaceFadeEvenly) {
  // Upright stripes of a period of 16 px on a surface that leans from 0.1 to 3.3 D. Through the pupil point p a pixel
  // at y' shows the surface at y = (y' + V₀ p_y)/(1 − s p_y), V(y) = V₀ + s y, p in px per dioptre; its stripes are
  // moved by V(y) p_x. The mean over the pupil is what is left of them.
  constexpr int width = 160, height = 400, rings = 40, spokes = 160;
  constexpr double near_D = 0.1, slope_D = 3.2 / height, turns = 2.0 * 3.14159265358979 / 16.0, radius = 5.0;
  LayeredPicture picture = flat_picture(width, height, 0.0);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      picture.vergence_D[static_cast<std::size_t>(y) * width + x] = near_D + slope_D * y;
      std::fill_n(picture.radiance.at(x, y), 3, static_cast<float>(0.5 + 0.3 * std::cos(turns * x)));
    }
  const Image test = seen(picture, Eye::with(Prescription{0.0, 0.0, 0.0, 0.0}, 2.0 * radius * pixel), 4);
  // Sharing light linearly among pixels takes sinc²(1/16) of the stripes.
  const double shared = std::pow(std::sin(turns / 2.0) / (turns / 2.0), 2);
  double square = 0.0, largest_step = 0.0, before = 0.0;
  for (int y = 40; y < 360; ++y) {
    double left = 0.0;
    for (int ring = 0; ring < rings; ++ring)
      for (int spoke = 0; spoke < spokes; ++spoke) {
        const double r = radius * std::sqrt((ring + 0.5) / rings), angle = 2.0 * 3.14159265358979 * spoke / spokes;
        const double at = (y + near_D * r * std::sin(angle)) / (1.0 - slope_D * r * std::sin(angle));
        left += std::cos(turns * (near_D + slope_D * at) * r * std::cos(angle)) / (rings * spokes);
      }
    const double got = test.at(80, y)[0];  // the middle of a stripe
    square += std::pow(got - (0.5 + 0.3 * shared * left), 2) / 320.0;
    if (y > 40) largest_step = std::max(largest_step, std::abs(got - before));
    before = got;
  }
  EXPECT_LE(std::sqrt(square), 0.002);
  EXPECT_LE(largest_step, 1.0 / 255.0);
}

TEST(LayerBlur, NothingShinesThroughASlantedSurface) {
  // A bright surface that leans in both directions before a dark wall that is known everywhere. Each part of the pupil
  // sees it larger or smaller, by up to 2 % here, and covers the wall all the same.
  constexpr int side = 300;
  for (const auto& [slope_x, slope_y] : {std::pair(0.01, 0.0), {0.0, 0.01}, {-0.006, 0.008}}) {
    LayeredPicture picture = flat_picture(side, side, 0.0);
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) {
        picture.vergence_D[static_cast<std::size_t>(y) * side + x] = 3.0 + slope_x * (x - 150) + slope_y * (y - 150);
        std::fill_n(picture.radiance.at(x, y), 3, 0.6f);
        picture.hidden.push_back({x, y, 0.1, 1.0f, {0.0f, 0.0f, 0.0f}});
      }
    const KernelModel model = ray_kernels(Eye::with(Prescription{-3.0, 0.0, 0.0, 0.0}, 4e-3), 0.0, pixel, {4, false});
    picture.jump_D = 1.0 / model.reach_px_per_D;
    BlurCounters work;
    std::vector<double> vergences = picture.vergence_D;
    vergences.push_back(0.1);
    const Image test = blur_layers(picture, KernelBank(model, planes_for(vergences, model.reach_px_per_D)), work);
    for (int y = 60; y < side - 60; ++y)
      for (int x = 60; x < side - 60; ++x) ASSERT_NEAR(test.at(x, y)[0], 0.6f, 1.5e-3) << x << " " << y;
  }
}

}  // namespace
}  // namespace sturm
