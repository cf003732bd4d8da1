#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "experiment_testing.h"

namespace sturm {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class SamplingStudySpecTest : public ExperimentDocumentTest {
 protected:
  SamplingStudySpecTest() : ExperimentDocumentTest("e.json") {
    write_text(folder_ / "g.json", "{}");
    write_text(folder_ / "s.json", R"({"format": "sturm.scene/1"})");
    document_ = parse_json(R"({
      "format": "sturm.experiment/1", "title": "Samplings", "gates": "g.json",
      "sampling_study": {
        "scene": "s.json", "pupil_diameter_mm": 40, "accommodation": {"mode": "fixed", "focus_distance_m": 1.6},
        "camera": {"position_m": [0, 0, 0], "look_at_m": [0, 0, -1], "vfov_deg": 40, "resolution": [64, 32]},
        "configurations": [{"id": "sharp", "prescription": {"sphere_D": 0}, "ray_model": "pinhole"},
                           {"id": "astigmat", "prescription": {"sphere_D": -1, "cylinder_D": -2, "axis_deg": 30}, "ray_model": "metalstigmatism"}],
        "samplings": ["uniform_disk", "rings"], "rings": {"count": 4}, "samplers": ["halton", "sobol"], "samples_per_pixel": 16
      }})",
                           "e.json");
  }
};

TEST_F(SamplingStudySpecTest, ReadsEverything) {
  const ExperimentSpec spec = read_experiment(document_, file_);
  ASSERT_TRUE(spec.sampling_study);
  const SamplingStudySpec& study = *spec.sampling_study;
  EXPECT_EQ(study.scene_name, "s.json");
  EXPECT_THAT(spec.input_files, ::testing::Contains((folder_ / "s.json").string()));
  ASSERT_EQ(study.configurations.size(), 2u);
  EXPECT_EQ(study.configurations[1].ray_model, RayModel::metalstigmatism);
  EXPECT_EQ(study.configurations[1].eye.prescription.axis_deg, 30);
  EXPECT_DOUBLE_EQ(study.configurations[0].eye.pupil_radius_m, 0.02);
  ASSERT_EQ(study.samplings.size(), 2u);
  EXPECT_EQ(study.samplings[1].kind, PupilSampling::Rings);
  EXPECT_EQ(study.samplings[1].rings, 4);
  EXPECT_EQ(study.samplings[1].angle_factor, 6);
  EXPECT_THAT(study.samplers, ElementsAre(Sequence::Halton, Sequence::Sobol));
  EXPECT_EQ(study.samples_per_pixel, 16u);
  EXPECT_EQ(study.replicates, 8);
  EXPECT_EQ((*spec.resolved)["sampling_study"]["replicates"], 8);
}

TEST_F(SamplingStudySpecTest, WrongValuesNameTheirPlace) {
  EXPECT_THAT(error_with("/sampling_study/configurations/1/id=sharp"),
              HasSubstr("/sampling_study/configurations/1/id"));
  EXPECT_THAT(error_with(R"(/sampling_study/accommodation={"mode": "relaxed"})"), HasSubstr("focus_distance_m"));
  EXPECT_THAT(error_with(R"(/sampling_study/accommodation={"mode": "best", "amplitude_D": 3})"),
              HasSubstr("camera gaze"));
  EXPECT_THAT(error_with("/sampling_study/replicates=2"), HasSubstr("/sampling_study/replicates"));
  EXPECT_THAT(error_with("/sampling_study/samplings/0=disk"), HasSubstr("/sampling_study/samplings/0"));
  EXPECT_THAT(error_with("/sampling_study/scene=none.json"), HasSubstr("/sampling_study/scene"));
  EXPECT_THAT(error_with("/sampling_study/camera/gaze=foveal"), HasSubstr("a sampling study"));
}

}  // namespace
}  // namespace sturm
