#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfRgbaFile.h>
#include <OpenEXR/ImfTiledOutputFile.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "io/images/exr.h"
#include "io/images/exr_channels.h"
#include "io/images/image_formats.h"
#include "io/images/picture_file.h"
#include "io/images/portable_float_map.h"
#include "io/images/radiance_hdr.h"
#include "io/io_testing.h"

namespace sturm {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Pair;
using ::testing::UnorderedElementsAre;

TEST(ExrChannels, RolesAndLayers) {
  EXPECT_EQ(channel_role(".R"), "R");
  EXPECT_EQ(channel_role("ViewLayer.Combined.g"), "G");
  EXPECT_EQ(channel_role("Blue"), "B");
  EXPECT_EQ(channel_role("id"), "id");
  EXPECT_EQ(channel_layer("..R"), "");
  EXPECT_EQ(channel_layer("ViewLayer.Combined.R"), "ViewLayer.Combined");
  EXPECT_THAT(layers_of_channels({"R", "G", "B", "r", "depth.Z", ".y"}),
              UnorderedElementsAre(Pair("", ElementsAre("R", "G", "B")), Pair("r", ElementsAre("r")),
                                   Pair("depth", ElementsAre("depth.Z")), Pair("y", ElementsAre(".y"))));
  // The exact name is the colour, whatever stands before it.
  EXPECT_THAT(layers_of_channels({"r", "R", "G", "B"}),
              UnorderedElementsAre(Pair("", ElementsAre("R", "G", "B")), Pair("r", ElementsAre("r"))));
}

TEST(PictureFile, TilesAndMipmapsAreRead) {
  const TemporaryFolder folder;
  Imf::Header header(70, 50);
  for (const char* channel : {"R", "G", "B"}) header.channels().insert(channel, Imf::Channel(Imf::FLOAT));
  header.setTileDescription(Imf::TileDescription(32, 32, Imf::MIPMAP_LEVELS));
  Image image(70, 50, 3);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = static_cast<float>(i);
  {
    Imf::TiledOutputFile file((folder / "t.exr").c_str(), header);
    Imf::FrameBuffer frame;
    for (int c = 0; c < 3; ++c)
      frame.insert(std::string(1, "RGB"[c]),
                   Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(&image.pixels[0] + c), 12, 840));
    file.setFrameBuffer(frame);
    for (int level = 0; level < file.numLevels(); ++level)
      file.writeTiles(0, file.numXTiles(level) - 1, 0, file.numYTiles(level) - 1, level);
  }
  EXPECT_EQ(read_picture_file(folder / "t.exr").image().pixels, image.pixels);
}

TEST(PictureFile, LuminanceAndChromaAreDecoded) {
  const TemporaryFolder folder;
  const Imf::Rgba colour(0.5f, 0.25f, 0.125f);
  const std::vector<Imf::Rgba> pixels(32 * 32, colour);
  {
    Imf::RgbaOutputFile file((folder / "yc.exr").c_str(), 32, 32, Imf::WRITE_YC);
    file.setFrameBuffer(pixels.data(), 1, 32);
    file.writePixels(32);
  }
  const PictureFile read = read_picture_file(folder / "yc.exr");
  for (int c = 0; c < 3; ++c)
    EXPECT_NEAR(read.image().at(16, 16)[c], 0.5 / (1 << c), 0.5 / 64);  // OpenEXR keeps 5 bits of chroma
  EXPECT_THAT(read.notes, ElementsAre(HasSubstr("luminance and chroma")));
}

TEST(PictureFile, LuminanceAndChromaStandWhereTheirWindowIs) {
  const TemporaryFolder folder;
  const Imath::Box2i display({0, 0}, {31, 31}), data({8, 16}, {31, 31});
  const std::vector<Imf::Rgba> pixels(24 * 16, Imf::Rgba(0.5f, 0.5f, 0.5f));
  {
    Imf::RgbaOutputFile file((folder / "yc.exr").c_str(), display, data, Imf::WRITE_YC);
    file.setFrameBuffer(pixels.data() - 8 - 16 * 24, 1, 24);
    file.writePixels(16);
  }
  const Image image = read_picture_file(folder / "yc.exr").image();
  ASSERT_EQ(image.width, 32);
  ASSERT_EQ(image.height, 32);
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x) EXPECT_NEAR(image.at(x, y)[1], x >= 8 && y >= 16 ? 0.5 : 0.0, 0.5 / 64);
}

