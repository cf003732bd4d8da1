#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "experiment_testing.h"
#include "io/specs/experiment/gate_spec.h"
#include "support/source_folder.h"

namespace sturm {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class ExperimentSpecTest : public ExperimentDocumentTest {
 protected:
  ExperimentSpecTest() : ExperimentDocumentTest("experiments/e.json") {
    write_text(folder_ / "gates/g.json", "{}");
    write_text(folder_ / "scenes/s.json", R"({"format": "sturm.scene/1"})");
    document_ = parse_json(R"({
      "format": "sturm.experiment/1", "title": "Check", "seed": 3,
      "ellipses": {
        "prescriptions": [{"id": "P172-OS", "note": "oblique", "sphere_D": -6.75, "cylinder_D": -2.5, "axis_deg": 165, "vertex_distance_mm": 12}, {"id": "plano", "sphere_D": 0}],
        "distances_m": [0.4, "inf"], "pupil_diameters_mm": [3, 6],
        "accommodation": {"mode": "fixed", "focus_distance_m": 1.0},
        "ray_models": ["pinhole", "power_matrix"],
        "rays": {"count": 16384}
      },
      "psfs": [{"id": "p1", "prescription": "plano", "distance_m": 1.0, "pupil_diameter_mm": 4, "ray_models": ["power_matrix"], "resolution": 96, "samples_per_pixel": 2048}],
      "images": [{"id": "i1", "scene": "../scenes/s.json", "prescription": "P172-OS", "pupil_diameter_mm": 5, "accommodation": {"mode": "fixed", "power_D": 1},
                  "camera": {"position_m": [0, 0, 0], "look_at_m": [0, 0, -1], "vfov_deg": 40, "resolution": [64, 32]},
                  "ray_models": ["power_matrix", "sin2_radial"], "samples_per_pixel": 256}],
      "gates": "../gates/g.json", "baseline": "../none.json"
    })",
                           "e.json");
  }
};

TEST_F(ExperimentSpecTest, ReadsAllSections) {
  const ExperimentSpec spec = read_experiment(document_, file_);
  EXPECT_EQ(spec.title, "Check");
  EXPECT_EQ(spec.seed, 3u);
  ASSERT_TRUE(spec.ellipses);
  EXPECT_EQ(spec.ellipses->prescriptions[0].id, "P172-OS");
  EXPECT_EQ(spec.ellipses->prescriptions[0].note, "oblique");
  EXPECT_EQ(spec.ellipses->prescriptions[0].prescription.axis_deg, 165);
  EXPECT_TRUE(std::isinf(spec.ellipses->distances_m[1]));
  EXPECT_DOUBLE_EQ(spec.ellipses->pupil_diameters_m[1], 6e-3);
  EXPECT_EQ(spec.ellipses->rays.count, 16384u);
  EXPECT_EQ(spec.ellipses->rays.replicates, 16);
  ASSERT_EQ(spec.psfs.size(), 1u);
  EXPECT_DOUBLE_EQ(spec.psfs[0].eye.pupil_radius_m, 2e-3);
  EXPECT_EQ(spec.psfs[0].resolution, 96);
  ASSERT_EQ(spec.pictures.size(), 1u);
  EXPECT_EQ(spec.pictures[0].worn.eye.prescription.sphere_D, -6.75);
  EXPECT_EQ(spec.pictures[0].worn.eye.accommodation_for(0.0), 1.0);
  EXPECT_EQ(spec.pictures[0].sharp_samples_per_pixel, 256u);
  EXPECT_EQ(spec.pictures[0].replicates, 2);
  EXPECT_EQ(spec.pictures[0].camera.width, 64);
  EXPECT_EQ(spec.gates, folder_ / "gates/g.json");
  EXPECT_EQ(spec.baseline, folder_ / "none.json");
  EXPECT_EQ(spec.reference, std::nullopt);
  EXPECT_THAT(spec.input_files, ElementsAre((folder_ / "gates/g.json").string(), (folder_ / "scenes/s.json").string()));
  EXPECT_EQ((*spec.resolved)["ellipses"]["rays"]["replicates"], 16);
  EXPECT_EQ((*spec.resolved)["images"][0]["sharp_samples_per_pixel"], 256);
  EXPECT_EQ(*read_experiment(*spec.resolved, file_).resolved, *spec.resolved);
}

