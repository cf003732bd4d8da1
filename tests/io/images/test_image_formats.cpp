#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "io/images/image_formats.h"
#include "io/images/png_output.h"
#include "io/images/tone_map.h"
#include "io/io_testing.h"

namespace sturm {
namespace {

using ::testing::HasSubstr;

void write_bytes(const std::filesystem::path& path, const std::vector<unsigned char>& bytes) {
  write_text(path, std::string(bytes.begin(), bytes.end()));
}

TEST(ImageFormats, PngRoundTripKeepsAll256Values) {
  const TemporaryFolder folder;
  for (const int channels : {1, 3}) {
    Image image(64, 12 / channels, channels);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = static_cast<float>(i % 256) / 255.0f;
    const std::vector<unsigned char> bytes = encode_png(image);
    EXPECT_EQ(bytes, encode_png(image));
    write_bytes(folder / "a.png", bytes);
    const Image read = read_image(folder / "a.png");
    EXPECT_EQ(read.width, image.width);
    EXPECT_EQ(read.height, image.height);
    ASSERT_EQ(read.channels, channels);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
      ASSERT_NEAR(read.pixels[i], image.pixels[i], 1e-7) << i;  // one ulp of float near 1
  }
}

TEST(ImageFormats, PngRoundsToNearestAndClamps) {
  const TemporaryFolder folder;
  Image image(5, 1, 1);
  image.pixels = {-1.0f, 99.49f / 255.0f, 99.51f / 255.0f, 1.0f, 7.0f};
  write_bytes(folder / "a.png", encode_png(image));
  const Image read = read_image(folder / "a.png");
  const float expected[] = {0.0f, 99.0f, 100.0f, 255.0f, 255.0f};
  for (int i = 0; i < 5; ++i) EXPECT_NEAR(255.0f * read.pixels[static_cast<std::size_t>(i)], expected[i], 1e-4);
}

TEST(ImageFormats, PngOf16BitsKeepsAll65536Values) {
  const TemporaryFolder folder;
  Image image(1024, 64, 1);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = static_cast<float>(i) / 65535.0f;
  write_bytes(folder / "a.png", encode_png(image, 16));
  const StoredImage read = read_stored_image(folder / "a.png");
  EXPECT_EQ(read.bits, 16);
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    ASSERT_EQ(std::lround(65535.0f * read.image.pixels[i]), static_cast<long>(i));
}

TEST(ImageFormats, APngSaysWhatItIs) {
  Image image(3, 1, 1);
  image.pixels = {0.0f, 1.0f, 13500.0f / 65535.0f};
  const std::vector<unsigned char> bytes = encode_png(image, 16);
  const std::string file(bytes.begin(), bytes.end());
  using namespace std::string_literals;
  // PNG Specification, 11.2.1: 3 × 1 grey pixels of 16 bits, not interlaced, with the check sum by Python's zlib;
  // 11.3.2.5: sRGB, perceptual.
  EXPECT_TRUE(file.starts_with("\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR\0\0\0\3\0\0\0\1\x10\0\0\0\0\x6e\x1b\x97\x2b"s));
  EXPECT_NE(file.find("\0\0\0\1sRGB\0\xae\xce\x1c\xe9"s), std::string::npos);
  EXPECT_EQ(read_embedded_image(bytes, "made").image.pixels, image.pixels);
}

TEST(ImageFormats, RowZeroIsAtTheTop) {
  // A TGA by hand: 1 × 2 pixels, 24 bits BGR, origin at the top left (descriptor bit 5); red above blue.
  const TemporaryFolder folder;
  write_bytes(folder / "a.tga", {0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 2, 0, 24, 0x20, 0, 0, 255, 255, 0, 0});
  const Image image = read_image(folder / "a.tga");
  ASSERT_EQ(image.height, 2);
  ASSERT_EQ(image.channels, 3);
  EXPECT_EQ(image.at(0, 0)[0], 1.0f);
  EXPECT_EQ(image.at(0, 0)[2], 0.0f);
  EXPECT_EQ(image.at(0, 1)[0], 0.0f);
  EXPECT_EQ(image.at(0, 1)[2], 1.0f);
}

TEST(ImageFormats, BadFilesAreExplained) {
  const TemporaryFolder folder;
  EXPECT_THAT(input_error([&] { read_image(folder / "none.png"); }), HasSubstr("none.png: got no such file"));
  write_text(folder / "text.png", "not a picture");
  EXPECT_THAT(input_error([&] { read_image(folder / "text.png"); }), HasSubstr("text.png: got "));
  const std::vector<unsigned char> bytes = encode_png(Image(64, 64, 3));
  write_bytes(folder / "cut.png", {bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(bytes.size() / 2)});
  EXPECT_THAT(input_error([&] { read_image(folder / "cut.png"); }), HasSubstr("cut.png: got "));
}

TEST(ImageFormats, WhatAPngCannotHoldIsRefused) {
  EXPECT_THROW(encode_png(Image(2, 2, 2)), std::invalid_argument);
  EXPECT_THROW(encode_png(Image()), std::invalid_argument);
  EXPECT_THROW(encode_png(Image(2, 2, 1), 12), std::invalid_argument);
  Image nan(1, 1, 1);
  nan.pixels[0] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(encode_png(nan), std::invalid_argument);
}

TEST(ToneMap, SrgbCurveMatchesTheStandard) {
  // IEC 61966-2-1, worked out with Python's double arithmetic; 1e-3 of an 8-bit step is beyond float's rounding.
  EXPECT_NEAR(255.0f * linear_to_srgb(0.5f), 187.516f, 1e-3);
  EXPECT_NEAR(255.0f * linear_to_srgb(0.18f), 117.6456f, 1e-3);
  EXPECT_EQ(linear_to_srgb(0.0f), 0.0f);
  EXPECT_NEAR(linear_to_srgb(1.0f), 1.0f, 1e-6);
  EXPECT_NEAR(linear_to_srgb(0.001f), 0.01292f, 1e-8);
  EXPECT_NEAR(srgb_to_linear(0.5f), 0.2140411f, 1e-6);
  // The two branches meet within the standard's rounding of its constants.
  EXPECT_NEAR(linear_to_srgb(0.0031308f), linear_to_srgb(0.0031309f), 2e-6);
  for (int i = 0; i <= 255; ++i)
    EXPECT_NEAR(255.0f * linear_to_srgb(srgb_to_linear(static_cast<float>(i) / 255.0f)), i, 1e-3);
}

TEST(ToneMap, DisplaySpaceExposesThenClamps) {
  Image image(4, 1, 1);
  image.pixels = {-0.5f, 0.25f, 0.5f, 4.0f};
  const Image display = to_display(image, 2.0);
  EXPECT_EQ(display.pixels[0], 0.0f);
  EXPECT_EQ(display.pixels[1], linear_to_srgb(0.5f));
  EXPECT_NEAR(display.pixels[2], 1.0f, 1e-6);
  EXPECT_EQ(display.pixels[3], display.pixels[2]);
}

TEST(ToneMap, AlphaIsNotDecoded) {
  Image image(1, 1, 4);
  image.pixels = {0.5f, 0.5f, 0.5f, 0.5f};
  EXPECT_EQ(srgb_to_linear(image).pixels,
            (std::vector<float>{srgb_to_linear(0.5f), srgb_to_linear(0.5f), srgb_to_linear(0.5f), 0.5f}));
  Image grey(1, 1, 1);
  grey.pixels = {0.5f};
  EXPECT_EQ(srgb_to_linear(grey).pixels[0], srgb_to_linear(0.5f));
}

}  // namespace
}  // namespace sturm