TEST(PictureFile, WhatTheProgramWritesKeepsItsDepth) {
  const TemporaryFolder folder;
  LayeredImage image;
  image.layers[""] = Image(3, 2, 3);
  image.layers["depth"] = Image(3, 2, 1);
  image.layers["depth"].pixels[4] = 7.0f;
  image.layers["albedo"] = Image(3, 2, 3);
  image.metadata["sturm"] = "text";
  write_exr(folder / "a.exr", image);
  const PictureFile read = read_picture_file(folder / "a.exr");
  EXPECT_EQ(read.picture.layers.at("depth").pixels, image.layers["depth"].pixels);
  EXPECT_EQ(read.picture.metadata.at("sturm"), "text");
  EXPECT_TRUE(read.notes.empty());
  EXPECT_EQ(read_picture_file(folder / "a.exr", "albedo").layer, "albedo");
}

TEST(PictureFile, DepthOfOtherProgramsIsFound) {
  const TemporaryFolder folder;
  const auto write = [&](const std::vector<std::string>& channels) {
    Imf::Header header(3, 2);
    std::vector<float> values(6 * channels.size());
    Imf::FrameBuffer frame;
    for (std::size_t c = 0; c < channels.size(); ++c) {
      header.channels().insert(channels[c], Imf::Channel(Imf::FLOAT));
      for (std::size_t i = 0; i < 6; ++i) values[6 * c + i] = static_cast<float>(c);
      frame.insert(channels[c], Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(&values[6 * c]), 4, 12));
    }
    Imf::OutputFile file((folder / "a.exr").c_str(), header);
    file.setFrameBuffer(frame);
    file.writePixels(2);
  };
  const auto depth = [&] {
    const LayeredImage picture = read_picture_file(folder / "a.exr").picture;
    return picture.layers.contains("depth") ? picture.layers.at("depth").pixels[0] : -1.0f;
  };
  write({"R", "G", "B", "Z"});
  EXPECT_EQ(depth(), 3.0f);
  write({"V.Combined.R", "V.Combined.G", "V.Combined.B", "V.Depth.V"});
  EXPECT_EQ(depth(), 3.0f);
  write({"R", "G", "B", "depth.Z", "V.Depth.Z"});
  EXPECT_EQ(depth(), 3.0f);
  write({"R", "G", "B", "normal.X", "normal.Y", "normal.Z"});
  EXPECT_EQ(depth(), -1.0f);
}

TEST(PictureFile, AHeaderCannotClaimMoreThanItsFileHolds) {
  const TemporaryFolder folder;
  Imf::Header header(16384, 16384);
  header.compression() = Imf::ZIP_COMPRESSION;
  for (const char* channel : {"R", "G", "B"}) header.channels().insert(channel, Imf::Channel(Imf::HALF));
  { Imf::OutputFile file((folder / "empty.exr").c_str(), header); }  // the header and a table without pixels
  EXPECT_THAT(input_error([&] { read_picture_file(folder / "empty.exr"); }), HasSubstr("claims more pixels"));
}

TEST(PictureFile, NeedsAPlainFile) {
  const TemporaryFolder folder;
  EXPECT_THAT(input_error([&] { read_picture_file(folder / "none.exr"); }), HasSubstr("no such file"));
  EXPECT_THAT(input_error([&] { read_picture_file(folder.path()); }), HasSubstr("a folder"));
  EXPECT_THAT(input_error([&] { read_picture_file("/dev/null"); }), HasSubstr("a pipe or device"));
}

