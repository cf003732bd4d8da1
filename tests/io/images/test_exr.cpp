#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "io/images/exr.h"
#include "io/io_testing.h"

namespace sturm {
namespace {

using ::testing::HasSubstr;
using ::testing::Key;
using ::testing::UnorderedElementsAre;

Image noise(int width, int height, int channels, unsigned seed) {
  Image image(width, height, channels);
  std::mt19937 engine(seed);
  std::uniform_real_distribution<float> exponent(-8.0f, 8.0f);
  for (float& value : image.pixels) value = std::pow(10.0f, exponent(engine));
  return image;
}

LayeredImage sample() {
  LayeredImage image;
  image.layers[""] = noise(37, 19, 3, 1);
  image.layers["variance"] = noise(37, 19, 3, 2);
  image.layers["normal"] = noise(37, 19, 3, 3);
  image.layers["depth"] = noise(37, 19, 1, 4);
  image.layers["coverage"] = noise(37, 19, 1, 5);
  image.layers["depth"].pixels[5] = std::numeric_limits<float>::infinity();
  image.layers[""].pixels[0] = -1e-30f;
  image.metadata = {{"sturm.spec", "{\"a\":\"ä\"}"}, {"a name that is longer than thirty-one bytes", "x"}};
  return image;
}

void expect_same(const LayeredImage& a, const LayeredImage& b) {
  ASSERT_EQ(a.layers.size(), b.layers.size());
  for (const auto& [name, layer] : a.layers) {
    ASSERT_TRUE(b.layers.contains(name)) << name;
    const Image& other = b.layers.at(name);
    EXPECT_EQ(layer.width, other.width);
    EXPECT_EQ(layer.height, other.height);
    EXPECT_EQ(layer.channels, other.channels);
    EXPECT_EQ(layer.pixels, other.pixels) << name;  // float32 is stored without loss
  }
  EXPECT_EQ(a.metadata, b.metadata);
}

TEST(Exr, RoundTripKeepsLayersValuesAndMetadata) {
  const TemporaryFolder folder;
  write_exr(folder / "a.exr", sample());
  expect_same(sample(), read_exr(folder / "a.exr"));
}

TEST(Exr, TheSameImageGivesTheSameBytes) {
  const TemporaryFolder folder;
  write_exr(folder / "a.exr", sample());
  write_exr(folder / "b.exr", read_exr(folder / "a.exr"));
  EXPECT_EQ(read_text(folder / "a.exr"), read_text(folder / "b.exr"));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 2);  // no temporary file is left
}

RC_GTEST_PROP(Exr, AnySizeAndAnyBitsAreKept, ()) {
  const int width = *rc::gen::inRange(1, 40), height = *rc::gen::inRange(1, 40), channels = *rc::gen::inRange(1, 5);
  const auto bits = *rc::gen::container<std::vector<std::uint32_t>>(static_cast<std::size_t>(width) * height * channels,
                                                                    rc::gen::arbitrary<std::uint32_t>());
  LayeredImage image;
  Image& layer = image.layers["any"] = Image(width, height, channels);
  std::memcpy(layer.pixels.data(), bits.data(), bits.size() * sizeof(float));
  const std::filesystem::path file = std::filesystem::path(::testing::TempDir()) / "sturm_io_any_bits.exr";
  write_exr(file, image);
  const LayeredImage read = read_exr(file);
  std::filesystem::remove(file);
  const Image& same = read.layers.at("any");
  RC_ASSERT(same.width == width && same.height == height && same.channels == channels);
  RC_ASSERT(std::memcmp(same.pixels.data(), layer.pixels.data(), bits.size() * sizeof(float)) == 0);
}

TEST(Exr, BrokenAndForeignFilesAreRefused) {
  const TemporaryFolder folder;
  write_exr(folder / "a.exr", sample());
  const std::string bytes = read_text(folder / "a.exr");
  for (const std::size_t kept :
       {bytes.size() - 1, bytes.size() / 2, std::size_t{300}, std::size_t{9}, std::size_t{0}}) {
    write_text(folder / "cut.exr", bytes.substr(0, kept));
    EXPECT_THAT(input_error([&] { read_exr(folder / "cut.exr"); }), HasSubstr("cut.exr")) << kept;
  }
  write_text(folder / "text.exr", "P3 1 1 255 0 0 0");
  EXPECT_THAT(input_error([&] { read_exr(folder / "text.exr"); }), HasSubstr("another kind of file"));
  EXPECT_THAT(input_error([&] { read_exr(folder / "none.exr"); }), HasSubstr("no such file"));
}

TEST(Exr, ClaimsBeyondTheLimitAreRefusedBeforeAnythingIsAllocated) {
  const TemporaryFolder folder;
  write_exr(folder / "a.exr", sample());
  EXPECT_THAT(input_error([&] { read_exr(folder / "a.exr", 1000); }), HasSubstr("MiB"));
  EXPECT_NO_THROW(read_exr(folder / "a.exr", 37 * 19 * 11 * sizeof(float)));
  EXPECT_THROW(read_exr(folder / "a.exr", 37 * 19 * 11 * sizeof(float) - 1), InputError);
  // An attribute of 2 GB in a file of a few kB: its size stands behind its name and type.
  std::string bytes = read_text(folder / "a.exr");
  const std::string name_and_type("sturm.spec\0string\0", 18);
  const std::size_t size = bytes.find(name_and_type) + name_and_type.size();
  ASSERT_LT(size, bytes.size());
  bytes.replace(size, 4, "\xFF\xFF\xFF\x7F");
  write_text(folder / "claim.exr", bytes);
  EXPECT_THAT(input_error([&] { read_exr(folder / "claim.exr"); }), HasSubstr("an attribute of 2147483647 bytes"));
}

/// Little-endian bytes of numbers and zero-terminated text, for an EXR file by hand (openexr.com, "OpenEXR File
/// Layout").
class Bytes {
 public:
  template <typename T>
  Bytes& number(T value) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    text_.append(raw, sizeof value);
    return *this;
  }
  Bytes& text(const char* text) {
    text_.append(text).push_back('\0');
    return *this;
  }
  Bytes& attribute(const char* name, const char* type, const std::string& value) {
    text(name).text(type).number<std::int32_t>(static_cast<std::int32_t>(value.size()));
    text_ += value;
    return *this;
  }
  const std::string& str() const { return text_; }

