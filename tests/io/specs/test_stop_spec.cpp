// When a picture stops, and how it is filtered: what a render document may say about it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "io/io_testing.h"
#include "io/specs/denoise_spec.h"
#include "io/specs/render_spec.h"
#include "io/specs/stop_spec.h"

namespace sturm {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

RenderSpec stop_with(const Json& keys, const std::string& type = "path_trace") {
  Json document = parse_json(R"({
    "format": "sturm.render/1", "scene": {"environment": {}},
    "camera": {"position_m": [0, 0, 0], "look_at_m": [0, 0, -1], "vfov_deg": 40, "resolution": [8, 8]},
    "eye": {"prescription": {"sphere_D": 0}, "pupil_diameter_mm": 4, "accommodation": {"mode": "relaxed"}},
    "method": {"type": "path_trace", "ray_model": "power_matrix"}})",
                             "view.json");
  document["method"]["type"] = type;
  if (type == "predict") document["method"].erase("ray_model");
  document["method"].update(keys);
  return read_render_spec(document, "view.json");
}

std::string stop_error_with(const Json& keys, const std::string& type = "path_trace") {
  return input_error([&] { stop_with(keys, type); });
}

TEST(StopSpec, NothingIsAskedForUnlessItIs) {
  const RenderSpec spec = stop_with(Json::object());
  EXPECT_FALSE(spec.stop.seconds || spec.stop.relative_error || spec.adaptive || spec.denoise);
  // Metadata of older documents stays as it was.
  for (const char* key : {"stop", "adaptive", "denoise"}) EXPECT_FALSE((*spec.resolved)["method"].contains(key));
}

TEST(StopSpec, Reads) {
  const RenderSpec spec = stop_with({{"stop", {{"seconds", 1.5}, {"relative_error", 0.02}}},
                                     {"adaptive", {{"tile_px", 16}}},
                                     {"denoise", {{"levels", 3}}}});
  EXPECT_EQ(spec.stop.seconds, 1.5);
  EXPECT_EQ(spec.stop.relative_error, 0.02);
  EXPECT_EQ(spec.adaptive.value().tile_px, 16);
  EXPECT_EQ(spec.adaptive->min_samples_per_pixel, 32);
  EXPECT_EQ(spec.denoise.value().levels, 3);
  EXPECT_EQ(spec.denoise->radiance_sigma, 2.0);
  // Defaults are spelt out, and are those of the structs.
  const Json& method = (*spec.resolved)["method"];
  EXPECT_EQ(method["adaptive"],
            (Json{{"tile_px", 16}, {"min_samples_per_pixel", AdaptiveSpec().min_samples_per_pixel}}));
  const DenoiseSpec defaults;
  EXPECT_EQ(method["denoise"], (Json{{"levels", 3},
                                     {"radiance_sigma", defaults.radiance_sigma},
                                     {"albedo_sigma", defaults.albedo_sigma},
                                     {"normal_sigma", defaults.normal_sigma},
                                     {"vergence_sigma", defaults.vergence_sigma}}));
}

TEST(StopSpec, RefusesWhatMakesNoSense) {
  EXPECT_THAT(stop_error_with({{"adaptive", Json::object()}}),
              AllOf(HasSubstr("/method/adaptive"), HasSubstr("relative_error")));
  EXPECT_THAT(stop_error_with({{"adaptive", Json::object()}, {"stop", {{"seconds", 1}}}}),
              HasSubstr("/method/adaptive"));
  EXPECT_THAT(stop_error_with({{"stop", Json::object()}}), HasSubstr("/method/stop"));
  EXPECT_THAT(stop_error_with({{"stop", {{"seconds", 0}}}}), HasSubstr("/method/stop/seconds"));
  EXPECT_THAT(stop_error_with({{"stop", {{"relative_error", -0.1}}}}), HasSubstr("/method/stop/relative_error"));
  EXPECT_THAT(stop_error_with({{"stop", {{"relative_eror", 0.1}}}}), HasSubstr("relative_error"));
  EXPECT_THAT(stop_error_with({{"stop", {{"relative_error", 0.1}}}, {"samples_per_pixel", 7}}),
              HasSubstr("/method/samples_per_pixel"));
  EXPECT_THAT(stop_error_with({{"stop", {{"relative_error", 0.1}}}, {"adaptive", {{"min_samples_per_pixel", 33}}}}),
              AllOf(HasSubstr("/method/adaptive/min_samples_per_pixel"), HasSubstr("multiple of 4")));
  EXPECT_THAT(stop_error_with({{"denoise", {{"levels", 9}}}}), HasSubstr("/method/denoise/levels"));
  for (const char* key : {"stop", "denoise"}) {
    const Json value = key == std::string("stop") ? Json{{"seconds", 1}} : Json::object();
    EXPECT_THAT(stop_error_with({{key, value}}, "predict"),
                AllOf(HasSubstr(std::string("/method/") + key), HasSubstr("predict")));
  }
}

}  // namespace
}  // namespace sturm