TEST_F(ExperimentSpecTest, BothListsOfPicturesAreReadAsOne) {
  document_["agreement"] = parse_json(R"([
    {"id": "i1", "note": "n", "scene": "../scenes/s.json",
     "camera": {"position_m": [0, 0, 0], "look_at_m": [0, 0, -1], "vfov_deg": 40, "resolution": [64, 32], "gaze": "foveal"},
     "eye": {"prescription": {"sphere_D": -1}, "pupil_diameter_mm": 6}, "predictions": ["layered", "multipass"], "passes": 8,
     "samples_per_pixel": 32, "replicates": 3}])",
                                      "e.json");
  const ExperimentSpec spec = read_experiment(document_, file_);
  ASSERT_EQ(spec.pictures.size(), 2u);
  const PictureExperiment &image = spec.pictures[0], &view = spec.pictures[1];
  EXPECT_EQ(image.measures, PictureMeasures::Metrics);
  EXPECT_THAT(image.ray_models, ElementsAre(RayModel::power_matrix, RayModel::sin2_radial));
  ASSERT_EQ(image.predictions.size(), 1u);
  EXPECT_EQ(image.predictions[0].kind, PredictionKind::Ellipses);
  EXPECT_FALSE(image.guide_emitters);
  EXPECT_EQ(view.measures, PictureMeasures::Regions);
  EXPECT_EQ(view.id, "i1");  // unique within its list
  EXPECT_EQ(view.note, "n");
  EXPECT_THAT(view.ray_models, ElementsAre(RayModel::power_matrix));
  ASSERT_EQ(view.predictions.size(), 2u);
  EXPECT_EQ(view.predictions[1].kind, PredictionKind::Multipass);
  EXPECT_EQ(view.predictions[1].passes, 8);
  EXPECT_TRUE(view.guide_emitters);
  EXPECT_EQ(view.worn.eye.prescription.sphere_D, -1.0);
  EXPECT_EQ(view.sharp_samples_per_pixel, 16u);
  EXPECT_EQ(view.replicates, 3);
  EXPECT_THAT(spec.input_files, ElementsAre((folder_ / "gates/g.json").string(), (folder_ / "scenes/s.json").string()));
  EXPECT_THAT(error_with("/agreement/0/predictions/0=ellipses"), HasSubstr("/agreement/0/predictions/0: got"));
  document_["agreement"].push_back(document_["agreement"][0]);
  EXPECT_THAT(input_error([&] { read_experiment(document_, file_); }), HasSubstr("/agreement/1/id: got \"i1\""));
}

TEST_F(ExperimentSpecTest, IdsAreUniqueAndKnown) {
  EXPECT_THAT(error_with("/ellipses/prescriptions/1/id=P172-OS"),
              HasSubstr("/ellipses/prescriptions/1/id: got \"P172-OS\", expected an id that no other"));
  EXPECT_THAT(error_with("/psfs/0/prescription=plane"),
              AllOf(HasSubstr("/psfs/0/prescription: got \"plane\" (did you mean \"plano\"?)"), HasSubstr("P172-OS")));
  EXPECT_THAT(error_with("/psfs/0/id=../p"), HasSubstr("/psfs/0/id: got \"../p\""));
  Json document = document_;
  document.erase("ellipses");
  EXPECT_THAT(input_error([&] { read_experiment(document, file_); }),
              HasSubstr("/psfs/0/prescription: got \"plano\", expected nothing (ids of /ellipses/prescriptions)"));
}

TEST_F(ExperimentSpecTest, ErrorsNameTheirPlace) {
  EXPECT_THAT(error_with("/gates=none.json"), HasSubstr("/gates: got \"none.json\""));
  EXPECT_THAT(error_with("/images/0/accommodation={\"mode\": \"best\", \"amplitude_D\": 1}"),
              HasSubstr("/images/0/accommodation: got mode \"best\""));
  EXPECT_THAT(error_with("/images/0/ray_models/0=metalstigmatism"),
              HasSubstr("/images/0/accommodation: got no \"focus_distance_m\""));
  EXPECT_THAT(error_with("/psfs/0/ray_models/0=metalstigmatism"),
              HasSubstr("/psfs/0/accommodation: got no \"focus_distance_m\""));
  EXPECT_THAT(error_with("/ellipses/rays/replicates=1"), HasSubstr("/ellipses/rays/replicates: got 1"));
  EXPECT_THAT(error_with("/images/0/replicates=1"), HasSubstr("/images/0/replicates: got 1"));
  EXPECT_THAT(error_with("/ellipses/prescriptions/0={\"id\": \"a\", \"sphere_D\": 40, \"vertex_distance_mm\": 25}"),
              HasSubstr("/ellipses/prescriptions/0: got"));
}