TEST(PictureFile, NamesThePixelThatIsNoLight) {
  Image image(3, 2, 4);
  image.at(2, 1)[3] = std::nanf("");  // alpha
  EXPECT_NO_THROW(require_light(image, "a.exr"));
  image.at(2, 1)[1] = -1e-8f;
  EXPECT_NO_THROW(require_finite_pixels(image, "a.exr"));
  EXPECT_THAT(input_error([&] { require_light(image, "a.exr"); }), HasSubstr("a.exr: pixel (2, 1): got -1e-08 in G"));
}

TEST(RadianceHdr, ReadsAllOrders) {
  // Two columns, three rows; each pixel has a mantissa of its own, exponent 136: its value is the mantissa.
  const auto decoded = [](const std::string& sizes, const std::string& mantissas) {
    std::string file = "#?RGBE\nFORMAT=32-bit_rle_rgbe\n\n" + sizes + "\n";
    for (const char m : mantissas) file += std::string(3, m) + static_cast<char>(136);
    const RadianceHdr hdr = decode_radiance_hdr(file, 100);
    std::string upright;
    for (int y = 0; y < hdr.image.height; ++y)
      for (int x = 0; x < hdr.image.width; ++x) upright += static_cast<char>(hdr.image.at(x, y)[0]);
    return upright;
  };
  EXPECT_EQ(decoded("-Y 3 +X 2", "abcdef"), "abcdef");
  EXPECT_EQ(decoded("+Y 3 +X 2", "efcdab"), "abcdef");
  EXPECT_EQ(decoded("-Y 3 -X 2", "badcfe"), "abcdef");
  EXPECT_EQ(decoded("+Y 3 -X 2", "fedcba"), "abcdef");
  EXPECT_EQ(decoded("+X 2 -Y 3", "acebdf"), "abcdef");
  EXPECT_EQ(decoded("-X 2 -Y 3", "bdface"), "abcdef");
  EXPECT_EQ(decoded("+X 2 +Y 3", "ecafdb"), "abcdef");
  EXPECT_EQ(decoded("-X 2 +Y 3", "fdbeca"), "abcdef");
}

/// The values of one channel of a picture of one scan line; with exponent 136 a value is its mantissa.
std::vector<float> radiance_line(const std::string& variables, std::size_t width, const std::string& pixels,
                                 int channel = 0) {
  const RadianceHdr hdr =
      decode_radiance_hdr("#?RADIANCE\n" + variables + "\n-Y 1 +X " + std::to_string(width) + "\n" + pixels, 1 << 20);
  std::vector<float> line;
  for (int x = 0; x < hdr.image.width; ++x) line.push_back(hdr.image.at(x, 0)[channel]);
  return line;
}

std::string rgbe(int r, int g, int b, int e = 136) {
  return {static_cast<char>(r), static_cast<char>(g), static_cast<char>(b), static_cast<char>(e)};
}

TEST(RadianceHdr, OldRunsRepeatTheLastPixel) {
  // 3 times more, then 1 · 256 times more; behind another pixel a run counts in ones again.
  const std::string pixels = rgbe(10, 0, 0) + rgbe(1, 1, 1, 3) + rgbe(1, 1, 1, 1) + rgbe(20, 0, 0) + rgbe(1, 1, 1, 2);
  std::vector<float> expected(260, 10.0f);
  expected.insert(expected.end(), 3, 20.0f);
  EXPECT_EQ(radiance_line("", 263, pixels), expected);
  EXPECT_THROW(radiance_line("", 262, pixels), std::runtime_error);
  EXPECT_THROW(radiance_line("", 9, rgbe(1, 1, 1, 9)), std::runtime_error);  // nothing to repeat
}

