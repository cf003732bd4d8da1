// What no blur may change: constant pictures, the sum of all light, and what lies beyond the reach of a light.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "wavefront/layers/flat_pictures.h"
#include "wavefront/layers/lamps.h"
#include "wavefront/layers/wave_kernels.h"

namespace sturm {
namespace {

using testing::astigmatic_myope;
using testing::flat_pixel;

float texture(int x, int y, int channel) {
  return static_cast<float>(0.2 + 0.1 * ((x * 7 + y * 3 + channel) % 5));
}

TEST(KeptLight, ConstantPicturesStayInEveryColour) {
  // Three distances, and a colour whose channels differ; each channel has kernels of its own.
  LayeredPicture picture = testing::flat_picture(300, 200, 1.0);
  const float colour[] = {0.37f, 0.21f, 0.83f};
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 300; ++x) {
      picture.vergence_D[static_cast<std::size_t>(y) * 300 + x] = x < 150 ? 3.0 : y < 100 ? 1.0 : 0.2;
      std::copy_n(colour, 3, picture.radiance.at(x, y));
    }
  const Eye eye = astigmatic_myope(4.0);
  for (const KernelModel& model :
       {ray_kernels(eye, 0.0, flat_pixel, {1, true}), ray_kernels(eye, 0.0, flat_pixel, {4, true}),
        wave_kernels(eye, 0.0, flat_pixel, true)}) {
    ASSERT_EQ(model.channels, 3);
    const Image seen = testing::seen_through(model, picture);
    for (std::size_t i = 0; i < seen.pixels.size(); ++i) ASSERT_NEAR(seen.pixels[i], colour[i % 3], 1e-6);
  }
}

/// The columns and rows from `margin` on, to the other end less `margin`.
LayeredPicture cut(const LayeredPicture& whole, int margin) {
  LayeredPicture part =
      testing::flat_picture(whole.radiance.width - 2 * margin, whole.radiance.height - 2 * margin, 0.0);
  for (int y = 0; y < part.radiance.height; ++y)
    for (int x = 0; x < part.radiance.width; ++x) {
      std::copy_n(whole.radiance.at(x + margin, y + margin), 3, part.radiance.at(x, y));
      part.vergence_D[static_cast<std::size_t>(y) * part.radiance.width + x] =
          whole.vergence_D[static_cast<std::size_t>(y + margin) * whole.radiance.width + x + margin];
    }
  for (HiddenPixel hidden : whole.hidden) {
    hidden.x -= margin;
    hidden.y -= margin;
    if (hidden.x >= 0 && hidden.y >= 0 && hidden.x < part.radiance.width && hidden.y < part.radiance.height)
      part.hidden.push_back(hidden);
  }
  return part;
}

TEST(KeptLight, TexturedEdgesMayLeaveThePicture) {
  // A card with an oblique edge that crosses the border, before a wall that is known everywhere. The same picture with
  // more about it tells what is right: beyond the reach of the border nothing changes; within it colours are means of
  // those within the picture, neither darker nor brighter.
  constexpr int margin = 50, width = 400, height = 300;
  LayeredPicture whole = testing::flat_picture(width, height, 0.2);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const bool card = 2 * x + y < 400;
      for (int c = 0; c < 3; ++c) whole.radiance.at(x, y)[c] = texture(x, y, card ? c : c + 2) + (card ? 0.4f : 0.0f);
      if (card) {
        whole.vergence_D[static_cast<std::size_t>(y) * width + x] = 2.5;
        const float wall = texture(x, y, 2);
        whole.hidden.push_back({x, y, 0.2, 1.0f, {wall, wall, wall}});
      }
    }
  for (const int parts : {1, 4}) {
    const KernelModel model = ray_kernels(astigmatic_myope(5.0), 0.0, flat_pixel, {parts, false});
    const int reach = KernelBank(model, {0.2, 2.5}).largest_radius_px();
    const Image expected = testing::seen_through(model, whole), seen = testing::seen_through(model, cut(whole, margin));
    ASSERT_LT(reach, margin);
    for (int y = 0; y < seen.height; ++y)
      for (int x = 0; x < seen.width; ++x) {
        const float got = seen.at(x, y)[1];
        if (std::min({x, y, seen.width - 1 - x, seen.height - 1 - y}) >= reach) {
          ASSERT_NEAR(got, expected.at(x + margin, y + margin)[1], 1e-5) << parts << " " << x << " " << y;
        }
        ASSERT_GE(got, 0.2f - 1e-5f) << parts << " " << x << " " << y;
        ASSERT_LE(got, 1.0f + 1e-5f) << parts << " " << x << " " << y;
      }
  }
}

/// A lit card before a dark wall with a lit patch that no blur of the card reaches, and what a lamp adds at a pixel.
LayeredPicture card_and_patch() {
  LayeredPicture picture = testing::flat_picture(600, 400, 0.5);
  for (int y = 120; y < 280; ++y)
    for (int x = 100; x < 500; ++x) {
      if (x < 260) picture.vergence_D[static_cast<std::size_t>(y) * 600 + x] = 2.5;
      if (x < 260 || x >= 400)
        for (int c = 0; c < 3; ++c) picture.radiance.at(x, y)[c] = texture(x, y, c);
    }
  return picture;
}

Image seen_with_lamps(LayeredPicture picture, const KernelModel& model) {
  picture.jump_D = 1.0 / model.reach_px_per_D;
  take_lamps(picture);
  picture.shows_detail = true;
  return testing::seen_through(model, std::move(picture));
}

TEST(KeptLight, LampsKeepTheirsBesideSurfacesAtSeveralDistances) {
  // One on the wall and one on the card, from whose edges the blur of neither reaches the other.
  const LayeredPicture dark = card_and_patch();
  LayeredPicture lit = dark;
  double added = 0.0;
  for (const auto& [x, y] : {std::pair(450, 200), {180, 200}, {330, 60}})
    for (int c = 0; c < 3; ++c) {
      added += 1e4 - lit.radiance.at(x, y)[c];
      lit.radiance.at(x, y)[c] = 1e4f;
    }
  for (const int parts : {1, 4}) {
    const KernelModel model = ray_kernels(astigmatic_myope(5.0), 0.0, flat_pixel, {parts, false});
    const double with = testing::light(seen_with_lamps(lit, model)),
                 without = testing::light(seen_with_lamps(dark, model));
    EXPECT_NEAR(without / testing::light(dark.radiance), 1.0, 5e-4) << parts;
    EXPECT_NEAR((with - without) / added, 1.0, 1e-5) << parts;  // of sums of 720 000 pixels in single precision
  }
}

}  // namespace
}  // namespace sturm