class LensStudySpecTest : public ExperimentSpecTest {
 protected:
  LensStudySpecTest() {
    write_text(
        folder_ / "lenses/l.json",
        R"({"format": "sturm.spectacles/1", "single_vision": {"center_thickness_mm": 2, "refractive_index": 1.6}})");
    write_text(folder_ / "map.svg", "<svg xmlns='http://www.w3.org/2000/svg'></svg>");
    for (const char* part : {"ellipses", "psfs", "images"}) document_.erase(part);
    document_["lens_study"] = parse_json(R"({
      "lenses": [{"id": "a", "note": "n", "prescription": {"sphere_D": -2, "cylinder_D": -1, "axis_deg": 30}, "lens": "../lenses/l.json"},
                 {"id": "b", "prescription": {"sphere_D": 0}, "lens": {"center_thickness_mm": 2, "refractive_index": 1.5, "front": {"type": "sphere", "radius_mm": 250}, "back": {"type": "sphere", "radius_mm": 250}}}],
      "eccentricities_deg": [0, 20.5], "directions_deg": [0, 90], "distances_m": [0.25, "inf"], "pupil_diameters_mm": [0.5, 1, 6],
      "accommodation": {"mode": "fixed", "power_D": 1},
      "field": {"lens": "b", "azimuths_deg": [0, 50], "distance_m": 2, "pupil_diameter_mm": 4}
    })",
                                         "study");
    document_["figures"] = parse_json(R"([{"id": "m", "title": "A map", "file": "../map.svg"}])", "figures");
  }
};

TEST_F(LensStudySpecTest, IsRead) {
  const ExperimentSpec spec = read_experiment(document_, file_);
  ASSERT_TRUE(spec.lens_study);
  const LensStudySpec& study = *spec.lens_study;
  EXPECT_EQ(study.lenses[0].note, "n");
  EXPECT_EQ(study.lenses[0].prescription.axis_deg, 30);
  EXPECT_EQ(study.lenses[0].lens.refractive_index, 1.6);
  EXPECT_TRUE(std::holds_alternative<TorusSurface>(study.lenses[0].lens.back));  // made for this eye
  EXPECT_EQ(study.eccentricities_deg[1], 20.5);
  EXPECT_TRUE(std::isinf(study.distances_m[1]));
  EXPECT_DOUBLE_EQ(study.pupil_diameters_m[2], 6e-3);
  EXPECT_DOUBLE_EQ(study.order_small_m, 0.5e-3);
  EXPECT_DOUBLE_EQ(study.order_large_m, 1e-3);
  EXPECT_DOUBLE_EQ(study.rotation_center_m, 13.5e-3);
  EXPECT_EQ(std::get<FixedAccommodation>(study.accommodation).power_D, 1);
  EXPECT_EQ(study.quadrature.radial, 10);
  EXPECT_EQ(study.quadrature.azimuthal, 40);
  ASSERT_TRUE(study.wide_gaze);
  EXPECT_EQ(study.wide_gaze->lens, 1u);
  EXPECT_EQ(study.wide_gaze->azimuths_deg.back(), 50);
  EXPECT_EQ(std::get<FigureFile>(spec.figures[0].drawing).file, folder_ / "map.svg");
  EXPECT_THAT(spec.input_files, ElementsAre((folder_ / "gates/g.json").string(), (folder_ / "lenses/l.json").string(),
                                            (folder_ / "map.svg").string()));
  EXPECT_EQ((*spec.resolved)["lens_study"]["quadrature"]["radial"], 10);
  EXPECT_EQ(*read_experiment(*spec.resolved, file_).resolved, *spec.resolved);
}