 private:
  std::string text_;
};

struct Box {
  int left, top, right, bottom;
  std::string bytes() const { return Bytes().number(left).number(top).number(right).number(bottom).str(); }
};

constexpr std::int32_t unsigned_integer = 0, half_float = 1;

/// Magic number, version and header of an uncompressed file of scan lines.
Bytes exr_header(const std::vector<const char*>& channels, std::int32_t type, const Box& data, const Box& display) {
  Bytes list;
  for (const char* channel : channels)
    list.text(channel).number(type).number<std::int32_t>(0).number<std::int32_t>(1).number<std::int32_t>(1);
  list.number<char>(0);
  Bytes file;
  file.number<std::int32_t>(20000630).number<std::int32_t>(2);
  file.attribute("channels", "chlist", list.str()).attribute("compression", "compression", std::string(1, '\0'));
  file.attribute("dataWindow", "box2i", data.bytes()).attribute("displayWindow", "box2i", display.bytes());
  file.attribute("lineOrder", "lineOrder", std::string(1, '\0'))
      .attribute("pixelAspectRatio", "float", Bytes().number(1.0f).str());
  file.attribute("screenWindowCenter", "v2f", Bytes().number(0.0f).number(0.0f).str())
      .attribute("screenWindowWidth", "float", Bytes().number(1.0f).str());
  return file.number<char>(0);
}

