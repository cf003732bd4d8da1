// What `see_picture` leaves as it is, from the sharp picture to the seen one with all steps between.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "io/images/depth_map.h"
#include "stages/see_stage.h"
#include "wavefront/layers/plane_cases.h"

namespace sturm {
namespace {

constexpr int width = 240, height = 180;
constexpr double near_m = 0.4, far_m = 2.0;

SeeSettings seen_by(const Prescription& eye, int parts) {
  SeeSettings settings;
  settings.eye = Eye::with(eye, 5e-3);
  settings.pixel_slope = 6e-4;
  settings.parts = parts;
  return settings;
}

SeeSettings seen_by_a_myope(int parts) {
  return seen_by({-1.5, -1.0, 30.0, 0.0}, parts);
}

SeeSettings in_focus_at(double distance_m, int parts) {
  return seen_by({-1.0 / distance_m, 0.0, 0.0, 0.0}, parts);
}

bool on_the_card(int x, int y) {
  return x >= 40 && x < 110 && y >= 40 && y < 140;
}

float texture(int x, int y, int channel) {
  return static_cast<float>(0.2 + 0.1 * ((x * 7 + y * 3 + channel) % 5));
}

/// A textured card before a textured wall.
LayeredPicture card_before_wall() {
  LayeredPicture picture;
  picture.radiance = Image(width, height, 3);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      picture.vergence_D.push_back(1.0 / (on_the_card(x, y) ? near_m : far_m));
      for (int c = 0; c < 3; ++c) picture.radiance.at(x, y)[c] = texture(x, y, on_the_card(x, y) ? c : c + 1);
    }
  return picture;
}

/// The wall, known everywhere.
PictureLayer wall() {
  PictureLayer layer{Image(width, height, 3), std::vector<double>(width * height, 1.0 / far_m), {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < 3; ++c) layer.radiance.at(x, y)[c] = texture(x, y, c + 1);
  return layer;
}

class LampsInALayeredPicture : public ::testing::TestWithParam<std::pair<int, int>> {};

TEST_P(LampsInALayeredPicture, LeaveWhatTheyDoNotReach) {
  const auto [lamp_x, lamp_y] = GetParam();
  const PictureLayer dark_wall = wall();
  for (const bool wall_given : {false, true})
    for (const int parts : {1, 8}) {
      PictureLayer lit_wall = dark_wall;
      LayeredPicture dark = card_before_wall(), lit = dark;
      std::fill_n(lit.radiance.at(lamp_x, lamp_y), 3, 1e4f);
      if (!on_the_card(lamp_x, lamp_y)) std::fill_n(lit_wall.radiance.at(lamp_x, lamp_y), 3, 1e4f);
      const auto layers = [&](const PictureLayer& layer) {
        return wall_given ? std::span(&layer, 1) : std::span<const PictureLayer>();
      };
      const SeenPicture without = see_picture(dark, layers(dark_wall), seen_by_a_myope(parts)),
                        with = see_picture(lit, layers(lit_wall), seen_by_a_myope(parts));
      // Planes ascend: the wall, the card. The two pixels beside the lamp are sharpened by the colour in its place.
      const int reach = with.radii_px[on_the_card(lamp_x, lamp_y) ? 1 : 0] + 2;
      double largest = 0.0;
      for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
          if (std::max(std::abs(x - lamp_x), std::abs(y - lamp_y)) > reach)
            for (int c = 0; c < 3; ++c)
              largest = std::max<double>(largest, std::abs(with.radiance.at(x, y)[c] - without.radiance.at(x, y)[c]));
      EXPECT_LE(largest, 1e-5) << wall_given << " " << parts;
      EXPECT_GT(with.radiance.at(lamp_x, lamp_y)[0], 5.0f);  // 1e4 over some hundred pixels
    }
}

INSTANTIATE_TEST_SUITE_P(Places, LampsInALayeredPicture,
                         ::testing::Values(std::pair(180, 90),    // on the wall
                                           std::pair(75, 90),     // on the card
                                           std::pair(112, 90)));  // on the wall beside the card

/// How far the rays of the scene `two` reach [px], by the distance of their surface [m].
nlohmann::json reaches_of_two(const nlohmann::json& planes, const std::string& eye) {
  for (const nlohmann::json& one : planes.at("cases"))
    if (one.at("id") == "two_" + eye) return one.at("psf_reach_px");
  throw std::invalid_argument(eye);
}

SeenPicture with_lamp(LayeredPicture picture, int left, int top, int size, const SeeSettings& settings) {
  for (int y = top; y < top + size; ++y) std::fill_n(picture.radiance.at(left, y), 3 * size, 1e4f);
  return see_picture(picture, {}, settings);
}

class LampsInReferencePictures : public ::testing::TestWithParam<const char*> {};

TEST_P(LampsInReferencePictures, LeaveWhatTheyDoNotReach) {
  // Lamps of one, four and nine pixels all over the two surfaces, stripes and edges of stripes, but 4 px from where one
  // surface ends. What is guessed in a lamp's place sharpens the pixels beside it, so pixels beyond the kernel may know
  // of the lamp by how far the guess is from what was there. Within the reach of its rays, too, there are pixels that
  // none of them lights.
  const nlohmann::json planes = testing::reference_file("planes/planes.json"),
                       reaches = reaches_of_two(planes, GetParam());
  const auto [eye, accommodation_D] = testing::plane_eye(planes, GetParam());
  SeeSettings settings;
  settings.eye = eye;
  settings.accommodation_D = accommodation_D;
  settings.pixel_slope = testing::plane_pixel(planes);
  const LayeredPicture dark = testing::plane_picture("two", 1.0);
  LayeredPicture sharp = dark;
  const SeenPicture without = see_picture(sharp, {}, settings);
  constexpr float even = 0.5f;
  LayeredPicture grey = dark;
  std::fill(grey.radiance.pixels.begin(), grey.radiance.pixels.end(), even);
  constexpr double corners = std::numbers::sqrt2;  // half a pixel each way of the lamp's, and of the one that it lights
  double beyond = 0.0, within = 0.0;
  int lamps = 0;
  for (int lamp_y = 24; lamp_y < 300; lamp_y += 47)
    for (int lamp_x = 20; lamp_x < 300; lamp_x += 53) {
      const auto vergence_D = [&](int x, int y) { return dark.vergence_D[static_cast<std::size_t>(y) * 320 + x]; };
      const double own_D = vergence_D(lamp_x, lamp_y);
      bool edge = false;
      for (int y = lamp_y - 4; y <= lamp_y + 6; ++y)
        for (int x = lamp_x - 4; x <= lamp_x + 6; ++x) edge |= vergence_D(x, y) != own_D;
      if (edge) continue;
      const int size = 1 + ++lamps % 3;
      grey.vergence_D.assign(dark.vergence_D.size(), own_D);
      const SeenPicture with = with_lamp(dark, lamp_x, lamp_y, size, settings),
                        light = with_lamp(grey, lamp_x, lamp_y, size, settings);
      const double reach = own_D > 1.0 ? reaches.at("0.5") : reaches.at("3");
      for (int y = 0; y < 320; ++y)
        for (int x = 0; x < 320; ++x) {
          const int dx = x - std::clamp(x, lamp_x, lamp_x + size - 1),
                    dy = y - std::clamp(y, lamp_y, lamp_y + size - 1);
          const bool reached = std::hypot(dx, dy) <= reach + corners;
          if (reached && ((dx == 0 && dy == 0) || light.radiance.at(x, y)[0] != even)) continue;
          double& largest = reached ? within : beyond;
          for (int c = 0; c < 3; ++c)
            largest = std::max<double>(largest, std::abs(with.radiance.at(x, y)[c] - without.radiance.at(x, y)[c]));
        }
    }
  EXPECT_GE(lamps, 24);
  EXPECT_LE(beyond, 1e-5);
  RecordProperty("beyond", std::to_string(1e5 * beyond) + "e-5");
  RecordProperty("within", std::to_string(1e5 * within) + "e-5");
}

INSTANTIATE_TEST_SUITE_P(Eyes, LampsInReferencePictures, ::testing::Values("myope", "astigmat", "coma"));

TEST(SeePicture, LampsOnASmoothSurfaceShineNoFartherThanTheirRays) {
  // The surface goes on smoothly where the lamp is, so what surrounds it is sharpened as ever. The kernels reach the
  // last pixel that a ray of the lamp's pixel can touch.
  LayeredPicture dark = card_before_wall();
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < 3; ++c)
        dark.radiance.at(x, y)[c] = static_cast<float>(0.5 + 0.3 * std::sin(0.3 * x + c) * std::cos(0.25 * y));
  for (const auto& [lamp_x, lamp_y] : {std::pair(180, 90), {75, 90}})
    for (const int parts : {1, 8}) {
      LayeredPicture without = dark, with = dark;
      std::fill_n(with.radiance.at(lamp_x, lamp_y), 3, 1e4f);
      const SeenPicture expected = see_picture(without, {}, seen_by_a_myope(parts)),
                        got = see_picture(with, {}, seen_by_a_myope(parts));
      const int reach = got.radii_px[on_the_card(lamp_x, lamp_y) ? 1 : 0];
      for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
          if (std::max(std::abs(x - lamp_x), std::abs(y - lamp_y)) > reach) {
            ASSERT_NEAR(got.radiance.at(x, y)[0], expected.radiance.at(x, y)[0], 1e-5) << parts << " " << x << " " << y;
          }
    }
}

TEST(SeePicture, LampsOfAWideBlurShineNoFartherThanTheirRays) {
  // A lamp's disc of 8 px on the wall and on the card, whose textures are rough and have nothing to do with what is
  // guessed in a lamp's place. Its pixel is 0.5 px wide on either side of the disc's rays, and so is the pixel that it
  // lights; along a diagonal both have their corners there.
  constexpr double radius = 8.0, corners = std::numbers::sqrt2;
  const LayeredPicture dark = card_before_wall();
  for (const auto& [lamp_x, lamp_y, size] :
       {std::array{180, 90, 1}, {180, 90, 3}, {75, 90, 1}, {75, 90, 3}, {130, 30, 2}})
    for (const int parts : {1, 8}) {
      const double vergence_D = on_the_card(lamp_x, lamp_y) ? 1.0 / near_m : 1.0 / far_m;
      const double error_D = radius * 6e-4 / 2.5e-3;
      const SeeSettings settings = seen_by({error_D - vergence_D, 0.0, 0.0, 0.0}, parts);
      LayeredPicture without = dark, with = dark;
      for (int y = lamp_y; y < lamp_y + size; ++y)
        for (int x = lamp_x; x < lamp_x + size; ++x) std::fill_n(with.radiance.at(x, y), 3, 1e4f);
      const Image expected = see_picture(without, {}, settings).radiance,
                  got = see_picture(with, {}, settings).radiance;
      for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
          const int dx = x - std::clamp(x, lamp_x, lamp_x + size - 1),
                    dy = y - std::clamp(y, lamp_y, lamp_y + size - 1);
          if (std::hypot(dx, dy) > radius + corners) {
            ASSERT_NEAR(got.at(x, y)[0], expected.at(x, y)[0], 1e-5) << parts << " " << x << " " << y;
          }
        }
      EXPECT_GT(got.at(lamp_x, lamp_y)[0], 5.0f);
    }
}