TEST_F(LensStudySpecTest, FiguresThatTheRunDraws) {
  write_text(
      folder_ / "lenses/made.json",
      R"({"format": "sturm.spectacles/1", "single_vision": {"prescription": {"sphere_D": 1}, "center_thickness_mm": 2, "refractive_index": 1.6}})");
  const auto figure = [&](const std::string& drawing) {
    Json document = document_;
    document["figures"] = Json::array({Json::parse(R"({"id": "f", "title": "F")" + drawing + "}")});
    return read_experiment(document, file_).figures.at(0);
  };
  const auto conoid = std::get<SturmConoidFigure>(
      figure(
          R"(, "sturm_conoid": {"eye": {"prescription": {"sphere_D": -2}, "pupil_diameter_mm": 4}, "gaze_deg": [0, 30], "to_m": 0.7})")
          .drawing);
  EXPECT_NEAR(conoid.elevation, 0.52359877559829887, 1e-16);
  EXPECT_EQ(conoid.end_m, 0.7);
  EXPECT_FALSE(conoid.spectacles);
  const auto maps = std::get<DefocusMapsFigure>(
      figure(R"(, "defocus_maps": {"lenses": ["../lenses/made.json"], "distance_m": "inf"})").drawing);
  EXPECT_EQ(maps.names, std::vector<std::string>{"made"});
  EXPECT_TRUE(std::isinf(maps.distance_m));
  EXPECT_THAT(input_error([&] { figure(""); }), HasSubstr("/figures/0: got"));
  EXPECT_THAT(input_error([&] { figure(R"(, "file": "map.svg", "lens_maps": {"lens": "../lenses/made.json"})"); }),
              HasSubstr("exactly one of"));
  EXPECT_THAT(input_error([&] { figure(R"(, "lens_maps": {"lens": "../lenses/l.json"})"); }), HasSubstr("no eye here"));
  EXPECT_THAT(input_error([&] { figure(R"(, "ellipse_layers": "none.json")"); }),
              HasSubstr("/figures/0/ellipse_layers"));
}

TEST_F(LensStudySpecTest, ErrorsNameTheirPlace) {
  EXPECT_THAT(error_with("/lens_study/field/lens=c"),
              AllOf(HasSubstr("/lens_study/field/lens: got \"c\""), HasSubstr("\"a\", \"b\"")));
  EXPECT_THAT(error_with("/lens_study/pupil_diameters_mm=[1, 0.5]"),
              HasSubstr("/lens_study/pupil_diameters_mm/1: got 0.5"));
  EXPECT_THAT(error_with("/lens_study/order_pupil_diameters_mm=[0.5, 3]"),
              HasSubstr("/lens_study/order_pupil_diameters_mm/1: got 3"));
  EXPECT_THAT(error_with("/lens_study/accommodation={\"mode\": \"best\", \"amplitude_D\": 1}"),
              HasSubstr("/lens_study/accommodation: got"));
  EXPECT_THAT(error_with("/lens_study/lenses/1/lens=null"), HasSubstr("/lens_study/lenses/1/lens: got null"));
  EXPECT_THAT(error_with("/lens_study/lenses/1/id=a"), HasSubstr("/lens_study/lenses/1/id: got \"a\""));
  EXPECT_THAT(error_with("/figures/0/file=none.svg"), HasSubstr("/figures/0/file: got \"none.svg\""));
  EXPECT_THAT(error_with("/figures/0/id=lens_study_x"), HasSubstr("/figures/0/id: got \"lens_study_x\""));
}

TEST(GateSpec, ReadsAllComparisons) {
  const Json document = parse_json(R"({"format": "sturm.gates/1", "gates": [
    {"id": "a", "title": "t", "statistic": "s", "comparison": "at_most", "bound": 4, "unit": "σ", "reason": "r"},
    {"id": "b", "title": "t", "statistic": "s", "comparison": "at_least", "bound": 0.5, "reason": "r"},
    {"id": "c", "title": "t", "statistic": "s", "comparison": "differs", "bound": 4, "reason": "r"},
    {"id": "d", "title": "t", "statistic": "s", "comparison": "baseline", "bound": 4, "reason": "r"},
    {"id": "e", "title": "t", "statistic": "s", "comparison": "must_fail", "bound": 4, "reason": "r"}]})",
                                   "g.json");
  const std::vector<GateSpec> gates = read_gates(document, "g.json");
  ASSERT_EQ(gates.size(), 5u);
  EXPECT_EQ(gates[0].unit, "σ");
  EXPECT_EQ(gates[1].bound, 0.5);
  EXPECT_EQ(gates[1].unit, "");
  for (std::size_t i = 0; i < gates.size(); ++i)
    EXPECT_EQ(std::string(entry_of(gates[i].kind).file_word), document["gates"][i]["comparison"]);
  Json twice = document;
  twice["gates"][3]["id"] = "a";
  EXPECT_THAT(input_error([&] { read_gates(twice, "g.json"); }), HasSubstr("g.json: /gates/3/id: got \"a\""));
}