TEST(RadianceHdr, NewRunsAreToldFromPixels) {
  // 128 different values stand behind the count 128; 129 is a run of one.
  std::string different(1, '\x80'), same;
  for (int i = 0; i < 128; ++i) different += static_cast<char>(i);
  for (int i = 0; i < 128; ++i) same += std::string("\x81\x88", 2);
  const std::vector<float> line =
      radiance_line("", 128, std::string("\2\2\0\x80", 4) + different + different + different + same);
  for (int i = 0; i < 128; ++i) EXPECT_EQ(line[static_cast<std::size_t>(i)], static_cast<float>(i));
  // In a line of fewer than 8 pixels, and with a third byte above 127, these are a pixel's own bytes.
  EXPECT_THAT(radiance_line("", 2, rgbe(2, 2, 0, 136) + rgbe(5, 5, 5)), ElementsAre(2.0f, 5.0f));
  std::string flat = rgbe(2, 2, 200);
  for (int i = 1; i < 8; ++i) flat += rgbe(i, 0, 0);
  EXPECT_THAT(radiance_line("", 8, flat), ElementsAre(2, 1, 2, 3, 4, 5, 6, 7));
}

TEST(RadianceHdr, GainsAreDividedOutAllOfThem) {
  const std::string gains =
      "COLORCORR=2 4 8\r\nEXPOSURE=2.5\r\n# EXPOSURE=1000\r\nVIEW= -vp 1 2 3\r\nEXPOSURE= 0.4\r\n";
  for (int channel = 0; channel < 3; ++channel)
    EXPECT_THAT(radiance_line(gains + "\r", 1, rgbe(80, 80, 80), channel), ElementsAre(80.0f / (2 << channel)));
}

TEST(RadianceHdr, RefusesBrokenFiles) {
  const std::string head = "#?RADIANCE\n\n";
  for (const std::string& file :
       {head, head + "-Y 2\n", head + "-Y 2 +Y 2\n", head + "-Y 0 +X 2\n", head + "-Y 2 +X 2 more\n",
        head + "-Y 2 +X 2\nabc", head + "-Y 1 +X 9\n\x02\x02" + std::string("\0\x08", 2),
        std::string("#?RADIANCE\nEXPOSURE=one\n\n-Y 1 +X 1\nabcd"),
        std::string("#?RADIANCE\nCOLORCORR=1 2\n\n-Y 1 +X 1\nabcd"),
        std::string("#?RADIANCE\nPRIMARIES=1 2\n\n-Y 1 +X 1\nabcd"), std::string("#?RADIANCE")})
    EXPECT_THROW(decode_radiance_hdr(file, 1 << 20), std::runtime_error) << file;
}

TEST(PortableFloatMap, RowsRunUpwards) {
  const std::string little("Pf\n1 2\n-1\n\0\0\x80\x3f\0\0\0\x40", 18), big("Pf 1 2 1\n\x3f\x80\0\0\x40\0\0\0", 17);
  EXPECT_THAT(decode_portable_float_map(little, 10).pixels, ElementsAre(2.0f, 1.0f));
  EXPECT_THAT(decode_portable_float_map(big, 10).pixels, ElementsAre(2.0f, 1.0f));
  const std::string windows("Pf\r\n1 2\r\n-0.5\r\n\0\0\x80\x3f\0\0\0\x40", 23);
  EXPECT_THAT(decode_portable_float_map(windows, 10).pixels, ElementsAre(1.0f, 0.5f));
  const std::string noted("PF # by hand\n# 1 x 1\n1 1\n-2\n\0\0\x80\x3f\0\0\0\x40\0\0\x80\x40", 40);
  EXPECT_THAT(decode_portable_float_map(noted, 10).pixels, ElementsAre(2.0f, 4.0f, 8.0f));
  EXPECT_THAT(decode_portable_float_map(noted, 10, true).pixels, ElementsAre(1.0f, 2.0f, 4.0f));
  for (const std::string& text :
       {std::string("Pf\n1 2\n-1\nabc"), std::string("Pf\n-1 2\n-1\n"), std::string("Pf\n1 2\n0\nabcdefgh"),
        std::string("PF\n"), std::string("Pf\n1 2\nx\nabcdefgh"), std::string("Pf\n9 9\n1\n")})
    EXPECT_THROW(decode_portable_float_map(text, 10), std::runtime_error) << text;
}

}  // namespace
}  // namespace sturm