TEST(SeePicture, LampsBehindASharpEdgeStayBehindIt) {
  // The card is in focus; the lamp on the wall beside it is blurred by 8 px, half of them behind the card.
  const LayeredPicture dark = card_before_wall();
  LayeredPicture lit = dark;
  std::fill_n(lit.radiance.at(113, 90), 3, 1e4f);
  for (const int parts : {1, 8}) {
    LayeredPicture without = dark, with = lit;
    const Image expected = see_picture(without, {}, in_focus_at(near_m, parts)).radiance,
                got = see_picture(with, {}, in_focus_at(near_m, parts)).radiance;
    for (int y = 60; y < 120; ++y)
      for (int x = 90; x < 110; ++x) ASSERT_NEAR(got.at(x, y)[0], expected.at(x, y)[0], 1e-5) << parts << " " << x;
    EXPECT_GT(got.at(111, 90)[0], 5.0f);
  }
}

/// What one pixel's lamp on the wall gives to pixels when a card that ends at its left hides part of the pupil: by
/// points of the pixel and of the pupil. A target at u is seen at u − a e p through the point p of a unit disc, a being
/// the pupil's radius in pixels per dioptre and e the vergence error. So a ray comes past the card where u − a (e − e₀)
/// p, e₀ being the card's error, is not on it.
Image lamp_past_the_card(int lamp_x, int lamp_y, float light, double wall_error_D) {
  constexpr double a = 2.5e-3 / 6e-4, between_D = 1.0 / near_m - 1.0 / far_m, edge = 109.5;
  constexpr int points = 200000;
  Image expected(width, height, 1);
  for (int i = 1; i <= points; ++i) {
    const auto sequence = [&](double step) { return std::fmod(i * step, 1.0); };  // [Roberts2018], four dimensions
    const double r = std::sqrt(sequence(0.8566748838545029)),
                 angle = 2.0 * std::numbers::pi * sequence(0.733891856627126);
    const double x = r * std::cos(angle), y = r * std::sin(angle);
    const double u = lamp_x - 0.5 + sequence(0.6287067210378087), v = lamp_y - 0.5 + sequence(0.5385972572236101);
    if (u + a * between_D * x < edge) continue;
    const auto column = static_cast<int>(std::floor(u - a * wall_error_D * x + 0.5)),
               row = static_cast<int>(std::floor(v - a * wall_error_D * y + 0.5));
    *expected.at(column, row) += light / points;
  }
  return expected;
}