/// A gate with what its bound was calibrated on; `changes` is a merge patch.
Json calibrated_gates(const char* changes = "{}") {
  Json gate =
      parse_json(R"({"id": "a", "title": "t", "statistic": "s", "comparison": "at_most", "bound": 4, "reason": "r",
                             "level": 1e-4, "tolerance": {"value": 0.5, "reason": "edges"}, "noise": {"standard_deviation": 0.25, "source": "20 seeds"}})",
                 "g.json");
  gate.merge_patch(parse_json(changes, "g.json"));
  return {{"format", "sturm.gates/1"}, {"gates", {gate}}};
}

TEST(GateSpec, ReadsAndWritesACalibration) {
  const GateSpec gate = read_gates(calibrated_gates(), "g.json").at(0);
  ASSERT_TRUE(gate.calibration);
  EXPECT_EQ(gate.calibration->level, 1e-4);
  EXPECT_EQ(gate.calibration->tolerance.value, 0.5);
  EXPECT_EQ(gate.calibration->tolerance.reason, "edges");
  EXPECT_EQ(gate.calibration->noise.standard_deviation, 0.25);
  EXPECT_EQ(gate.calibration->noise.source, "20 seeds");
  Json written = calibrated_gates()["gates"][0];
  written.update(calibration_json(gate.calibration));
  EXPECT_EQ(written, calibrated_gates()["gates"][0]);
  EXPECT_NO_THROW(require_calibrated({gate}, "g.json"));
}

TEST(GateSpec, WhatNobodyMeasuredIsNull) {
  Json document = calibrated_gates();
  document["gates"][0]["level"] = nullptr;
  document["gates"][0]["noise"]["standard_deviation"] = nullptr;
  const GateSpec gate = read_gates(document, "g.json").at(0);
  EXPECT_FALSE(gate.calibration->level);
  EXPECT_FALSE(gate.calibration->noise.standard_deviation);
  EXPECT_TRUE(calibration_json(gate.calibration)["level"].is_null());
}

TEST(GateSpec, RefusesHalfACalibrationAndChanceWithoutNoise) {
  EXPECT_THAT(input_error([] { read_gates(calibrated_gates(R"({"noise": null})"), "g.json"); }),
              HasSubstr("g.json: /gates/0: got"));
  EXPECT_THAT(input_error([] { read_gates(calibrated_gates(R"({"noise": {"standard_deviation": 0}})"), "g.json"); }),
              HasSubstr("g.json: /gates/0/level: got"));
  EXPECT_NO_THROW(read_gates(calibrated_gates(R"({"level": 0, "noise": {"standard_deviation": 0}})"), "g.json"));
  EXPECT_THAT(input_error([] { read_gates(calibrated_gates(R"({"level": 1})"), "g.json"); }),
              HasSubstr("/gates/0/level: got 1"));
  EXPECT_THAT(input_error([] { read_gates(calibrated_gates(R"({"tolerance": {"value": -1}})"), "g.json"); }),
              HasSubstr("/gates/0/tolerance/value: got -1"));
  const Json plain =
      calibrated_gates(R"({"level": null, "tolerance": null, "noise": null})");  // RFC 7396: takes them away
  EXPECT_THAT(input_error([&] { require_calibrated(read_gates(plain, "g.json"), "g.json"); }),
              HasSubstr("g.json: /gates/0: got \"a\""));
}

TEST(GateSpec, EveryShippedGateSaysWhatItWasCalibratedOn) {
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(STURM_SOURCE_DIR "/configs/gates")) {
    const std::string file = entry.path().string();
    EXPECT_NO_THROW(require_calibrated(read_gates(load_json(file), file), file));
    ++files;
  }
  EXPECT_GE(files, 8);
}

}  // namespace
}  // namespace sturm
