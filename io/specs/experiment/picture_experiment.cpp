#include "io/specs/experiment/picture_experiment.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "io/files/error.h"
#include "io/json/unique_ids.h"
#include "io/specs/words.h"
#include "lensmodel/units.h"

namespace sturm {

namespace {

void append(std::vector<std::string>& files, const std::vector<std::string>& more) {
  files.insert(files.end(), more.begin(), more.end());
}

/// What both lists have.
PictureExperiment read_view(const Json& value, const Source& where, PictureMeasures measures) {
  PictureExperiment view;
  view.measures = measures;
  view.id = value["id"].get<std::string>();
  view.note = value.value("note", "");
  view.scene_name = value["scene"].get<std::string>();
  view.scene = read_scene(value["scene"], where / "scene");
  append(view.input_files, view.scene.input_files);
  view.camera = read_camera(value["camera"], where / "camera");
  view.samples_per_pixel = value["samples_per_pixel"].get<std::uint64_t>();
  view.replicates = value.value("replicates", view.replicates);
  view.max_bounces = value.value("max_bounces", view.max_bounces);
  return view;
}

/// An entry of "images".
PictureExperiment read_image(const Json& value, const Source& where, const PrescriptionNamed& prescription) {
  PictureExperiment image = read_view(value, where, PictureMeasures::Metrics);
  require_plain_camera(value["camera"], where / "camera", "an experiment");
  image.prescription = value["prescription"].get<std::string>();
  const Accommodation accommodation = value.contains("accommodation")
                                          ? read_accommodation(value["accommodation"], where / "accommodation")
                                          : Accommodation{};
  image.worn.eye = make_eye(prescription(value["prescription"], where / "prescription"),
                            metres_per_millimetre * value["pupil_diameter_mm"].get<double>(), accommodation, where);
  image.ray_models = read_words(value["ray_models"], where / "ray_models", ray_model_words);
  for (const RayModel ray_model : image.ray_models)
    require_camera_accommodation(image.worn.eye.accommodation, ray_model, where / "accommodation");
  image.predictions = {PredictionSpec{.kind = PredictionKind::Ellipses}};
  image.sharp_samples_per_pixel = value.value("sharp_samples_per_pixel", image.samples_per_pixel);
  image.guide_emitters = value.value("guide_emitters", image.guide_emitters);
  return image;
}

/// One of the predictions of a view: an object, or a word about which the view says the rest.
Json prediction_object(const Json& one, const Json& view) {
  Json object = one.is_object() ? one : Json{{"prediction", one}};
  object["oversampling"] = view.value("oversampling", 1);
  if (object["prediction"] == "multipass") object["passes"] = view.value("passes", 64);
  if (one == "depth_psf") object["psf"] = view.value("psf", "rays");
  return object;
}

std::vector<PredictionSpec> read_predictions(const Json& value, const Source& where, const WornEye& worn,
                                             bool plain_view) {
  std::vector<PredictionSpec> predictions;
  const Json& list = value["predictions"];
  for (std::size_t i = 0; i < list.size(); ++i) {
    const Source place = where / "predictions" / i;
    const PredictionSpec one = read_prediction(prediction_object(list[i], value), place);
    const bool plain_only = one.kind == PredictionKind::Ellipses || one.kind == PredictionKind::DepthPsf;
    if (plain_only && !plain_view) place.fail(list[i], "\"layered\" or \"multipass\" for a turning eye or spectacles");
    require_pupil(one, worn.eye, where / "eye");
    for (const PredictionSpec& other : predictions)
      if (name_of(other.kind, other.psf) == name_of(one.kind, one.psf)) place.fail(list[i], "each prediction once");
    predictions.push_back(one);
  }
  return predictions;
}

bool is_by_rays(const PredictionSpec& prediction) {
  return prediction.kind == PredictionKind::DepthPsf && prediction.psf == SeenPsf::Rays;
}

/// An entry of "agreement".
PictureExperiment read_regions(const Json& value, const Source& where) {
  PictureExperiment view = read_view(value, where, PictureMeasures::Regions);
  if (view.camera.projection != Projection::Perspective)
    (where / "camera" / "projection").fail(value["camera"]["projection"], "\"perspective\" for an experiment");
  if (view.camera.interpupillary_distance_m)
    (where / "camera" / "stereo").fail(value["camera"]["stereo"], "no stereo pair for an experiment");
  const WornEyeSpec worn = read_worn_eye(value, where);
  append(view.input_files, worn.input_files);
  view.worn = worn.worn;
  const bool foveal = view.camera.gaze == Gaze::Foveal;
  if (!foveal) require_camera_accommodation(view.worn.eye.accommodation, std::nullopt, where / "eye" / "accommodation");
  view.ray_models = {word_or(value, "ray_model", RayModel::power_matrix, where, ray_model_words)};
  view.predictions = read_predictions(value, where, view.worn, !foveal && !view.worn.spectacles);
  view.layer_sum = value.value("layer_sum", view.layer_sum);
  if (view.layer_sum && std::ranges::none_of(view.predictions, is_by_rays))
    (where / "layer_sum").fail(value["layer_sum"], "a prediction \"depth_psf\" by rays, whose layers are summed");
  view.sharp_samples_per_pixel = value.value("sharp_samples_per_pixel", view.sharp_samples_per_pixel);
  view.guide_emitters = true;
  return view;
}

}  // namespace

std::vector<PictureExperiment> read_pictures(const Json& document, const Source& root,
                                             const PrescriptionNamed& prescription) {
  std::vector<PictureExperiment> pictures;
  for (const PictureMeasures measures : picture_measures) {
    const Source where = root / list_name(measures);
    const Json list = document.value(list_name(measures), Json::array());
    require_unique_ids(list, where);
    for (std::size_t i = 0; i < list.size(); ++i)
      pictures.push_back(measures == PictureMeasures::Metrics ? read_image(list[i], where / i, prescription)
                                                              : read_regions(list[i], where / i));
  }
  return pictures;
}

}  // namespace sturm