TEST(SeePicture, LampsBehindABlurredEdgeShinePastItAsFarAsTheirRays) {
  // Neither the wall nor the card is in focus, so coverage and the lamp's light move together over the pupil.
  constexpr double focus_m = 0.8;
  constexpr float lamp = 300.0f;
  const LayeredPicture dark = card_before_wall();
  for (const int lamp_x : {111, 114})
    for (const int parts : {1, 8}) {
      LayeredPicture without = dark, with = dark;
      std::fill_n(with.radiance.at(lamp_x, 90), 3, lamp);
      const Image expected =
          lamp_past_the_card(lamp_x, 90, lamp - dark.radiance.at(lamp_x, 90)[0], 1.0 / far_m - 1.0 / focus_m);
      const Image before = see_picture(without, {}, in_focus_at(focus_m, parts)).radiance,
                  got = see_picture(with, {}, in_focus_at(focus_m, parts)).radiance;
      double wrong = 0.0, all = 0.0;
      for (int y = 70; y < 110; ++y)
        for (int x = 80; x < 140; ++x) {
          wrong += std::abs(got.at(x, y)[0] - before.at(x, y)[0] - *expected.at(x, y));
          all += *expected.at(x, y);
        }
      EXPECT_LT(wrong / all, 0.05) << lamp_x << " "
                                   << parts;  // 32768 rays on some thirty pixels, a few per cent on each
    }
}

