#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string_view>

#include "io/images/claimed_size.h"
#include "io/images/image_formats.h"
#include "io/images/picture_format.h"
#include "io/io_testing.h"

namespace sturm {
namespace {

using namespace std::string_view_literals;
using testing::HasSubstr;

BytesAt bytes_of(std::string_view bytes) {
  return [bytes](std::uint64_t offset, std::size_t count) {
    return std::string(bytes.substr(std::min<std::size_t>(offset, bytes.size()), count));
  };
}

std::string reader_of(std::string_view bytes) {
  const auto format = picture_format(bytes_of(bytes));
  return format ? format->reader : "none";
}

TEST(PictureFormat, FirstBytesDecide) {
  EXPECT_EQ(reader_of("\x89PNG\r\n\x1a\nmore"sv), "png");
  EXPECT_EQ(reader_of("\xff\xd8\xff\xe1"sv), "jpeg");
  EXPECT_EQ(reader_of("MM\0*\0\0"sv), "tiff");
  EXPECT_EQ(reader_of("RIFF\x10\0\0\0WEBPVP8L"sv), "webp");
  EXPECT_EQ(reader_of("RIFF\x10\0\0\0WAVEfmt "sv), "none");
  EXPECT_EQ(reader_of("\0\0\0\x1c"
                      "ftypheic"sv),
            "heif");
  EXPECT_EQ(reader_of("\0\0\0\x1c"
                      "ftypisom"sv),
            "none");  // a film
  EXPECT_EQ(reader_of("P6\n1 1\n255\nabc"sv), "pnm");
  EXPECT_EQ(reader_of("P7\nWIDTH 1"sv), "none");
  EXPECT_EQ(reader_of("\0\0\x02\0\0\0\0\0\0\0\0\0\x01\0\x02\0\x18\x20"sv), "targa");
  EXPECT_EQ(reader_of("\0\0\x02\0\0\0\0\0\0\0\0\0\0\0\x02\0\x18\x20"sv), "none");    // no width
  EXPECT_EQ(reader_of("\0\0\x02\0\0\0\0\0\0\0\0\0\x01\0\x02\0\x17\x20"sv), "none");  // 23 bits
  EXPECT_EQ(reader_of("not a picture, but text"sv), "none");
  EXPECT_EQ(reader_of(""sv), "none");
}

TEST(PictureFormat, OneColouredPicturesOfRealEncodersAreAdmitted) {
  // A black PNG of 16384 x 16384 with one bit a pixel has 16384 * 2049 bytes before deflate, which takes at least one
  // for 1032 of them; a progressive JPEG at least a bit for a block of 8 x 8.
  const auto png = picture_format(bytes_of("\x89PNG\r\n\x1a\n"sv)).value();
  EXPECT_GE(most_pixels_of(png, 16384 * 2049 / 1032), 16384u * 16384u);
  const auto jpeg = picture_format(bytes_of("\xff\xd8\xff\xc0"sv)).value();
  EXPECT_GE(most_pixels_of(jpeg, 16384 * 8192 / 512), 16384u * 8192u);
  EXPECT_EQ(most_pixels_of(jpeg, 29), 4096u * 4096u);
  EXPECT_EQ(most_pixels_of(jpeg, std::uint64_t{1} << 40), most_pixels);
}

TEST(ClaimedSize, EveryHeaderIsRead) {
  const auto size = [](std::string_view bytes) {
    const auto claim = claimed_size(picture_format(bytes_of(bytes)).value(), bytes_of(bytes)).value();
    return std::pair(claim.width, claim.height);
  };
  using Size = std::pair<std::uint64_t, std::uint64_t>;
  // A segment of 6 bytes, a stray byte, padding, then a progressive frame of 0x1234 x 0x0506.
  EXPECT_EQ(size("\xff\xd8\xff\xe0\0\x06"
                 "abcd!\xff\xff\xc2\0\x11\x08\x05\x06\x12\x34"sv),
            Size(0x1234, 0x0506));
  // Tables (C4) are no frame.
  EXPECT_EQ(size("\xff\xd8\xff\xc4\0\x09\x01\x02\x03\x04\x05\x06\x07\xff\xc0\0\x11\x08\0\x02\0\x03"sv), Size(3, 2));
  EXPECT_EQ(size("BM\0\0\0\0\0\0\0\0\0\0\0\0\x28\0\0\0\x05\0\0\0\xfd\xff\xff\xff"sv), Size(5, 3));  // -3: upside down
  EXPECT_EQ(size("BM\0\0\0\0\0\0\0\0\0\0\0\0\x0c\0\0\0\x05\0\x07\0\x01\0\x18\0"sv), Size(5, 7));    // OS/2
  EXPECT_EQ(size("GIF89a\x02\x01\x03\0"sv), Size(0x102, 3));
  EXPECT_EQ(size("RIFF\0\0\0\0WEBPVP8X\x0a\0\0\0\0\0\0\0\x04\0\0\x09\0\0"sv), Size(5, 10));
  EXPECT_EQ(size("RIFF\0\0\0\0WEBPVP8L\0\0\0\0\x2f\x04\x40\x02\0zzzzz"sv), Size(5, 10));  // 4 and 9 of 14 bits
  EXPECT_EQ(size("RIFF\0\0\0\0WEBPVP8 \0\0\0\0\0\0\0\x9d\x01\x2a\x05\x40\x0a\0"sv), Size(5, 10));
  EXPECT_EQ(size("\0\0\0\x18"
                 "ftypavif....\0\0\0\x14ispe\0\0\0\0\0\0\0\x02\0\0\0\x03\0\0\0\x14ispe\0\0\0\0\0\0\x01\0\0\0\0\x05"sv),
            Size(256, 5));  // a preview before the picture
  EXPECT_EQ(size("\xff\x4f\xff\x51\0\x2f\0\0\0\0\0\x07\0\0\0\x08\0\0\0\0\0\0\0\0"sv), Size(7, 8));
}

TEST(ClaimedSize, HeadersThatBreakOff) {
  for (const std::string_view bytes : {"\xff\xd8\xff"sv, "\xff\xd8\xff\xda\0\x08 no frame before the scan"sv,
                                       "BM\x01"sv, "GIF89a\x01"sv, "RIFF\0\0\0\0WEBPVP8L"sv,
                                       "\0\0\0\x18"
                                       "ftypavif"sv,
                                       "\xff\x4f\xff\x51\0\x2f"sv})
    EXPECT_THROW(claimed_size(picture_format(bytes_of(bytes)).value(), bytes_of(bytes)), std::runtime_error) << bytes;
  EXPECT_FALSE(claimed_size({"png", 1.0}, bytes_of("")));
}

TEST(ClaimedSize, StrayBytesOfAJpegComeToAnEnd) {
  const std::string endless = "\xff\xd8\xff" + std::string(1 << 20, '\0');
  int questions = 0;
  const BytesAt counted = [&](std::uint64_t offset, std::size_t count) {
    ++questions;
    return bytes_of(endless)(offset, count);
  };
  EXPECT_THROW(claimed_size({"jpeg", 512.0}, counted), std::runtime_error);
  EXPECT_LT(questions, 5000);
}

}  // namespace
}  // namespace sturm
