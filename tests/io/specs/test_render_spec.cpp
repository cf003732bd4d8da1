#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "io/io_testing.h"
#include "io/json/json_pointer_set.h"
#include "io/specs/render_spec.h"

namespace sturm {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class RenderSpecTest : public ::testing::Test {
 protected:
  RenderSpecTest() : file_((folder_ / "renders/r.json").string()) {
    write_text(folder_ / "scenes/s.obj", "v 0 0 0\n");
    write_text(
        folder_ / "scenes/s.json",
        R"({"format": "sturm.scene/1", "models": [{"file": "s.obj", "scale": 0.001, "texture_encoding": "linear", "texture_filter": "nearest"}]})");
    document_ = parse_json(R"({
      "$schema": "../schemas/render.schema.json",
      "format": "sturm.render/1",
      "scene": {
        "materials": {"white": {"albedo": [0.7, 0.8, 0.9]}, "lamp": {"emission": [10, 11, 12]}},
        "meshes": [{"name": "floor", "material": "white", "positions_m": [[0, 0, 0], [1, 0, 0], [1, 0, 1], [0, 0, 1]], "faces": [[0, 1, 2, 3], [0, 1, 2]]}],
        "spheres": [{"center_m": [0, 1, 2], "radius_m": 0.5, "material": "lamp"}],
        "lights": [{"type": "point", "position_m": [1, 2, 3], "intensity": [4, 5, 6]}],
        "environment": null
      },
      "camera": {"position_m": [0.278, 0.273, -0.8], "look_at_m": [0.278, 0.273, 0.0], "vfov_deg": 39.3077, "resolution": [256, 128]},
      "eye": {"prescription": {"sphere_D": 0, "vertex_distance_mm": 0}, "pupil_diameter_mm": 40, "accommodation": {"mode": "fixed", "focus_distance_m": 1.25}},
      "spectacles": null,
      "method": {"type": "path_trace", "ray_model": "sin2_radial"}
    })",
                           "r.json");
  }

  RenderSpec read_with(const std::vector<std::string>& assignments) const {
    Json document = document_;
    for (const std::string& assignment : assignments) apply_set(document, assignment);
    return read_render_spec(document, file_);
  }
  std::string error_with(const std::vector<std::string>& assignments) const {
    return input_error([&] { read_with(assignments); });
  }

  TemporaryFolder folder_;
  std::string file_;
  Json document_;
};

TEST_F(RenderSpecTest, ReadsIntoSi) {
  const RenderSpec spec = read_render_spec(document_, file_);
  EXPECT_EQ(spec.camera.position, Eigen::Vector3d(0.278, 0.273, -0.8));
  EXPECT_EQ(spec.camera.up, Eigen::Vector3d(0, 1, 0));
  EXPECT_NEAR(spec.camera.vfov, 0.6860487856, 1e-9);  // 39.3077·π/180
  EXPECT_EQ(spec.camera.width, 256);
  EXPECT_EQ(spec.camera.height, 128);
  EXPECT_EQ(spec.eye.eye.accommodation_for(0.0), 0.8);
  EXPECT_EQ(spec.method, RenderMethod::PathTrace);
  EXPECT_EQ(spec.ray_model, RayModel::sin2_radial);
  EXPECT_EQ(spec.samples_per_pixel, 64u);
  EXPECT_EQ(spec.max_bounces, 16);
  EXPECT_EQ(spec.sampler, Sequence::Sobol);
  EXPECT_EQ(spec.seed, 1u);
  EXPECT_THAT(spec.notes, ElementsAre(HasSubstr("40 mm")));
}

TEST_F(RenderSpecTest, ScenesInPlace) {
  const SceneSpec scene = read_render_spec(document_, file_).scene;
  ASSERT_EQ(scene.materials.size(), 2u);
  EXPECT_EQ(scene.materials[0].name, "lamp");
  EXPECT_EQ(scene.materials[0].emission, Eigen::Vector3d(10, 11, 12));
  EXPECT_EQ(scene.materials[1].albedo, Eigen::Vector3d(0.7, 0.8, 0.9));
  ASSERT_EQ(scene.meshes.size(), 1u);
  EXPECT_EQ(scene.meshes[0].material, 1);
  EXPECT_EQ(scene.meshes[0].positions[2], Eigen::Vector3d(1, 0, 1));
  using Triangle = std::array<std::uint32_t, 3>;
  EXPECT_THAT(scene.meshes[0].triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}, Triangle{0, 1, 2}));
  EXPECT_EQ(scene.spheres[0].material, 0);
  EXPECT_EQ(scene.spheres[0].radius, 0.5);
  EXPECT_EQ(scene.lights[0].intensity, Eigen::Vector3d(4, 5, 6));
}