TEST(SeePicture, LampsBesideABlurredEdgeAreNotGuessedOn) {
  // The wall is in focus and the card is blurred by 8 px: what the card's rim lets through of the wall is no lamp.
  LayeredPicture picture = card_before_wall();
  for (int x = 110; x < 113; ++x) std::fill_n(picture.radiance.at(x, 90), 3, 1e4f);
  const Image seen = see_picture(picture, {}, in_focus_at(far_m, 8)).radiance;
  EXPECT_GT(seen.at(110, 90)[0], 1e3f);
  for (int x = 90; x < 109; ++x) EXPECT_LT(seen.at(x, 90)[0], 0.7f) << x;  // the brightest of the texture is 0.6
}

TEST(SeePicture, MixedPixelsOfASharpEdgeStaySharp) {
  // Plain colours, and a column beside the card that it fills by half. The card is in focus, so the column stays,
  // though its depth is the wall's, whether the wall is known behind the card or not.
  LayeredPicture picture = card_before_wall();
  PictureLayer plain_wall = wall();
  std::fill(plain_wall.radiance.pixels.begin(), plain_wall.radiance.pixels.end(), 0.8f);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const bool half = x == 110 && y >= 40 && y < 140;
      std::fill_n(picture.radiance.at(x, y), 3, on_the_card(x, y) ? 0.2f : half ? 0.5f : 0.8f);
    }
  for (const std::size_t known : {1, 0}) {
    const Image seen = see_picture(picture, {&plain_wall, known}, in_focus_at(near_m, 8)).radiance;
    for (int y = 60; y < 120; ++y) ASSERT_NEAR(seen.at(110, y)[0], 0.5f, 1e-3) << known << " " << y;
  }
}