TEST(Exr, HalfAndForeignChannelsAreReadAndPutIntoTheDisplayWindow) {
  const TemporaryFolder folder;
  const std::vector<const char*> channels = {"B", "G", "R", "Z", "other"};
  Bytes file = exr_header(channels, half_float, {1, 1, 2, 2}, {0, 0, 3, 2});
  const std::uint16_t rows[2][2] = {{0x3C00, 0x4000}, {0x4200, 0x3800}};  // 1, 2 over 3, 0.5
  const std::size_t row_bytes = channels.size() * sizeof rows[0], first = file.str().size() + 2 * sizeof(std::uint64_t);
  file.number<std::uint64_t>(first).number<std::uint64_t>(first + 8 + row_bytes);
  for (int row = 0; row < 2; ++row) {
    file.number<std::int32_t>(row + 1).number<std::int32_t>(static_cast<std::int32_t>(row_bytes));
    for (std::size_t c = 0; c < channels.size(); ++c) file.number(rows[row][0]).number(rows[row][1]);
  }
  write_text(folder / "h.exr", file.str());
  const LayeredImage image = read_exr(folder / "h.exr");
  EXPECT_THAT(image.layers, UnorderedElementsAre(Key(""), Key("Z"), Key("other")));
  const Image& main = image.layers.at("");
  ASSERT_EQ(main.width, 4);
  ASSERT_EQ(main.height, 3);
  ASSERT_EQ(main.channels, 3);
  EXPECT_EQ(main.at(0, 0)[0], 0.0f);
  EXPECT_EQ(main.at(1, 1)[0], 1.0f);
  EXPECT_EQ(main.at(2, 1)[2], 2.0f);
  EXPECT_EQ(main.at(1, 2)[1], 3.0f);
  EXPECT_EQ(image.layers.at("Z").at(2, 2)[0], 0.5f);
  EXPECT_EQ(image.layers.at("other").at(3, 2)[0], 0.0f);
}

TEST(Exr, ForeignHeadersAreRefusedWithTheReason) {
  const TemporaryFolder folder;
  const auto error = [&](const Bytes& header) {
    write_text(folder / "x.exr", header.str() + std::string(4096, '\0'));
    return input_error([&] { read_exr(folder / "x.exr"); });
  };
  const Box small{0, 0, 1, 1}, huge{0, 0, 2000000000, 60000};
  EXPECT_THAT(error(exr_header({"id"}, unsigned_integer, small, small)), HasSubstr("x.exr: got "));
  EXPECT_THAT(error(exr_header({"R", "G", "B"}, half_float, huge, huge)), HasSubstr("x.exr: got "));
  EXPECT_THAT(error(exr_header({"R", "G", "B"}, half_float, small, huge)), HasSubstr("x.exr: got "));
  // A small picture whose claimed bytes are more than 64 bits hold.
  constexpr std::int32_t most = std::numeric_limits<std::int32_t>::max();
  Bytes preview;
  preview.number<std::int32_t>(20000630).number<std::int32_t>(2);
  preview.attribute("preview", "preview", Bytes().number(most).number(most).number<std::int32_t>(0).str());
  EXPECT_THAT(error(preview), HasSubstr("an attribute of 12 bytes that its type \"preview\" does not have"));
}

TEST(Exr, WhatDoesNotFitIsNotWritten) {
  const TemporaryFolder folder;
  const auto write = [&](const LayeredImage& image) { write_exr(folder / "x.exr", image); };
  LayeredImage sizes = sample();
  sizes.layers["depth"] = Image(3, 3, 1);
  EXPECT_THROW(write(sizes), std::invalid_argument);
  LayeredImage channels = sample();
  channels.layers["depth"] = Image(37, 19, 7);
  EXPECT_THROW(write(channels), std::invalid_argument);
  LayeredImage metadata = sample();
  metadata.metadata["compression"] = "none";
  EXPECT_THROW(write(metadata), std::invalid_argument);
  EXPECT_THROW(write(LayeredImage{}), std::invalid_argument);
  EXPECT_THROW(write_exr(folder / "none/x.exr", sample()), RuntimeFailure);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace sturm