TEST_F(RenderSpecTest, ScenesAndModelsInFiles) {
  const SceneSpec by_scene = read_with({"/scene=../scenes/s.json"}).scene;
  ASSERT_EQ(by_scene.models.size(), 1u);
  EXPECT_EQ(by_scene.models[0].file, folder_ / "scenes/s.obj");  // beside the scene, not beside the render
  EXPECT_EQ(by_scene.models[0].scale, 0.001);
  EXPECT_EQ(by_scene.models[0].texture_encoding, TextureEncoding::Linear);
  EXPECT_EQ(by_scene.models[0].texture_filter, TextureFilter::Nearest);
  EXPECT_THAT(by_scene.input_files,
              ElementsAre((folder_ / "scenes/s.json").string(), (folder_ / "scenes/s.obj").string()));
  const SceneSpec by_model = read_with({"/scene=../scenes/s.obj"}).scene;
  ASSERT_EQ(by_model.models.size(), 1u);
  EXPECT_EQ(by_model.models[0].texture_encoding, TextureEncoding::Srgb);
  EXPECT_EQ(by_model.models[0].texture_filter, TextureFilter::Bilinear);
}

TEST_F(RenderSpecTest, SceneErrorsNameFileAndPlace) {
  EXPECT_THAT(error_with({"/scene=../scenes/none.obj"}),
              AllOf(HasSubstr("r.json: /scene: got \"../scenes/none.obj\""), HasSubstr("there is no file")));
  EXPECT_THAT(error_with({"/scene/models=[{\"file\": \"none.obj\"}]"}),
              HasSubstr("r.json: /scene/models/0/file: got \"none.obj\""));
  EXPECT_THAT(
      error_with({"/scene/meshes/0/material=whit"}),
      AllOf(HasSubstr("/scene/meshes/0/material: got \"whit\" (did you mean \"white\"?)"), HasSubstr("\"lamp\"")));
  EXPECT_THAT(error_with({"/scene/meshes/0/faces/1/2=4"}),
              HasSubstr("/scene/meshes/0/faces/1/2: got 4, expected the number of a vertex, from 0 to 3"));
  EXPECT_THAT(error_with({"/scene/meshes/0/faces/1/2=0"}), HasSubstr("no two alike"));
  EXPECT_THAT(error_with({"/scene/materials/white/albedo/1=1.1"}),
              HasSubstr("/scene/materials/white/albedo/1: got 1.1, expected a number from 0 to 1"));
  EXPECT_THAT(error_with({"/scene/materials/white/albdo=[1,1,1]"}), HasSubstr("did you mean \"albedo\"?"));
  EXPECT_THAT(error_with({"/scene/environment=sky.exr"}),
              HasSubstr("/scene/environment: got \"sky.exr\", expected an object or null"));
  write_text(folder_ / "scenes/bad.json", R"({"format": "sturm.scene/1", "model": []})");
  EXPECT_THAT(error_with({"/scene=../scenes/bad.json"}),
              AllOf(HasSubstr("scenes/bad.json: /model: got an unknown key"), HasSubstr("\"models\"")));
}

TEST_F(RenderSpecTest, DegenerateCamerasAreRefused) {
  EXPECT_THAT(error_with({"/camera/look_at_m=[0.278, 0.273, -0.8]"}),
              HasSubstr("/camera/look_at_m: got [0.278,0.273,-0.8], expected a point away"));
  EXPECT_THAT(error_with({"/camera/up=[0, 0, -2]"}),
              HasSubstr("/camera/up: got [0,0,-2], expected a direction that is not parallel"));
  EXPECT_THAT(error_with({"/camera/up=[0, 0, 0]"}), HasSubstr("/camera/up"));
  EXPECT_THAT(error_with({"/camera/look_at_m=[0.278, 5, -0.8]"}),
              HasSubstr("/camera/up: got [0,1,0]"));  // the default up
  EXPECT_THAT(error_with({"/camera/vfov_deg=180"}),
              HasSubstr("/camera/vfov_deg: got 180, expected a number > 0 and < 180"));
  EXPECT_THAT(error_with({"/camera/resolution=[0, 5]"}), HasSubstr("/camera/resolution/0: got 0"));
  EXPECT_THAT(error_with({"/camera/resolution=[16385, 5]"}), HasSubstr("/camera/resolution/0: got 16385"));
  EXPECT_THAT(error_with({"/camera/gaze=fixed"}),
              HasSubstr("/camera/gaze: got \"fixed\", expected one of \"camera\", \"foveal\""));
}

