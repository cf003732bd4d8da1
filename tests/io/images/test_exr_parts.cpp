#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "io/images/exr.h"
#include "io/images/exr_parts.h"
#include "io/io_testing.h"

namespace sturm {
namespace {

using ::testing::HasSubstr;

std::vector<ExrPart> sample_parts() {
  ExrPart small{"small", {"a", "b"}, Image(3, 2, 2), {{"note", "ä"}}}, tall{"tall", {"x.xx"}, Image(2, 700, 1), {}};
  for (std::size_t i = 0; i < small.image.pixels.size(); ++i) small.image.pixels[i] = 0.1f * static_cast<float>(i);
  for (std::size_t i = 0; i < tall.image.pixels.size(); ++i) tall.image.pixels[i] = -1e-7f * static_cast<float>(i);
  return {small, tall};
}

TEST(ExrParts, RoundTripKeepsPartsOfDifferentSizes) {
  const TemporaryFolder folder;
  write_exr_parts(folder / "a.exr", sample_parts());
  const std::vector<ExrPart> read = read_exr_parts(folder / "a.exr"), written = sample_parts();
  ASSERT_EQ(read.size(), 2u);
  for (std::size_t p = 0; p < 2; ++p) {
    EXPECT_EQ(read[p].name, written[p].name);
    EXPECT_EQ(read[p].channels, written[p].channels);
    EXPECT_EQ(read[p].image.width, written[p].image.width);
    EXPECT_EQ(read[p].image.pixels, written[p].image.pixels);  // float32 is stored without loss
    EXPECT_EQ(read[p].metadata, written[p].metadata);
  }
}

TEST(ExrParts, RefusesWhatTheFormatHasNoPlaceFor) {
  const TemporaryFolder folder;
  EXPECT_THROW(write_exr_parts(folder / "a.exr", {}), std::invalid_argument);
  auto parts = sample_parts();
  parts[0].channels = {"a", "a"};
  EXPECT_THROW(write_exr_parts(folder / "a.exr", parts), std::invalid_argument);
  parts[0].channels = {"a"};
  EXPECT_THROW(write_exr_parts(folder / "a.exr", parts), std::invalid_argument);
  EXPECT_FALSE(std::filesystem::exists(folder / "a.exr"));
}

TEST(ExrParts, BrokenFilesAreInputErrors) {
  const TemporaryFolder folder;
  write_exr_parts(folder / "a.exr", sample_parts());
  EXPECT_THAT(input_error([&] { read_exr_parts(folder / "none.exr"); }), HasSubstr("no such file"));
  EXPECT_THAT(input_error([&] { read_exr_parts(folder / "a.exr", 100); }), HasSubstr("MiB"));
  std::filesystem::resize_file(folder / "a.exr", 900);
  EXPECT_THAT(input_error([&] { read_exr_parts(folder / "a.exr"); }), HasSubstr("a.exr"));
  std::ofstream(folder / "text.exr") << "no image";
  EXPECT_THAT(input_error([&] { read_exr_parts(folder / "text.exr"); }), HasSubstr("text.exr"));
}

}  // namespace
}  // namespace sturm