TEST(SeePicture, StripesKeepTheContrastThatTheBlurLeavesThem) {
  // A disc of radius r leaves 2 J₁(kr)/(kr) of stripes of period 2π/k; here k = 0.7, and 0.36 D over 2.5 mm are 1.5 px.
  // Sharing light among pixels would take another k²/12 = 4 % of them.
  constexpr double k = 0.7, r = 1.5;
  LayeredPicture picture;
  picture.radiance = Image(width, height, 3);
  picture.vergence_D.assign(width * height, 1.0);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      std::fill_n(picture.radiance.at(x, y), 3, static_cast<float>(0.5 + 0.1 * std::cos(k * x)));
  const Image seen = see_picture(picture, {}, seen_by({-0.64, 0.0, 0.0, 0.0}, 1)).radiance;
  const double left = 2.0 * std::cyl_bessel_j(1.0, k * r) / (k * r);
  for (int x = 80; x < 160; ++x) EXPECT_NEAR(seen.at(x, 90)[0], 0.5 + 0.1 * left * std::cos(k * x), 4e-4) << x;
}

TEST(SeePicture, WithHolesOfDepthKeepsItsMean) {
  // Dark but for the insides of the card and of the wall, so that no light is hidden or comes out of hiding. Every
  // seventh pixel has no depth, and a square in the card's middle; all holes have neighbours of one surface.
  LayeredPicture picture = card_before_wall();
  Image metres(width, height, 1);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const bool inside = (x >= 60 && x < 90 && y >= 60 && y < 120) || (x >= 150 && x < 210 && y >= 50 && y < 130);
      const bool hole = inside && ((x + 3 * y) % 7 == 0 || (x >= 70 && x < 80 && y >= 80 && y < 95));
      if (!inside) std::fill_n(picture.radiance.at(x, y), 3, 0.0f);
      *metres.at(x, y) = hole ? 0.0f : static_cast<float>(on_the_card(x, y) ? near_m : far_m);
    }
  const DepthMap depth = depth_of(metres, {}, "holes");
  EXPECT_GT(depth.filled_holes, 1000);
  picture.vergence_D = depth.vergence_D;
  const auto light = [](const Image& image) { return std::accumulate(image.pixels.begin(), image.pixels.end(), 0.0); };
  for (const int parts : {1, 8})
    EXPECT_NEAR(light(see_picture(picture, {}, seen_by_a_myope(parts)).radiance) / light(picture.radiance), 1.0, 5e-4)
        << parts;
}

}  // namespace
}  // namespace sturm