TEST_F(RenderSpecTest, MethodsTakeTheirOwnMembersOnly) {
  const RenderSpec predicted =
      read_with({"/method={\"type\": \"predict\", \"samples_per_pixel\": 256, \"oversampling\": 2}"});
  EXPECT_EQ(predicted.method, RenderMethod::Predict);
  EXPECT_EQ(predicted.ray_model, std::nullopt);
  EXPECT_EQ(predicted.samples_per_pixel, 256u);
  EXPECT_EQ(predicted.prediction.oversampling, 2);
  EXPECT_THAT(error_with({"/method={\"type\": \"predict\", \"ray_model\": \"pinhole\"}"}),
              HasSubstr("/method/ray_model: got \"pinhole\""));
  EXPECT_THAT(error_with({"/method/oversampling=1"}), HasSubstr("/method/oversampling: got 1"));
  EXPECT_THAT(error_with({"/method={\"type\": \"path_trace\"}"}), HasSubstr("/method: got no \"ray_model\""));
  EXPECT_THAT(error_with({"/method/samples_per_pixel=0"}),
              HasSubstr("/method/samples_per_pixel: got 0, expected an integer from 1 to 16777216"));
}

TEST_F(RenderSpecTest, ACameraHasOneAccommodation) {
  EXPECT_THAT(error_with({"/eye/accommodation={\"mode\": \"best\", \"amplitude_D\": 2}"}),
              HasSubstr("/eye/accommodation: got mode \"best\""));
  EXPECT_THAT(error_with({"/eye/accommodation={\"mode\": \"relaxed\"}", "/method/ray_model=metalstigmatism"}),
              HasSubstr("got no \"focus_distance_m\""));
  EXPECT_NO_THROW(read_with({"/method/ray_model=metalstigmatism"}));
  // A turning eye may seek its focus, but this model cannot follow it.
  const std::string best = "/eye/accommodation={\"mode\": \"best\", \"amplitude_D\": 2}";
  EXPECT_NO_THROW(read_with({best, "/camera/gaze=foveal"}));
  EXPECT_THAT(error_with({best, "/camera/gaze=foveal", "/method/ray_model=metalstigmatism"}),
              HasSubstr("/eye/accommodation: got no \"focus_distance_m\""));
}

TEST_F(RenderSpecTest, ResolvedSpellsOutAndMeansTheSame) {
  write_text(folder_ / "renders/e.json", document_["eye"].dump());
  const RenderSpec spec = read_with({"/eye=e.json", "/scene=../scenes/s.json"});
  const Json& resolved = *spec.resolved;
  EXPECT_FALSE(resolved.contains("$schema"));
  EXPECT_EQ(resolved["eye"]["pupil_diameter_mm"], 40);
  EXPECT_EQ(resolved["eye"]["rotation_center_mm"], 13.5);
  EXPECT_EQ(resolved["scene"], "../scenes/s.json");
  EXPECT_EQ(resolved["camera"]["up"], (Json{0, 1, 0}));
  const Json skip{{"scalar_power", true},      {"zero_pupil", true},      {"sharp_pixels", true},
                  {"refraction", true},        {"surface_models", true},  {"shading_frames", true},
                  {"environment_light", true}, {"unseen_emitters", true}, {"converged_tiles", true},
                  {"same_views", true},        {"sharp_spots", true}};
  EXPECT_EQ(resolved["method"], (Json{{"type", "path_trace"},
                                      {"ray_model", "sin2_radial"},
                                      {"samples_per_pixel", 64},
                                      {"max_bounces", 16},
                                      {"guide_emitters", true},
                                      {"sampler", "sobol"},
                                      {"sampling", "uniform_disk"},
                                      {"filter", "box"},
                                      {"sharp_below_px", 0.02},
                                      {"skip", skip}}));
  EXPECT_EQ(resolved["seed"], 1);
  // The defaults of the schema and those of the structs are the same ones.
  const RenderSpec again = read_render_spec(resolved, file_);
  EXPECT_EQ(*again.resolved, resolved);
  EXPECT_EQ(again.samples_per_pixel, spec.samples_per_pixel);
  EXPECT_EQ(again.max_bounces, spec.max_bounces);
  EXPECT_EQ(again.sampler, spec.sampler);
  EXPECT_EQ(again.camera.up, spec.camera.up);
  EXPECT_EQ(again.eye.eye.rotation_center_m, spec.eye.eye.rotation_center_m);
  EXPECT_EQ(again.eye.eye.prescription.vertex_distance_m, spec.eye.eye.prescription.vertex_distance_m);
  EXPECT_EQ(again.seed, spec.seed);
  const RenderSpec predicted = read_with({"/method={\"type\": \"predict\"}"});
  EXPECT_EQ(*read_render_spec(*predicted.resolved, file_).resolved, *predicted.resolved);
}

}  // namespace
}  // namespace sturm
