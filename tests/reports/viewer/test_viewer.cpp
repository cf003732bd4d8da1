#include <gmock/gmock.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "compare/metrics/stored_images.h"
#include "io/images/half_pixels.h"
#include "io/json/json.h"
#include "reports/markup/pictures.h"
#include "reports/viewer/viewer.h"

namespace sturm {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

Json document_of(const ViewerPayload& payload) {
  const std::string html = payload.html().markup();
  const std::size_t first = html.find('>') + 1;
  return Json::parse(html.substr(first, html.rfind("</script>") - first));
}

std::string address(const Image& image) {
  return "data:application/octet-stream;base64," + base64(half_float_bytes(image.pixels));
}

ViewerPayload payload_with(const std::string& title) {
  const Image a = testing::textured_image(24, 16, 0.0), b = testing::textured_image(24, 16, 0.3);
  ViewerPayload payload;
  payload.add_picture("a.exr", a, 1);
  payload.add_picture("b.exr", b, 1);
  ViewerSet shown;
  shown.title = title;
  shown.pictures = {{"path_traced", "Path traced", "a.exr"}, {"predicted", "Predicted", "b.exr"}};
  shown.maps = maps_of_images(luma_image(a), 0.5, measure_images(b, a, {}), 1 + viewer_maps().size());
  shown.quantity = viewer_radiance;
  payload.add_set(shown);
  return payload;
}

TEST(ViewerPayload, HoldsPicturesAndMapsOfTheMetricsOwnValues) {
  const Image a = testing::textured_image(24, 16, 0.0), b = testing::textured_image(24, 16, 0.3);
  const Json document = document_of(payload_with("case"));
  EXPECT_EQ(document["pictures"]["a.exr"]["halves"], address(a));
  EXPECT_EQ(document["pictures"]["b.exr"]["halves"], address(b));
  const Json& maps = document["cases"][0]["maps"];
  ASSERT_EQ(maps.size(), 1 + viewer_maps().size());  // the difference, and one for each metric
  for (const ImageMetric& metric : measure_images(b, a, {})) {
    for (const Json& map : maps)
      if (map["key"] == metric.key && metric.margin == 0) {
        EXPECT_EQ(map["halves"], address(metric.map)) << metric.key;
      }
  }
  for (const Json& map : maps) {
    EXPECT_EQ(map["width"], 24) << map["key"];
    EXPECT_EQ(map["height"], 16) << map["key"];
    EXPECT_GT(map["end"], 0.0) << map["key"];
  }
}

TEST(ViewerPayload, WhereAWindowDoesNotFitThereIsNoValue) {
  const Json document = document_of(payload_with("case"));
  const Json& ssim = document["cases"][0]["maps"][1];
  ASSERT_EQ(ssim["key"], "ssim_display");
  // The first value is a NaN, 0x7e00 in little endian: bytes 00 7e 00 … are "AH4A" in base64.
  EXPECT_THAT(ssim["halves"].get<std::string>(), HasSubstr("base64,AH4A"));
}

TEST(ViewerPayload, APictureOfSeveralCasesIsStoredOnce) {
  ViewerPayload payload = payload_with("one");
  const std::size_t before = payload.html().markup().size();
  payload.add_picture("b.exr", testing::textured_image(24, 16, 0.9), 1);
  EXPECT_EQ(payload.html().markup().size(), before);
}

TEST(ViewerPayload, DensitiesKeepTheirPrecisionHoweverSmall) {
  Image density(2, 1, 1);
  density.pixels = {0x1p-20f, 0x1.004p-32f};  // 2⁻³² itself would round to zero; the second is 1025/1024 of it
  ViewerSet shown;
  shown.kind = ViewerSet::Kind::Density;
  shown.pictures = {{"a", "A", "a.exr"}};
  shown.peak = 0x1p-20;
  ViewerPayload payload;
  payload.add_picture("a.exr", density, 1);
  payload.add_set(shown);
  const Json picture = document_of(payload)["pictures"]["a.exr"];
  ASSERT_EQ(picture["exponent"], 33);  // 2⁻²⁰ becomes 2¹³, the second 2·(1 + 2⁻¹⁰)
  // 2¹³ = 0x7000 and 2·(1 + 2⁻¹⁰) = 0x4001, little endian: 00 70 01 40.
  EXPECT_EQ(picture["halves"], "data:application/octet-stream;base64," + base64({0x00, 0x70, 0x01, 0x40}));
}

TEST(ViewerPayload, ADensityOfZerosStaysOne) {
  ViewerSet shown;
  shown.kind = ViewerSet::Kind::Density;
  shown.pictures = {{"a", "A", "a.exr"}};
  shown.peak = 1.0;
  ViewerPayload payload;
  payload.add_picture("a.exr", Image(2, 2, 1), 1);
  payload.add_set(shown);
  EXPECT_EQ(document_of(payload)["pictures"]["a.exr"]["exponent"], 0);
}

TEST(ViewerPayload, HoldsNoMarkup) {
  const std::string html = payload_with("</script><script>alert(1)</script>&amp;<![CDATA[").html().markup();
  EXPECT_EQ(html.find("<", 1), html.rfind("</script>"));  // nothing but its own tags
  EXPECT_THAT(html, Not(HasSubstr("&")));
  EXPECT_EQ(document_of(payload_with("<&>"))["cases"][0]["title"], "<&>");
}

TEST(ViewerPayload, WithoutCasesIsNothing) {
  EXPECT_TRUE(ViewerPayload().html().empty());
}

TEST(HalfPixels, AreThoseOfTheStandard) {  // IEEE 754-2019, binary16; patterns worked by hand
  const auto bits = [](float value) {
    const auto bytes = half_float_bytes(std::span(&value, 1));
    return bytes[0] | bytes[1] << 8;
  };
  EXPECT_EQ(bits(0.0f), 0x0000);
  EXPECT_EQ(bits(1.0f), 0x3c00);
  EXPECT_EQ(bits(-2.0f), 0xc000);
  EXPECT_EQ(bits(0.333251953125f), 0x3555);
  EXPECT_EQ(bits(65504.0f), 0x7bff);
  EXPECT_EQ(bits(1e6f), 0x7c00);                    // infinite
  EXPECT_EQ(bits(5.9604644775390625e-8f), 0x0001);  // 2⁻²⁴
  EXPECT_EQ(bits(std::numeric_limits<float>::quiet_NaN()) & 0x7c00, 0x7c00);
  EXPECT_NE(bits(std::numeric_limits<float>::quiet_NaN()) & 0x03ff, 0);
}

}  // namespace
}  // namespace sturm
