// Pictures that several entries of an experiment ask for.
#include <gtest/gtest.h>

#include "experiments/run/shared_views.h"

namespace sturm {
namespace {

SceneDescription wall(float distance) {
  SceneDescription scene;
  scene.materials = {Material{}};
  Mesh mesh;
  mesh.positions = {{-1.0f, -1.0f, -distance}, {1.0f, -1.0f, -distance}, {0.0f, 1.0f, -distance}};
  mesh.triangles = {{0, 1, 2}};
  scene.meshes = {mesh};
  return scene;
}

PictureExperiment image(const std::string& id, const Prescription& rx, const std::vector<RayModel>& models) {
  PictureExperiment image;
  image.id = id;
  image.camera.vfov = 0.5;
  image.camera.width = image.camera.height = 8;
  image.worn.eye = Eye::with(rx, 4e-3);
  image.ray_models = models;
  image.samples_per_pixel = 4;
  image.replicates = 2;
  return image;
}

struct Asked {
  SharedViews views;
  int made = 0;

  Asked(const ExperimentSpec& spec, const std::vector<SceneDescription>& scenes) : views(spec, scenes) {}

  std::string ask(std::size_t index, RayModel model, const std::string& name) {
    return views
        .get(index, model,
             [&] {
               ++made;
               return SharedViews::View{{}, 1.0, name};
             })
        ->made_for;
  }
};

TEST(SharedViews, ModelsWithTheSameRaysAndImagesThatCoincide) {
  ExperimentSpec spec;
  spec.pictures = {image("a", {-2.0}, {RayModel::power_matrix, RayModel::thin_lens, RayModel::sin2_radial}),
                   image("b", {-2.0}, {RayModel::thin_lens})};
  Asked asked(spec, {wall(2.0f), wall(2.0f)});
  EXPECT_EQ(asked.ask(0, RayModel::power_matrix, "a/power_matrix"), "a/power_matrix");
  EXPECT_EQ(asked.ask(0, RayModel::thin_lens, "a/thin_lens"), "a/power_matrix");
  EXPECT_EQ(asked.ask(0, RayModel::sin2_radial, "a/sin2_radial"), "a/sin2_radial");  // equal to rounding only
  EXPECT_EQ(asked.ask(1, RayModel::thin_lens, "b/thin_lens"), "a/power_matrix");
  EXPECT_EQ(asked.made, 2);
}

TEST(SharedViews, WhatDiffersIsMade) {
  ExperimentSpec spec;
  const PictureExperiment first = image("a", {-2.0}, {RayModel::power_matrix});
  spec.pictures.assign(8, first);
  spec.pictures[1].worn.eye = Eye::with({-2.0, -0.25, 10.0}, 4e-3);
  spec.pictures[2].worn.eye = Eye::with({-2.0}, 5e-3);
  spec.pictures[3].worn.eye = Eye::with({-2.0}, 4e-3, FixedAccommodation{0.5, 0.0});
  spec.pictures[4].samples_per_pixel = 8;
  spec.pictures[5].replicates = 3;
  spec.pictures[6].camera.position.x() = 0.1;
  std::vector<SceneDescription> scenes(8, wall(2.0f));
  scenes[7] = wall(2.5f);
  Asked asked(spec, scenes);
  for (std::size_t i = 0; i < spec.pictures.size(); ++i)
    EXPECT_EQ(asked.ask(i, RayModel::power_matrix, std::to_string(i)), std::to_string(i));
}

TEST(SharedViews, TheSwitch) {
  ExperimentSpec spec;
  spec.share_views = false;
  spec.pictures = {image("a", {-2.0}, {RayModel::power_matrix, RayModel::thin_lens})};
  Asked asked(spec, {wall(2.0f)});
  asked.ask(0, RayModel::power_matrix, "first");
  EXPECT_EQ(asked.ask(0, RayModel::thin_lens, "second"), "second");
  EXPECT_EQ(asked.made, 2);
}

}  // namespace
}  // namespace sturm
